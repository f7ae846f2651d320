#include <algorithm>
#include <set>
#include <string>

#include "assembly/bore.h"
#include "dupin/blends/build.h"

namespace dupin {
namespace assembly {

namespace {

/// How far pipes reach out of insulation: what lies before an open end must not be cut by more than
/// surfaces may be off.
constexpr double kReach = 1.0 / 16;

}  // namespace

std::set<std::string> names_seen(const Solid& solid) {
  std::set<std::string> result;
  for (const std::uint32_t label : std::set(solid.labels().begin(), solid.labels().end())) {
    result.insert(solid.names()[label]);
  }
  return result;
}

SmoothRegion smooth_region_seen(const Assembly& assembly, const Built& built,
                                const std::set<std::string>& names) {
  SmoothRegion result{built.region, resolve(assembly), {}, {}};
  if (built.region == Region::insulation) {
    const ResolvedAssembly pipes = filled(std::move(result.whole));
    result.whole = insulated(assembly, pipes, insulation_of(assembly)).resolved;
    result.inside = reaching_out(pipes, assembly, kReach * mesh_error(built));
    return result;
  }
  if (!built.volumes) {
    return result;
  }
  const auto walls = assembly::walls_of(assembly, result.whole, built.region);
  result.whole = assembly::filled(std::move(result.whole));
  if (built.region == Region::outer) {
    return result;
  }
  assembly::SelectedParts bore = assembly::bore_of(assembly, result.whole, walls.value());
  lengthen_out_of(bore, assembly, result.whole, *walls, names);
  result.kept = assembly::kept_out_of_solids(bore, assembly, result.whole, *walls);
  result.inside = std::move(bore.resolved);
  return result;
}

}  // namespace assembly

double mesh_error(const Built& built) {
  double error = 0;
  for (const PartReport& part : built.parts) {
    error = std::max(error, part.error_bound);
  }
  return error;
}

SmoothRegion smooth_region(const Assembly& assembly, const Built& built) {
  return assembly::smooth_region_seen(assembly, built, assembly::names_seen(built.solid));
}

}  // namespace dupin
