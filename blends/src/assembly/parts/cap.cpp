#include "assembly/parts/part_rules.h"

namespace dupin::assembly {

template <>
struct PartRules<"cap"> {
  static constexpr bool kNamesEnd = true;

  static References references(const CapAt& cap) { return {{cap.at, "at"}}; }

  static std::string_view portless(const CapAt&) { return "a cap"; }
};
template const PartKind& part_kind<"cap">();

}  // namespace dupin::assembly
