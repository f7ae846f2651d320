#include "occt/body_shape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>

#include "occt/labelled_booleans.h"
#include "occt/nurbs_geometry.h"
#include "occt/ring_edges.h"
#include "occt/tube_surface.h"

namespace dupin::occt {
namespace {

using exchange::Body;
using exchange::RingCurve;

// Of the rings in which a hub's sphere and its arms meet; both have them within rounding.
constexpr double kSewing = 1e-5;

struct LabelledFace {
  TopoDS_Face face;
  std::uint32_t label = 0;
};

// The ball about these axes' origin less what is beyond the circles' planes.
TopoDS_Shape cut_ball(const gp_Ax2& axes, double radius, std::span<const RingCurve> cuts,
                      const std::string& at) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(axes, radius).Shape();
  if (cuts.empty()) {
    return ball;
  }
  TopTools_ListOfShape balls, caps;
  balls.Append(ball);
  for (const RingCurve& circle : cuts) {
    caps.Append(
        BRepPrimAPI_MakeCylinder(gp_Ax2(pnt(circle.center), dir(circle.normal), dir(circle.axis)),
                                 3 * radius, 3 * radius)
            .Shape());
  }
  BRepAlgoAPI_Cut cut;
  cut.SetArguments(balls);
  cut.SetTools(caps);
  cut.Build();
  if (!cut.IsDone() || cut.HasErrors()) {
    throw Refusal("OpenCASCADE does not cut a ball", at);
  }
  return cut.Shape();
}

class BodyShape {
 public:
  explicit BodyShape(const Body& body) : body_(body), surfaces_(body.tubes.size()) {
    rings_.reserve(body.rings.size());
    for (const RingCurve& ring : body.rings) {
      rings_.emplace_back(ring);
    }
  }

  LabelledShape run() {
    place_seams();
    for (RingEdges& ring : rings_) {
      ring.make();
    }
    for (std::size_t i = 0; i < body_.tubes.size(); ++i) {
      const exchange::TubeFace& tube = body_.tubes[i];
      faces_.push_back({is_flat(tube)
                            ? flat_rim(tube)
                            : tube_face(tube, *surfaces_[i], rings_[tube.start], rings_[tube.end]),
                        tube.label});
    }
    for (const exchange::DiscFace& disc : body_.discs) {
      faces_.push_back({planar_face({&rings_[disc.ring]}, disc.outward), disc.label});
    }
    for (const exchange::HubFace& hub : body_.hubs) {
      append_hub(hub);
    }
    return body_.hubs.empty() ? joined() : sewn();
  }

 private:
  [[nodiscard]] bool is_flat(const exchange::TubeFace& tube) const {
    const RingCurve &from = body_.rings[tube.start], &to = body_.rings[tube.end];
    return std::holds_alternative<exchange::Rim>(tube.surface) &&
           (from.center - to.center).norm() < Precision::Confusion();
  }

  [[nodiscard]] TubeSurface surface_of(const exchange::TubeFace& tube, double seam) const {
    return tube_surface(tube, body_.rings[tube.start], body_.rings[tube.end], seam);
  }

  // Seams that can be anywhere go where others end.
  void place_seams() {
    for (const bool is_free : {false, true}) {
      for (std::size_t i = 0; i < body_.tubes.size(); ++i) {
        const exchange::TubeFace& tube = body_.tubes[i];
        if (is_flat(tube) || has_free_seam(tube) != is_free) {
          continue;
        }
        const TubeSurface& made = surfaces_[i].emplace(surface_of(tube, free_seam(tube)));
        rings_[tube.start].add_seam(angle_at(made, tube.start, made.start));
        rings_[tube.end].add_seam(angle_at(made, tube.end, made.end));
      }
    }
  }

  // The angle of the start ring at which the tube's seam is to be.
  [[nodiscard]] double free_seam(const exchange::TubeFace& tube) const {
    const RingEdges &start = rings_[tube.start], &end = rings_[tube.end];
    if (start.has_seam() || !end.has_seam()) {
      return start.has_seam() ? start.seam() : 0;
    }
    const RingCurve& ring = end.ring();
    const Vec3 across = ring.normal.cross(ring.axis);
    const Vec3 radial = std::cos(end.seam()) * ring.axis + std::sin(end.seam()) * across;
    return angle_on(start.ring(), start.ring().center + radial);
  }

  [[nodiscard]] double angle_at(const TubeSurface& tube, std::size_t ring, double along) const {
    return angle_on(body_.rings[ring], vec(tube.at(tube.seam, along)));
  }

  // Bounded by the first ring, with holes at the others.
  [[nodiscard]] static TopoDS_Face planar_face(const std::vector<const RingEdges*>& rings,
                                               const Vec3& outward) {
    const BRep_Builder builder;
    TopoDS_Face face;
    const RingCurve& outer = rings.front()->ring();
    // The ring's normal exactly, as both may differ by rounding.
    const bool along = outer.normal.dot(outward) > 0;
    builder.MakeFace(
        face, new Geom_Plane(pnt(outer.center), dir(along ? outer.normal : Vec3(-outer.normal))),
        Precision::Confusion());
    for (const RingEdges* ring : rings) {
      const bool is_outer = ring == rings.front();
      const bool forward = (ring->ring().normal.dot(outward) > 0) == is_outer;
      TopoDS_Wire wire;
      builder.MakeWire(wire);
      const std::size_t count = ring->arcs().size();
      for (std::size_t i = 0; i < count; ++i) {
        const TopoDS_Edge& edge = ring->arcs()[forward ? i : count - 1 - i].edge;
        builder.Add(wire, edge.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED));
      }
      wire.Closed(true);
      builder.Add(face, wire);
    }
    return face;
  }

