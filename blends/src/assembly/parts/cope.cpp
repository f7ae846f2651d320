#include "assembly/bore.h"
#include "assembly/fillet_part.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"

namespace dupin::assembly {

template <>
struct PartRules<"cope"> {
  static References references(const CopeOfEnd&) { return {}; }

  static std::string_view portless(const CopeOfEnd&) { return "a cope"; }

  static FilletPipes pipes(const CopeOfEnd& cope) { return {"to", {cope.end.part, cope.to}}; }

  static Fillet fillet(const PartContext& context, const CopeOfEnd& cope,
                       const TubesToFillet& pipes) {
    if (cope.end.part == cope.to) {
      fail(context, "to", "an end is cut to fit another part");
    }
    const std::array<std::string, 2> names{cope.end.part, cope.to};
    Fillet result = cope_between(pipes.surfaces, names, pipe_walls(context.assembly, pipes.parts));
    if (!result.buried[0].at(at(cope.end.end))) {
      fail(context, "end",
           "'" + to_string(cope.end) + "' does not lie inside '" + cope.to +
               "', where it would be cut off");
    }
    return result;
  }
};
template const PartKind& part_kind<"cope">();

}  // namespace dupin::assembly
