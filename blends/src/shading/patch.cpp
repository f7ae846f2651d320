#include "shading/patch.h"

#include <cmath>
#include <limits>

namespace dupin::shading {
namespace {

struct FootOn {
  const Vec3& place;

  std::optional<Foot> operator()(const SweptPatch& patch) const { return patch.foot(place); }

  std::optional<Foot> operator()(const Sphere& ball) const {
    const Vec3 away = place - ball.center;
    const double far = away.norm();
    return far > 0 ? std::optional(Foot{std::abs(far - ball.radius), away / far}) : std::nullopt;
  }

  std::optional<Foot> operator()(const FlatPatch& flat) const {
    return Foot{std::abs((place - flat.point).dot(flat.normal)), flat.normal};
  }

  // The rim's normal is the way of the surface across its circle.
  std::optional<Foot> operator()(const RimPatch& rim) const {
    const Ring& ring = rim.ring;
    const Vec3 away = place - ring.center;
    const Vec3 direction = (away - away.dot(ring.normal) * ring.normal).normalized();
    const Vec3 normal = (ring.normal + ring.slope * direction).normalized();
    return normal.allFinite()
               ? std::optional(Foot{std::abs((away - ring.radius * direction).dot(normal)), normal})
               : std::nullopt;
  }
};

}  // namespace

std::optional<Foot> foot_on(const Patch& patch, const Vec3& place) {
  return std::visit(FootOn{place}, patch);
}

std::optional<Foot> rough_foot_on(const Patch& patch, const Vec3& place) {
  const auto* swept = std::get_if<SweptPatch>(&patch);
  return swept != nullptr ? swept->rough_foot(place) : foot_on(patch, place);
}

Eigen::AlignedBox3d box_of(const Patch& patch) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto* swept = std::get_if<SweptPatch>(&patch);
  return swept != nullptr
             ? swept->box()
             : Eigen::AlignedBox3d(Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity));
}

}  // namespace dupin::shading
