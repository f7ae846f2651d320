#include "dupin/blends/part_measures.h"

#include <cmath>

#include "dupin/blends/cyclide_tube.h"
#include "surfaces/pieces/piece_measures.h"

namespace dupin {
namespace {

SolidMoments weighted_sum(const SolidMoments& a, const SolidMoments& b, double sign) {
  const double volume = a.volume + sign * b.volume;
  if (volume == 0) {
    return {};
  }
  const Vec3 apart = b.centroid - a.centroid;
  return {
      volume, a.centroid + sign * b.volume / volume * apart,
      a.spread + sign * b.spread + sign * a.volume * b.volume / volume * apart * apart.transpose()};
}

// What the ball of a joint has beyond the disc of the piece before and ahead of that of the piece
// after: it is the ball less what both pieces' caps cut off, if these do not overlap.
void add_joint(const PeArc& before, const PeArc& after, PartMeasures& sum) {
  const SphericalJoint joint = spherical_joint(before, after);
  sum.area += joint.exposed_area;
  if (!joint.is_clean()) {
    sum.solid.reset();
    sum.missing = "its pieces penetrate each other at a joint";
  } else if (sum.solid) {
    const double radius = joint.sphere.r;
    *sum.solid =
        *sum.solid + surfaces::cut_ball(
                         {joint.sphere.m, radius},
                         {{-before.end_tangent().m.normalized(), radius * std::cos(joint.before)},
                          {after.start_tangent().m.normalized(), radius * std::cos(joint.after)}});
  }
}

struct MeasuresOf {
  PartMeasures operator()(const Sphere& sphere) const {
    const SolidMoments solid = surfaces::cut_ball(sphere, {});
    return {3 * solid.volume / sphere.radius, {}, solid, {}};
  }
  PartMeasures operator()(const Chain& chain) const {
    PartMeasures sum{0, 0, SolidMoments(), {}};
    for (const Piece& piece : chain.pieces) {
      const PartMeasures one = surfaces::measures(piece);
      sum.area += one.area;
      *sum.length += *one.length;
      *sum.solid = *sum.solid + *one.solid;
    }
    if (chain.joints == Joints::spherical) {
      sum.length.reset();
      const std::vector<PeArc> arcs = cyclide_pieces(chain);
      for (std::size_t i = 1; i < arcs.size(); ++i) {
        add_joint(arcs[i - 1], arcs[i], sum);
      }
    }
    return sum;
  }
};

}  // namespace

SolidMoments operator+(const SolidMoments& a, const SolidMoments& b) {
  return weighted_sum(a, b, 1);
}

SolidMoments operator-(const SolidMoments& a, const SolidMoments& b) {
  return weighted_sum(a, b, -1);
}

Eigen::Matrix3d inertia(const SolidMoments& solid) {
  return solid.spread.trace() * Eigen::Matrix3d::Identity() - solid.spread;
}

PartMeasures measures(const PartSurface& surface) { return std::visit(MeasuresOf{}, surface); }

}  // namespace dupin
