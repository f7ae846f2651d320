#include "assembly/districts/common_rings.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "assembly/bore.h"
#include "assembly/run_solids.h"
#include "assembly/welded_runs.h"

namespace dupin::assembly {
namespace {

// Of the second surface, by part; parts without one have no segments.
std::vector<RingSampling> samplings_of(const Assembly& assembly, const SelectedParts& second,
                                       double grid) {
  const std::vector<RingSampling> own = part_samplings(assembly, second.resolved, grid);
  std::vector<RingSampling> result;
  for (const auto& position : second.position) {
    result.push_back(position ? own[*position] : RingSampling{.segments = 0});
  }
  return result;
}

PieceOf common_of_insulation(const Assembly& assembly, const ResolvedAssembly& outer,
                             const std::vector<double>& thickness) {
  const SelectedParts around = insulated(assembly, outer, thickness);
  PieceOf result;
  result.tolerance = assembly.tolerance;
  result.grid = lattice_of_both(assembly, outer, around.resolved);
  result.samplings = part_samplings(assembly, outer, result.grid);
  result.second_samplings = samplings_of(assembly, around, result.grid);
  return result;
}

PieceOf common_of_bores(Assembly assembly, ResolvedAssembly outer,
                        const std::vector<double>& walls) {
  assembly.tolerance = tolerance_within_walls(assembly.tolerance, walls);
  // Balls of fillets are larger in bores: they do not decide about the lattice.
  std::vector<ResolvedFillet> fillets = std::exchange(outer.fillets, {});
  SelectedParts bore = bore_of(assembly, outer, walls);
  outer.fillets = std::move(fillets);
  (void)kept_out_of_solids(bore, assembly, outer, walls);
  PieceOf result;
  result.tolerance = assembly.tolerance;
  result.grid = lattice_of_bores(assembly, outer, bore.resolved, walls);
  result.samplings = part_samplings(assembly, outer, result.grid);
  result.second_samplings = samplings_of(assembly, bore, result.grid);
  return result;
}

}  // namespace

std::optional<std::vector<double>> distances_between(const Assembly& assembly,
                                                     const ResolvedAssembly& resolved,
                                                     std::optional<Region> region) {
  if (region != Region::insulation) {
    return walls_of(assembly, resolved, region);
  }
  std::vector<double> thickness = insulation_of(assembly);
  thickness.resize(assembly.parts.size());
  return thickness;
}

bool ends_alike(const ResolvedAssembly& resolved, const EndIndex& end,
                const std::optional<std::vector<double>>& distances, std::optional<Region> region) {
  if (!distances) {
    return true;
  }
  const ResolvedPart& part = resolved.parts[end.part];
  const EndIndex& next = *part.joined.at(at(end.end));
  const ResolvedPart& other = resolved.parts[next.part];
  const double distance = (*distances)[part.index];
  if (distance != (*distances)[other.index]) {
    return false;
  }
  if (distance == 0) {
    return region != Region::fluid && region != Region::insulation;
  }
  return !port_ring(part.shape, end.end)->ellipse && !part.is_closed.at(at(end.end)) &&
         !other.is_closed.at(at(next.end)) && !ends_cone_of_cyclide(part, end.end) &&
         !ends_cone_of_cyclide(other, next.end);
}

double tolerance_within_walls(double tolerance, const std::vector<double>& walls) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (const double wall : walls) {
    thinnest = wall > 0 ? std::min(thinnest, wall) : thinnest;
  }
  return std::min(tolerance, thinnest / 4);
}

double lattice_of_both(const Assembly& assembly, const ResolvedAssembly& outer,
                       const ResolvedAssembly& second) {
  const double grid = lattice_spacing(assembly, outer);
  return second.parts.empty() ? grid : std::min(grid, lattice_spacing(assembly, second));
}

double lattice_of_bores(const Assembly& assembly, const ResolvedAssembly& outer,
                        const ResolvedAssembly& bore, const std::vector<double>& walls) {
  return lattice_for_gaps(lattice_of_both(assembly, outer, bore), outer, walls);
}

PieceOf common_rings(const District& whole, std::optional<Region> region) {
  if (const auto distances = distances_between(whole.assembly, whole.resolved, region)) {
    const ResolvedAssembly outer = filled(whole.resolved);
    return region == Region::insulation ? common_of_insulation(whole.assembly, outer, *distances)
                                        : common_of_bores(whole.assembly, outer, *distances);
  }
  PieceOf result;
  result.tolerance = whole.assembly.tolerance;
  result.grid = lattice_spacing(whole.assembly, whole.resolved);
  result.samplings = part_samplings(whole.assembly, whole.resolved, result.grid);
  result.second_samplings.resize(whole.resolved.parts.size(), RingSampling{.segments = 0});
  return result;
}

std::vector<RingSampling> with_what_goes_on(std::vector<RingSampling> samplings,
                                            const ResolvedAssembly& parts) {
  for (std::size_t i = samplings.size(); i < parts.parts.size(); ++i) {
    samplings.push_back(samplings.at(parts.parts[i].joined.at(0).value().part));
  }
  return samplings;
}

}  // namespace dupin::assembly
