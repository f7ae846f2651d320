#include "arrange.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "candidates.h"
#include "dupin/kernel/error.h"
#include "extract.h"
#include "faces.h"
#include "incidences.h"
#include "patches.h"
#include "selection.h"
#include "triangle_pair.h"

namespace dupin::detail {
namespace {

std::vector<Encounter> find_encounters(const Scene& scene,
                                       const std::vector<TrianglePair>& candidates) {
  constexpr std::size_t kBatch = 1024;
  std::vector<std::vector<Encounter>> batches((candidates.size() + kBatch - 1) / kBatch);
  tbb::parallel_for(std::size_t{0}, batches.size(), [&](std::size_t b) {
    const UpwardRounding rounding;
    const std::size_t end = std::min((b + 1) * kBatch, candidates.size());
    for (std::size_t i = b * kBatch; i < end; ++i) {
      meet(scene, candidates[i].first, candidates[i].second, batches[b]);
    }
  });
  std::vector<Encounter> encounters;
  for (const std::vector<Encounter>& batch : batches) {
    encounters.insert(encounters.end(), batch.begin(), batch.end());
  }
  return encounters;
}

void tell(const Progress& progress, std::string_view stage, double fraction) {
  if (progress && !progress(stage, fraction)) {
    throw Error(Errc::cancelled, "the boolean operation was cancelled");
  }
}

}  // namespace

ExactMesh arrange(std::span<const ExactMesh* const> operands, const BooleanRule& rule,
                  const Progress& progress) {
  Scene scene;
  Incidences incidences;
  Pieces pieces;
  tell(progress, "intersect", 0);
  {
    const UpwardRounding rounding;
    scene = import_operands(operands, rule);
    incidences = gather(scene, find_encounters(scene, find_candidates(scene)));
  }
  tell(progress, "triangulate", 0.4);
  {
    const UpwardRounding rounding;
    pieces = retriangulate(scene, rule, incidences);
  }
  tell(progress, "classify", 0.7);
  std::optional<Patches> patches;
  std::vector<std::int8_t> selection;
  {
    const UpwardRounding rounding;
    patches.emplace(scene, rule, incidences, pieces);
    selection = select(scene, rule, incidences, pieces, *patches);
  }
  tell(progress, "extract", 0.9);
  return extract(scene, incidences, pieces, *patches, selection);
}

BooleanRule union_rule(std::size_t operands) {
  return {std::vector<std::uint32_t>(operands, 0), 1,
          [](std::span<const int> counts) { return counts[0] > 0; }};
}

BooleanRule intersection_rule(std::size_t operands) {
  const int all = static_cast<int>(operands);
  return {std::vector<std::uint32_t>(operands, 0), 1,
          [all](std::span<const int> counts) { return counts[0] == all; }};
}

BooleanRule difference_rule(std::size_t operands) {
  std::vector<std::uint32_t> groups(operands, 1);
  groups.at(0) = 0;
  return {std::move(groups), 2,
          [](std::span<const int> counts) { return counts[0] > 0 && counts[1] == 0; }};
}

}  // namespace dupin::detail
