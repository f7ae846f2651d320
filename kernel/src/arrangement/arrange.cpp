#include "arrangement/arrange.h"

#include <algorithm>
#include <array>

#include "arrangement/broad_phase.h"
#include "arrangement/constraints.h"
#include "arrangement/crowding.h"
#include "arrangement/faces/subdivision.h"
#include "arrangement/lone_fans.h"
#include "arrangement/manifold_patches.h"
#include "arrangement/output_mesh.h"
#include "arrangement/pair_intersections.h"
#include "arrangement/piece_merging.h"
#include "arrangement/winding_numbers.h"
#include "dupin/kernel/error.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/operation_limits.h"
#include "support/sequences.h"

namespace dupin::arrangement {
namespace {

std::vector<TrianglePair> candidates_of(const ArrangementInput& input, const Progress& progress,
                                        std::uint64_t memory_limit = 0) {
  const UpwardRounding rounding;
  return broad_phase(input, support::ProgressStage(progress, "search", 0, 0.2), memory_limit);
}

Intersections find_intersections(const ArrangementInput& input,
                                 std::span<const TrianglePair> candidates,
                                 const Progress& progress) {
  return find_intersections(input, candidates,
                            support::ProgressStage(progress, "intersect", 0.2, 0.4));
}

Intersections intersections_of(const ArrangementInput& input, const Progress& progress,
                               std::uint64_t memory_limit) {
  return find_intersections(input, candidates_of(input, progress, memory_limit), progress);
}

Constraints constraints_of(ArrangementInput& input, const Intersections& intersections,
                           std::uint64_t memory_limit) {
  const UpwardRounding rounding;
  support::refuse_too_large(input.triangles.size(), intersections.found.size(), memory_limit);
  return collect_constraints(input, intersections.found, intersections.crossed_sheets);
}

// Where they are is known by intervals. Needs UpwardRounding.
OutsideSheets sheets_of(const ArrangementInput& input,
                        const support::BulkVector<OutputTriangle>& triangles) {
  OutsideSheets sheets;
  for (const OutputTriangle& triangle : triangles) {
    std::array<Vec3, 3>& corners = sheets.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const Interval at = input.points.interval(triangle.corners[i], k);
        const double middle = at.inf() / 2 + at.sup() / 2;
        corners[i][k] = middle;
        sheets.error = std::max({sheets.error, at.sup() - middle, middle - at.inf()});
      }
    }
    sheets.sources.push_back(triangle.source);
  }
  return sheets;
}

struct SelectedTriangles {
  support::BulkVector<OutputTriangle> kept;
  OutsideSheets outside;  // if the rule keeps what is cancelled
};

// All that stands between the input and these ends here, to make room for the result.
SelectedTriangles select_triangles(ArrangementInput& input, Intersections intersections,
                                   const BooleanRule& rule, const Progress& progress,
                                   std::uint64_t memory_limit) {
  Subdivision subdivision;
  {
    Constraints constraints = constraints_of(input, intersections, memory_limit);
    intersections = {};
    const support::ProgressStage stage(progress, "triangulate", 0.4, 0.7);
    const UpwardRounding rounding;
    subdivision = retriangulate(input, rule, std::move(constraints), stage);
  }
  const support::ProgressStage stage(progress, "classify", 0.7, 0.9);
  const UpwardRounding rounding;
  ManifoldPatches patches(input, rule, subdivision);
  const Selection selection = propagate_winding_numbers(input, rule, subdivision, patches);
  patches.forget_seams();
  const auto is_wanted = [&](std::uint32_t region) {
    const std::uint32_t patch = patches.of_region(region);
    return selection.kept[patch] != 0 || (rule.keeps_cancelled && selection.outside[patch] != 0);
  };
  triangulate_outlines(input, is_wanted, subdivision);
  SelectedTriangles result;
  result.kept = collect_output_triangles(input, subdivision, patches, selection.kept);
  if (rule.keeps_cancelled) {
    result.outside =
        sheets_of(input, collect_output_triangles(input, subdivision, patches, selection.outside));
  }
  return result;
}

WoundSurface arrange_with_rest(ArrangementInput& input, Intersections intersections,
                               const BooleanRule& rule, const Progress& progress,
                               std::uint64_t memory_limit, bool merging = false) {
  auto [kept, outside] =
      select_triangles(input, std::move(intersections), rule, progress, memory_limit);
  const support::ProgressStage stage(progress, "extract", 0.9, 1);
  if (merging) {
    const UpwardRounding rounding;
    kept = merge_pieces(input, kept);
  }
  input.points.forget_balls();
  return {extract(input, std::move(kept)), std::move(outside)};
}

mesh::ExactMesh arrange(ArrangementInput& input, Intersections intersections,
                        const BooleanRule& rule, const Progress& progress,
                        std::uint64_t memory_limit, bool merging = false) {
  return arrange_with_rest(input, std::move(intersections), rule, progress, memory_limit, merging)
      .boundary;
}

ArrangementInput imported(std::span<const mesh::ExactMesh* const> operands, const BooleanRule& rule,
                          std::vector<OperandPair> pairs = {}) {
  // All tasks of a thread's arena take over the rounding in which it ran the first.
  support::for_each_in_parallel(1, [](std::size_t) {});
  const UpwardRounding rounding;
  return load_operands(operands, rule, std::move(pairs));
}

ArrangementInput imported_within(std::span<const mesh::ExactMesh* const> operands,
                                 const BooleanRule& rule, std::uint64_t memory_limit) {
  std::uint64_t triangles = 0;
  for (const mesh::ExactMesh* mesh : operands) {
    triangles += mesh->triangles.size();
  }
  support::refuse_too_large(triangles, 0, memory_limit);
  return imported(operands, rule);
}

