#include "assembly/outward_shape.h"

#include <algorithm>
#include <array>

namespace dupin::assembly {
namespace {

struct Outward {
  double by;

  void grow(std::optional<double>& length) const {
    if (length) {
      *length += by;
    }
  }
  void grow(std::optional<SectionAxes>& axes) const {
    if (axes) {
      axes->across += by;
    }
  }
  void grow(PartStart& start) const {
    if (auto* place = std::get_if<Place>(&start)) {
      place->radius += by;
      grow(place->axes);
    }
  }
  void grow(RingedBlendEnd& end) const {
    if (auto* free = std::get_if<FreeEnd>(&end)) {
      free->radius += by;
    }
  }
  void grow(std::vector<Waypoint>& through) const {
    for (Waypoint& waypoint : through) {
      waypoint.radius += by;
    }
  }

  void operator()(PipeBetween& pipe) const {
    pipe.radius += by;
    grow(pipe.axes);
  }
  void operator()(PipeAlong& pipe) const { grow(pipe.from); }
  void operator()(PipeTo& /*pipe*/) const {}
  void operator()(PipeOn& pipe) const { pipe.radius += by; }
  void operator()(ConeBetween& cone) const {
    cone.start_radius += by;
    cone.end_radius += by;
    grow(cone.start_axes);
    grow(cone.end_across);
  }
  void operator()(ConeAlong& cone) const {
    grow(cone.from);
    cone.end_radius += by;
    grow(cone.end_across);
  }
  void operator()(ObliqueBetween& part) const {
    part.start_radius += by;
    part.end_radius += by;
  }
  void operator()(ObliqueTo& part) const { part.end_radius += by; }
  void operator()(ElbowTurning& elbow) const { grow(elbow.from); }
  void operator()(ElbowTo& elbow) const { grow(elbow.from); }
  void operator()(ElbowCorner& elbow) const { grow(elbow.from); }
  void operator()(SphereAt& sphere) const { sphere.radius += by; }
  void operator()(SplineBetween& spline) const { grow(spline.through); }
  void operator()(SplineRound& spline) const { grow(spline.through); }
  void operator()(CyclicBlendBetween& /*blend*/) const {}
  void operator()(TwoConeBlendBetween& /*blend*/) const {}
  void operator()(RingedBlendBetween& blend) const {
    grow(blend.from);
    grow(blend.to);
  }
  void operator()(CyclideBlendBetween& /*blend*/) const {}
  void operator()(CyclideChainThrough& chain) const {
    for (PeVector& sphere : chain.spheres) {
      sphere.r += by;
    }
  }
  void operator()(FilletBetween& /*fillet*/) const {}
  void operator()(CopeOfEnd& /*cope*/) const {}
  void operator()(JunctionOfPorts& junction) const { grow(junction.options.radius); }
  void operator()(FlangeAt& /*flange*/) const {}
  void operator()(FlangeOfEnd& /*flange*/) const {}
  void operator()(FlangeOn& /*flange*/) const {}
  void operator()(EllipsoidalHead& head) const {
    grow(head.from);
    grow(head.depth);
  }
  void operator()(TorisphericalHead& head) const {
    grow(head.from);
    head.crown += by;
    head.knuckle += by;
  }
  void operator()(CapAt& /*cap*/) const {}
};

}  // namespace

double outward_distance(const Assembly& assembly, const Part& part) {
  // What has the wall of others, or none.
  constexpr std::array<std::string_view, 4> kWithout{"fillet", "cope", "cap", "flange"};
  const WallSide side = part.wall_side.value_or(assembly.wall_side);
  if (side == WallSide::inwards || part.solid ||
      std::ranges::find(kWithout, kind(part.shape)) != kWithout.end()) {
    return 0;
  }
  const double wall = part.wall.value_or(assembly.wall.value_or(0));
  return side == WallSide::outwards ? wall : wall / 2;
}

PartShape outward_shape(const PartShape& shape, double distance) {
  PartShape result = shape;
  std::visit(Outward{distance}, result);
  return result;
}

PartShape outer_shape(const Assembly& assembly, std::uint32_t part) {
  const Part& own = assembly.parts.at(part);
  return outward_shape(own.shape, outward_distance(assembly, own));
}

}  // namespace dupin::assembly
