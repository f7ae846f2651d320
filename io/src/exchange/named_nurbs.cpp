#include "dupin/io/named_nurbs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

// A cope has no surface of its own.
void append_fillets(const ResolvedAssembly& resolved, double tolerance,
                    std::vector<NamedNurbs>& result) {
  for (const ResolvedFillet& fillet : resolved.fillets) {
    if (fillet.shape.is_cope()) {
      continue;
    }
    NurbsForm form;
    for (const CanalFillet& loop : fillet.shape.loops) {
      try {
        const NurbsForm own = nurbs(loop, tolerance);
        form.surfaces.insert(form.surfaces.end(), own.surfaces.begin(), own.surfaces.end());
        form.error_bound = std::max(form.error_bound, own.error_bound);
      } catch (const Error& error) {
        throw error.in_part(fillet.name);
      }
    }
    result.push_back({fillet.name, "fillet", std::move(form)});
  }
}

}  // namespace

std::vector<NamedNurbs> named_nurbs(const Assembly& assembly, double tolerance) {
  const UsualArithmetic usual;
  if (!(tolerance > 0 && std::isfinite(tolerance))) {  // which is of no part
    throw Error(Errc::invalid_argument, "the tolerance of NURBS must be positive and finite, not " +
                                            decimal(tolerance, kMessageDigits));
  }
  std::vector<NamedNurbs> result;
  const ResolvedAssembly resolved = resolve(assembly);
  for (const ResolvedPart& part : resolved.parts) {
    try {
      result.push_back({part.name, part.kind, nurbs(part.shape, tolerance)});
    } catch (const Error& error) {
      throw error.in_part(part.name);
    }
  }
  for (const ResolvedJunction& junction : resolved.junctions) {
    NurbsForm hub = nurbs(junction.shape.hub, tolerance);
    for (const JunctionArm& arm : junction.shape.arms) {
      hub.trims.push_back(nurbs(cap_circle(arm)));
    }
    result.push_back({junction.name, "junction", std::move(hub)});
  }
  append_fillets(resolved, tolerance, result);
  return result;
}

}  // namespace dupin