// Whether a few of the operands, from all over, all meet each other: then so do all, most likely,
// and need not be searched to be told crowded.
bool is_sample_crowded(const ArrangementInput& all) {
  constexpr std::size_t kSample = 6, kPairs = kSample * (kSample - 1) / 2, kLeast = 10;
  const std::size_t count = all.operands.size();
  if (count < kLeast) {
    return false;
  }
  std::vector<std::uint32_t> numbers;
  std::vector<const mesh::ExactMesh*> sample;
  for (std::size_t i = 0; i < kSample; ++i) {
    numbers.push_back(static_cast<std::uint32_t>(count * i / kSample));
    sample.push_back(all.operands[numbers.back()]);
  }
  const auto is_sampled = [&numbers](std::uint32_t operand) {
    return std::ranges::binary_search(numbers, operand);
  };
  const auto near = std::ranges::count_if(all.operand_pairs, [&](const auto& pair) {
    return is_sampled(pair[0]) && is_sampled(pair[1]);
  });
  if (static_cast<std::size_t>(near) < kPairs) {
    return false;
  }
  const ArrangementInput input = imported(sample, union_rule(kSample));
  return crowded(input, candidates_of(input, {}), kSample - 2);
}

// Whether operands do around some of them by far: then on average, most likely, and all need not be
// searched.
bool are_samples_crowded(const ArrangementInput& all) {
  constexpr std::size_t kAround = 15, kLeast = 64;
  constexpr double kByFar = 2 * kManyInCommon;
  if (all.operands.size() < kLeast) {
    return false;
  }
  const std::vector<OperandSample> samples = samples_around(all, kAround);
  return !samples.empty() && std::ranges::all_of(samples, [&](const OperandSample& sample) {
    const auto operands = support::selected(std::span(all.operands), sample.operands);
    const ArrangementInput input = imported(operands, union_rule(operands.size()));
    return sample.times * operands_in_common(input, candidates_of(input, {})) >= kByFar;
  });
}

}  // namespace

mesh::ExactMesh arrange(std::span<const mesh::ExactMesh* const> operands, const BooleanRule& rule,
                        const Progress& progress, std::uint64_t memory_limit) {
  ArrangementInput input = imported_within(operands, rule, memory_limit);
  return arrange(input, intersections_of(input, progress, memory_limit), rule, progress,
                 memory_limit);
}

std::optional<mesh::ExactMesh> arrange_unless_crowded(
    std::span<const mesh::ExactMesh* const> operands, const BooleanRule& rule,
    const Progress& progress, std::uint64_t memory_limit) {
  ArrangementInput input = imported_within(operands, rule, memory_limit);
  if (is_sample_crowded(input) || are_samples_crowded(input)) {
    return std::nullopt;
  }
  std::vector<TrianglePair> candidates = candidates_of(input, progress, memory_limit);
  if (crowded(input, candidates) || are_faces_crowded(input, candidates)) {
    return std::nullopt;
  }
  Intersections intersections = find_intersections(input, candidates, progress);
  support::release(candidates);
  return arrange(input, std::move(intersections), rule, progress, memory_limit);
}

mesh::ExactMesh arrange_and_merge(std::span<const mesh::ExactMesh* const> operands,
                                  const BooleanRule& rule, const Progress& progress,
                                  std::uint64_t memory_limit) {
  ArrangementInput input = imported_within(operands, rule, memory_limit);
  return arrange(input, intersections_of(input, progress, memory_limit), rule, progress,
                 memory_limit, true);
}

namespace {

WoundSurface wound_surface(const mesh::ExactMesh& surface, const BooleanRule& rule,
                           const Progress& progress, std::span<const std::uint8_t> crossing) {
  const mesh::ExactMesh* const operand = &surface;
  ArrangementInput input = imported({&operand, 1}, rule);
  input.operand_pairs = {{0, 0}};
  input.crossing = crossing;
  if (crossing.empty()) {  // any edge may have more than two triangles
    std::fill(input.special.begin(), input.special.end(), std::uint8_t{1});
  } else {
    mark_all_but_lone_fans(input);
  }
  return arrange_with_rest(input, intersections_of(input, progress, 0), rule, progress, 0);
}

}  // namespace

mesh::ExactMesh positive_winding_boundary(const mesh::ExactMesh& surface,
                                          const Progress& progress) {
  return wound_surface(surface, union_rule(1), progress, {}).boundary;
}

WoundSurface wound_surface(const mesh::ExactMesh& surface, std::span<const std::uint8_t> crossing) {
  BooleanRule rule = union_rule(1);
  rule.keeps_cancelled = true;
  return wound_surface(surface, rule, {}, crossing);
}

mesh::ExactMesh united_with_winding(const mesh::ExactMesh& solid, const mesh::ExactMesh& surface) {
  const std::array<const mesh::ExactMesh*, 2> operands{&solid, &surface};
  const BooleanRule rule{
      {0, 1}, 2, [](std::span<const int> counts) { return counts[0] > 0 || counts[1] > 0; }};
  ArrangementInput input = imported(operands, rule, {{0, 1}, {1, 1}});
  // Any edge of the surface may have more than two triangles.
  for (const auto* first : {&input.first_double, &input.first_implicit}) {
    std::fill(input.special.begin() + (*first)[1], input.special.begin() + (*first)[2],
              std::uint8_t{1});
  }
  return arrange(input, intersections_of(input, {}, 0), rule, {}, 0);
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

}  // namespace dupin::arrangement
