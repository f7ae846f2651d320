#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"

namespace dupin::assembly {

template <>
struct PartRules<"sphere"> {
  static References references(const SphereAt&) { return {}; }

  static std::string_view portless(const SphereAt&) { return "a sphere"; }

  static PartSurface geometry(const PartContext& context, const SphereAt& sphere) {
    check_finite(context, sphere.center, "center");
    check_positive(context, sphere.radius, "radius");
    return Sphere{sphere.center, sphere.radius};
  }
};
template const PartKind& part_kind<"sphere">();

}  // namespace dupin::assembly
