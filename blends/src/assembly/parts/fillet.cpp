#include <array>

#include "assembly/bore.h"
#include "assembly/fillet_part.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"

namespace dupin::assembly {

template <>
struct PartRules<"fillet"> {
  static References references(const FilletBetween&) { return {}; }

  static std::string_view portless(const FilletBetween&) { return "a fillet"; }

  static FilletPipes pipes(const FilletBetween& fillet) { return {"between", fillet.between}; }

  static Fillet fillet(const PartContext& context, const FilletBetween& fillet,
                       const TubesToFillet& pipes) {
    check_positive(context, fillet.radius, "radius");
    if (fillet.between[0] == fillet.between[1]) {
      fail(context, "between", "a fillet is between two different parts");
    }
    return fillet_without_loops(pipes.surfaces, fillet.between, fillet.radius,
                                pipe_walls(context.assembly, pipes.parts));
  }

  static void find_loops(const Assembly& assembly, const FilletBetween& fillet,
                         const TubesToFillet& pipes, Fillet& found) {
    assembly::find_loops(found, pipes.surfaces, fillet.between, pipe_walls(assembly, pipes.parts));
  }

  static void prove(const Assembly& assembly, const FilletBetween& fillet,
                    const TubesToFillet& pipes, Fillet& found) {
    assembly::prove(found, pipes.surfaces, fillet.between, pipe_walls(assembly, pipes.parts));
  }
};
template const PartKind& part_kind<"fillet">();

}  // namespace dupin::assembly
