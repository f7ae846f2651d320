#include <array>
#include <functional>

#include "assembly/bore.h"
#include "assembly/fillet_part.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"

namespace dupin::assembly {

namespace {

std::function<bool(double)> fits_bore(const Assembly& assembly, const FilletBetween& fillet,
                                      const std::array<const PartSurface*, 2>& surfaces) {
  return [&](double tried) { return bore_takes(assembly, surfaces, fillet.between, tried); };
}

}  // namespace

template <>
struct PartRules<"fillet"> {
  static References references(const FilletBetween&) { return {}; }

  static std::string_view portless(const FilletBetween&) { return "a fillet"; }

  static FilletPipes pipes(const FilletBetween& fillet) { return {"between", fillet.between}; }

  static Fillet fillet(const PartContext& context, const FilletBetween& fillet,
                       const std::array<const PartSurface*, 2>& surfaces) {
    check_positive(context, fillet.radius, "radius");
    if (fillet.between[0] == fillet.between[1]) {
      fail(context, "between", "a fillet is between two different parts");
    }
    return fillet_without_loops(surfaces, fillet.between, fillet.radius,
                                fits_bore(context.assembly, fillet, surfaces));
  }

  static void find_loops(const Assembly& assembly, const FilletBetween& fillet,
                         const std::array<const PartSurface*, 2>& surfaces, Fillet& found) {
    assembly::find_loops(found, surfaces, fillet.between, fits_bore(assembly, fillet, surfaces));
  }

  static void prove(const Assembly& assembly, const FilletBetween& fillet,
                    const std::array<const PartSurface*, 2>& surfaces, Fillet& found) {
    assembly::prove(found, surfaces, fillet.between, fits_bore(assembly, fillet, surfaces));
  }
};
template const PartKind& part_kind<"fillet">();

}  // namespace dupin::assembly
