#include "assembly/parts/start_ring.h"

#include "assembly/parts/line_and_arc.h"
#include "assembly/parts/part_checks.h"

namespace dupin::assembly {
namespace {

Ring start_ring(const PartContext& context, const Vec3& center, const Vec3& travel, double radius,
                const std::optional<SectionAxes>& axes, const SectionKeys& keys) {
  check_positive(context, radius, axes ? keys.first : keys.radius);
  Ring ring{center, opposite(travel.normalized()), radius};
  if (axes) {
    check_positive(context, axes->across, keys.across);
    ring.ellipse = Ellipse{axis_across(context, ring.normal, axes->axis), axes->across};
  }
  return ring;
}

}  // namespace

Vec3 axis_across(const PartContext& context, const Vec3& normal, const Vec3& direction) {
  check_finite(context, direction, "axis");
  const Vec3 across = direction - direction.dot(normal) * normal;
  if (!(across.norm() > kNoDirection * direction.norm())) {
    fail(context, "axis", "the axis must have a part across the direction of travel");
  }
  return plain(across.normalized());
}

Ring start_between(const PartContext& context, const Vec3& from, const Vec3& to, double radius,
                   const std::optional<SectionAxes>& axes, const SectionKeys& keys) {
  check_finite(context, from, "from");
  check_finite(context, to, "to");
  if (!((to - from).norm() >= kSmallest)) {
    fail(context, "to", "the point must be 1e-12 or more away from the one at 'from'");
  }
  return start_ring(context, from, to - from, radius, axes, keys);
}

Ring origin(const PartContext& context, const PartStart& from, const SectionKeys& keys) {
  if (const auto* port = std::get_if<PortReference>(&from)) {
    return flipped(context.ring(*port));
  }
  const auto& place = std::get<Place>(from);
  check_finite(context, place.point, "from");
  check_finite(context, place.direction, "direction");
  if (!(place.direction.norm() >= kSmallest)) {
    fail(context, "direction", "the direction must not be zero");
  }
  return start_ring(context, place.point, place.direction, place.radius, place.axes, keys);
}

}  // namespace dupin::assembly
