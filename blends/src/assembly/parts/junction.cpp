#include "dupin/blends/junction.h"

#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"

namespace dupin::assembly {

template <>
struct PartRules<"junction"> {
  static References references(const JunctionOfPorts&) { return {}; }

  static std::string_view portless(const JunctionOfPorts&) { return "a junction"; }

  static References ends(const JunctionOfPorts& junction) {
    References result;
    for (const PortReference& end : junction.ends) {
      result.push_back({end, "ends"});
    }
    return result;
  }

  static Junction junction(const PartContext& context, const JunctionOfPorts& junction) {
    if (junction.options.center) {
      check_finite(context, *junction.options.center, "center");
    }
    if (junction.options.radius) {
      check_positive(context, *junction.options.radius, "radius");
    }
    std::vector<Ring> rings;
    for (const PortReference& end : junction.ends) {
      rings.push_back(right_end(context, end, "ends"));
    }
    return junction_of(rings, junction.options);
  }
};
template const PartKind& part_kind<"junction">();

}  // namespace dupin::assembly