  [[nodiscard]] TopoDS_Face flat_rim(const exchange::TubeFace& tube) const {
    return planar_face({&rings_[tube.start], &rings_[tube.end]},
                       std::get<exchange::Rim>(tube.surface).outward);
  }

  // The ball less what is beyond the rings' planes.
  void append_hub(const exchange::HubFace& hub) {
    std::vector<RingCurve> cuts;
    for (const std::size_t ring : hub.rings) {
      RingCurve& circle = cuts.emplace_back(body_.rings[ring]);
      if (circle.normal.dot(circle.center - hub.center) < 0) {
        circle.normal = -circle.normal;
      }
    }
    const TopoDS_Shape ball =
        cut_ball(gp_Ax2(pnt(hub.center), gp::DZ(), gp::DX()), hub.radius, cuts, body_.name);
    for (TopExp_Explorer face(ball, TopAbs_FACE); face.More(); face.Next()) {
      const TopoDS_Face& here = TopoDS::Face(face.Current());
      if (BRep_Tool::Surface(here)->IsKind(STANDARD_TYPE(Geom_SphericalSurface))) {
        faces_.push_back({here, hub.label});
      }
    }
  }

  [[nodiscard]] static TopoDS_Shape solid_from(const TopoDS_Shell& shell) {
    const BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    GProp_GProps properties;
    (void)BRepGProp::VolumeProperties(solid, properties, 1e-3);
    if (properties.Mass() < 0) {
      builder.MakeSolid(solid);
      builder.Add(solid, shell.Reversed());
    }
    return solid;
  }

  [[nodiscard]] LabelledShape joined() const {
    const BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    LabelledShape result;
    for (const LabelledFace& face : faces_) {
      builder.Add(shell, face.face);
      result.labels.Bind(face.face, face.label);
    }
    shell.Closed(true);
    result.shape = solid_from(shell);
    return result;
  }

  [[nodiscard]] LabelledShape sewn() const {
    BRepBuilderAPI_Sewing sewing(kSewing);
    for (const LabelledFace& face : faces_) {
      sewing.Add(face.face);
    }
    sewing.Perform();
    TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL);
    if (faces_.size() == 1 && !shells.More()) {
      return joined();
    }
    if (!shells.More() || sewing.NbFreeEdges() > 0) {
      throw Refusal("OpenCASCADE does not sew the hub to its arms: " +
                        std::to_string(sewing.NbFreeEdges()) + " edges stay open",
                    body_.name);
    }
    LabelledShape result;
    for (const LabelledFace& face : faces_) {
      const TopoDS_Shape now =
          sewing.IsModified(face.face) ? sewing.Modified(face.face) : TopoDS_Shape(face.face);
      for (TopExp_Explorer part(now, TopAbs_FACE); part.More(); part.Next()) {
        result.labels.Bind(part.Current(), face.label);
      }
    }
    TopoDS_Shell shell = TopoDS::Shell(shells.Current());
    shell.Closed(true);
    result.shape = solid_from(shell);
    return result;
  }

  const Body& body_;
  std::vector<RingEdges> rings_;
  std::vector<std::optional<TubeSurface>> surfaces_;
  std::vector<LabelledFace> faces_;
};

LabelledShape shape_of(const exchange::BallSector& sector, const std::string& at) {
  const gp_Ax2 axes(pnt(sector.center), dir(sector.pole), dir(sector.seam));
  LabelledShape result;
  result.shape = cut_ball(axes, sector.radius, sector.cuts, at);
  for (TopExp_Explorer face(result.shape, TopAbs_FACE); face.More(); face.Next()) {
    result.labels.Bind(face.Current(), sector.label);
  }
  return result;
}

// What hangs together by rings, each with the rings of all.
std::vector<Body> closed_surfaces(const Body& body) {
  std::vector<std::size_t> leader(body.rings.size());
  std::iota(leader.begin(), leader.end(), std::size_t{0});
  const auto join = [&](std::size_t a, std::size_t b) {
    const auto [first, second] = std::minmax({leader[a], leader[b]});
    std::ranges::replace(leader, second, first);
  };
  for (const exchange::TubeFace& tube : body.tubes) {
    join(tube.start, tube.end);
  }
  for (const exchange::HubFace& hub : body.hubs) {
    for (const std::size_t ring : hub.rings) {
      join(hub.rings.front(), ring);
    }
  }
  // Balls by themselves, then the others by their first ring.
  std::vector<Body> result;
  std::map<std::size_t, Body> surfaces;
  for (const exchange::TubeFace& tube : body.tubes) {
    surfaces[leader[tube.start]].tubes.push_back(tube);
  }
  for (const exchange::DiscFace& disc : body.discs) {
    surfaces[leader[disc.ring]].discs.push_back(disc);
  }
  for (const exchange::HubFace& hub : body.hubs) {
    Body& surface = hub.rings.empty() ? result.emplace_back() : surfaces[leader[hub.rings.front()]];
    surface.hubs.push_back(hub);
  }
  for (auto& [ring, surface] : surfaces) {
    result.push_back(std::move(surface));
  }
  for (Body& surface : result) {
    surface.name = body.name;
    surface.rings = body.rings;
  }
  return result;
}

}  // namespace

LabelledShape solid_of(const Body& body) {
  std::vector<LabelledShape> shapes;
  for (const Body& surface : closed_surfaces(body)) {
    shapes.push_back(BodyShape(surface).run());
  }
  for (const exchange::BallSector& sector : body.sectors) {
    shapes.push_back(shape_of(sector, body.name));
  }
  return fused(shapes, body.name, "its own pieces");
}

}  // namespace dupin::occt
