#include "arrange.h"

#include "blocks.h"
#include "candidates.h"
#include "dupin/kernel/error.h"
#include "extract.h"
#include "faces.h"
#include "incidences.h"
#include "limits.h"
#include "patches.h"
#include "selection.h"
#include "triangle_pair.h"

namespace dupin::detail {
namespace {

std::vector<Encounter> find_encounters(const Scene& scene,
                                       const std::vector<TrianglePair>& candidates,
                                       const Stage& stage) {
  constexpr std::size_t kBatch = 1024;
  std::vector<std::vector<Encounter>> batches(block_count(candidates.size(), kBatch));
  const auto meet_all = [&](const Block& block) {
    const UpwardRounding rounding;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      meet(scene, candidates[i].first, candidates[i].second, batches[block.number]);
    }
    stage.step(batches.size());
  };
  for_each_block(candidates.size(), meet_all, kBatch);
  return joined(std::move(batches));
}

Incidences intersect_triangles(Scene& scene, const Progress& progress, std::uint64_t memory_limit) {
  const UpwardRounding rounding;
  const std::vector<TrianglePair> candidates =
      find_candidates(scene, Stage(progress, "intersect", 0, 0.2));
  const std::vector<Encounter> encounters =
      find_encounters(scene, candidates, Stage(progress, "intersect", 0.2, 0.4));
  refuse_too_large(scene.triangles.size(), encounters.size(), memory_limit);
  return gather(scene, encounters);
}

// All that stands between the scene and these ends here, to make room for the result.
BulkVector<Kept> select_triangles(Scene& scene, const BooleanRule& rule, const Progress& progress,
                                  std::uint64_t memory_limit) {
  Incidences incidences = intersect_triangles(scene, progress, memory_limit);
  Pieces pieces;
  {
    const Stage stage(progress, "triangulate", 0.4, 0.7);
    const UpwardRounding rounding;
    pieces = retriangulate(scene, rule, incidences, stage);
  }
  const Stage stage(progress, "classify", 0.7, 0.9);
  const UpwardRounding rounding;
  const Patches patches(scene, rule, incidences, pieces);
  const std::vector<std::int8_t> selection = select(scene, rule, incidences, pieces, patches);
  return collect(scene, incidences, pieces, patches, selection);
}

ExactMesh arrange(Scene& scene, const BooleanRule& rule, const Progress& progress,
                  std::uint64_t memory_limit) {
  BulkVector<Kept> kept = select_triangles(scene, rule, progress, memory_limit);
  const Stage stage(progress, "extract", 0.9, 1);
  return extract(scene, std::move(kept));
}

Scene imported(std::span<const ExactMesh* const> operands, const BooleanRule& rule) {
  // All tasks of a thread's arena take over the rounding in which it ran the first.
  for_each_in_parallel(1, [](std::size_t) {});
  const UpwardRounding rounding;
  return import_operands(operands, rule);
}

}  // namespace

ExactMesh arrange(std::span<const ExactMesh* const> operands, const BooleanRule& rule,
                  const Progress& progress, std::uint64_t memory_limit) {
  std::uint64_t triangles = 0;
  for (const ExactMesh* mesh : operands) {
    triangles += mesh->triangles.size();
  }
  refuse_too_large(triangles, 0, memory_limit);
  Scene scene = imported(operands, rule);
  return arrange(scene, rule, progress, memory_limit);
}

ExactMesh resolve(const ExactMesh& surface, const Progress& progress) {
  const ExactMesh* const operand = &surface;
  const BooleanRule rule = union_rule(1);
  Scene scene = imported({&operand, 1}, rule);
  scene.operand_pairs = {{0, 0}};
  // Any edge may have more than two triangles.
  std::fill(scene.special.begin(), scene.special.end(), std::uint8_t{1});
  return arrange(scene, rule, progress, 0);
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
