#include "assembly/cost_limit.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "assembly/part_box.h"
#include "assembly/part_context.h"
#include "canal/contact_feet.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "surfaces/fillet_mesh.h"
#include "surfaces/mesh_cost.h"
#include "tessellation/tessellation_tolerance.h"
#include "tessellation/trimmed_face.h"

namespace dupin::assembly {
namespace {

using surfaces::MeshCost;
using tessellation::count_text;
using tessellation::TrimmedFace;

constexpr double kTurn = 2 * std::numbers::pi;

constexpr double kUncounted = std::numeric_limits<double>::infinity();
constexpr double kAnyTolerance = std::numeric_limits<double>::infinity();

struct Limit {
  double triangles, pairs;

  /// How much of it is used up; more than 1 is too much.
  [[nodiscard]] double share(const MeshCost& cost) const {
    return std::max(cost.triangles / triangles, cost.pairs / pairs);
  }
};

Limit limit_of(std::size_t most) {
  if (most == 0) {
    throw Error(Errc::invalid_argument,
                "the most triangles of all parts must be at least 1, not 0");
  }
  return {double(most), kPairsPerTriangle * double(most)};
}

struct Estimate {
  MeshCost all, worst;  // worst: of the part that asks for most
  std::string part;
  std::uint32_t index = 0, segments = 0;  // index: in Assembly::parts

  // Of a part or a fillet.
  void add(const MeshCost& cost, const auto& of, std::uint32_t around, const Limit& limit) {
    all.triangles += cost.triangles;
    all.pairs += cost.pairs;
    if (limit.share(cost) > limit.share(worst)) {
      worst = cost;
      part = of.name;
      index = of.index;
      segments = around;
    }
  }
};

class Estimator {
 public:
  Estimator(const ResolvedAssembly& resolved, std::span<const WeldedRun> runs, double grid,
            const Limit& limit, std::span<const RingSampling> given = {})
      : resolved_(resolved), runs_(runs), grid_(grid), limit_(limit), given_(given) {}

  /// By part, of those that have one.
  using Samplings = std::map<std::uint32_t, RingSampling>;

  [[nodiscard]] Samplings samplings(const Assembly& assembly) const {
    Samplings result;
    for (const WeldedRun& run : runs_) {
      const auto sampling = sampling_of(assembly, run);
      for (const std::uint32_t index : run.parts) {
        if (sampling) {
          result.emplace(index, *sampling);
        }
      }
    }
    return result;
  }

  /// Without fillets, if all else is more than enough.
  [[nodiscard]] Estimate of(const Assembly& assembly, double enough = kUncounted) const {
    Estimate result;
    const Samplings samplings = this->samplings(assembly);
    for (const WeldedRun& run : runs_) {
      for (const std::uint32_t index : run.parts) {
        const ResolvedPart& part = resolved_.parts[index];
        if (const auto own = samplings.find(index); own != samplings.end()) {
          result.add(cost_of(assembly, part, own->second), part, own->second.segments, limit_);
        } else {
          result.add({kUncounted, 0}, part, 0, limit_);
        }
      }
    }
    if (!(result.all.triangles > enough)) {
      add_fillets(assembly, samplings, result);
    }
    return result;
  }

  [[nodiscard]] bool is_within_limit(const Assembly& assembly) const {
    return limit_.share(of(assembly).all) <= 1;
  }

 private:
  // None for more segments than a ring may have.
  [[nodiscard]] std::optional<RingSampling> sampling_of(const Assembly& assembly,
                                                        const WeldedRun& run) const {
    if (!given_.empty()) {
      return given_[run.parts.front()];
    }
    try {
      return run_sampling(assembly, resolved_, run, 0, grid_);
    } catch (const Error& error) {
      if (error.code() != Errc::limit_exceeded) {
        throw;
      }
      return std::nullopt;
    }
  }

  [[nodiscard]] static MeshCost cost_of(const Assembly& assembly, const ResolvedPart& part,
                                        const RingSampling& sampling) {
    return with_part_context(assembly, part.index, [&] {
      return std::visit(
          [&](const auto& shape) {
            return surfaces::mesh_cost(shape, sampling, assembly.tolerance);
          },
          part.shape);
    });
  }

  // What a fillet adds: its own triangles, and what bounds the faces of its pipes.
  struct FilletCost {
    double triangles = 0;
    std::array<std::vector<std::vector<Vec3>>, 2> feet;  // of each loop
  };

  // And of their pipes' faces, which have triangles of the size of their segments where they are.
  void add_fillets(const Assembly& assembly, const Samplings& samplings, Estimate& result) const {
    std::vector<FilletCost> costs(resolved_.fillets.size());
    const auto has_samplings = [&](const ResolvedFillet& fillet) {
      return samplings.contains(fillet.between[0]) && samplings.contains(fillet.between[1]);
    };
    const auto segments_at = [&](const ResolvedFillet& fillet) {
      return std::array{samplings.at(fillet.between[0]).segments,
                        samplings.at(fillet.between[1]).segments};
    };
    for_each_in_parallel(costs.size(), [&](std::size_t i) {
      const ResolvedFillet& fillet = resolved_.fillets[i];
      if (has_samplings(fillet)) {
        costs[i] = cost_of(assembly, fillet, segments_at(fillet));
      }
    });
    std::map<std::uint32_t, TrimmedFace> faces;  // by part
    for (std::size_t i = 0; i < costs.size(); ++i) {
      const ResolvedFillet& fillet = resolved_.fillets[i];
      if (!has_samplings(fillet)) {
        continue;
      }
      result.add({costs[i].triangles, 0}, fillet, std::ranges::max(segments_at(fillet)), limit_);
      for (std::size_t side = 0; side < 2; ++side) {
        TrimmedFace& face = faces[fillet.between.at(side)];
        std::ranges::move(costs[i].feet.at(side), std::back_inserter(face.curves));
      }
    }
    for (auto& [index, face] : faces) {
      const Chain& chain = std::get<Chain>(resolved_.parts[index].shape);
      face.start = end_ring(chain, End::start);
      face.end = end_ring(chain, End::end);
      const RingSampling& sampling = samplings.at(index);
      result.add({tessellation::expected_triangles(face, sampling), 0}, resolved_.parts[index],
                 sampling.segments, limit_);
    }
  }

  [[nodiscard]] FilletCost cost_of(const Assembly& assembly, const ResolvedFillet& fillet,
                                   const std::array<std::uint32_t, 2>& segments) const {
    constexpr int kFeet = 16;
    const surfaces::FilletSampling sampling{
        assembly.tolerance, {kTurn / segments[0], kTurn / segments[1]}, grid_};
    FilletCost result;
    for (const CanalFillet& loop : fillet.shape.loops) {
      auto [triangles, feet] = fillet.shape.is_cope()
                                   ? surfaces::ExpectedFillet{0, canal::sampled_feet(loop, kFeet)}
                                   : surfaces::expected_fillet(loop, sampling);
      result.triangles += triangles;
      for (std::size_t side = 0; side < 2; ++side) {
        result.feet.at(side).push_back(std::move(feet.at(side)));
      }
    }
    return result;
  }

  const ResolvedAssembly& resolved_;
  std::span<const WeldedRun> runs_;
  double grid_;
  Limit limit_;
  std::span<const RingSampling> given_;  // by part
};

/// Rounded so that it looks larger than the limit, as it is.
std::string count_above(double count, double limit) {
  const std::string text = count_text(std::ceil(count));
  constexpr int kAllDigits = 17;
  return text != count_text(limit) ? text : decimal(std::ceil(count), kAllDigits);
}

std::string what_is_asked_for(const Assembly& assembly, const Estimate& estimate,
                              const Limit& limit) {
  const std::string tolerance = "a tolerance of " + decimal(assembly.tolerance, kMessageDigits);
  std::string text = assembly.segments ? std::to_string(*assembly.segments) + " segments and " +
                                             tolerance + " ask for "
                                       : tolerance + " asks for ";
  if (estimate.worst.triangles == kUncounted) {
    return text + "more than a million segments around this part; the limit is " +
           count_text(limit.triangles) + " triangles";
  }
  const auto shared = [](double all, double own) {
    return own < 0.9 * all ? ", " + count_text(own) + " of them for this part alone" : "";
  };
  if (estimate.all.triangles / limit.triangles > estimate.all.pairs / limit.pairs) {
    return text + "about " + count_above(estimate.all.triangles, limit.triangles) + " triangles" +
           shared(estimate.all.triangles, estimate.worst.triangles) + "; the limit is " +
           count_text(limit.triangles);
  }
  return text + std::to_string(estimate.segments) +
         " segments around this part, whose triangles lie side by side: about " +
         count_above(estimate.all.pairs, limit.pairs) + " pairs to compare" +
         shared(estimate.all.pairs, estimate.worst.pairs) + "; the limit is " +
         count_text(limit.pairs);
}

/// The same document's least tolerance that is not too costly for any, to two digits.
std::optional<double> tolerance_that_would_do(std::span<const Estimator> estimators,
                                              Assembly assembly) {
  const auto would_do = [&](double tolerance) {
    assembly.tolerance = tolerance;
    return std::ranges::all_of(estimators,
                               [&](const Estimator& e) { return e.is_within_limit(assembly); });
  };
  double no = assembly.tolerance, yes = 2 * no;
  for (int i = 0; !would_do(yes); ++i) {
    if (i == 30) {
      return std::nullopt;
    }
    no = yes;
    yes *= 2;
  }
  for (int i = 0; i < 6; ++i) {
    const double middle = (no + yes) / 2;
    (would_do(middle) ? yes : no) = middle;
  }
  return 1.06 * yes;
}

std::string what_would_do(std::span<const Estimator> estimators, const Assembly& assembly,
                          double coarsest) {
  const auto enough = tolerance_that_would_do(estimators, assembly);
  if (!enough) {
    return assembly.segments ? "; fewer segments may do, smaller parts, or a higher limit"
                             : "; smaller parts may do, or a higher limit";
  }
  return *enough <= coarsest
             ? "; a tolerance of " + decimal(*enough, 2) + " would do, or a higher limit"
             : std::string(
                   "; no tolerance would do with walls as thin as these, but a higher limit");
}

[[noreturn]] void refuse(std::span<const Estimator> estimators, std::size_t costly,
                         const Assembly& assembly, const Limit& limit, double coarsest) {
  const Estimate estimate = estimators[costly].of(assembly);
  throw Error(
      Errc::limit_exceeded,
      what_is_asked_for(assembly, estimate, limit) + what_would_do(estimators, assembly, coarsest),
      estimate.part, document_place(assembly, estimate.index));
}

/// Of two pipes of one radius through each other's axes, for each segment of both, measured: 3.9 to
/// 4.2. Less where radii differ (1.6 for 6 : 1), or axes pass each other (2.7 at two thirds of the
/// radius).
constexpr double kTrianglesPerSegment = 4;

/// What ends in a part, or rounds the edge to it, is no crossing: for each part others, ascending.
std::vector<std::set<std::uint32_t>> joined_parts(const ResolvedAssembly& resolved) {
  std::vector<std::set<std::uint32_t>> result(resolved.parts.size());
  for (const ResolvedFillet& fillet : resolved.fillets) {
    result[fillet.between[0]].insert(fillet.between[1]);
    result[fillet.between[1]].insert(fillet.between[0]);
  }
  for (const ResolvedJunction& junction : resolved.junctions) {
    for (const std::uint32_t arm : junction.arms) {
      result[arm].insert(junction.arms.begin(), junction.arms.end());
    }
  }
  return result;
}

// Of which these boxes touch, and others where those are small.
template <class Counts>
std::vector<std::array<std::uint32_t, 2>> near_pairs(const ResolvedAssembly& resolved,
                                                     const Boxes& boxes, const Counts& counts) {
  // So few have no more pairs than may be gone through before other axes are looked for.
  constexpr std::size_t kFew = 64;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    if (boxes[a].intersects(boxes[b]) && counts(a, b)) {
      pairs.push_back({a, b});
    }
  };
  const bool are_few = boxes.size() <= kFew;
  if (are_few) {
    for_each_touching(boxes, add);
  }
  if (are_few && pairs.empty()) {
    return pairs;
  }
  std::vector<const PartSurface*> shapes;
  for (const ResolvedPart& part : resolved.parts) {
    shapes.push_back(&part.shape);
  }
  if (const auto axes = main_axes(shapes)) {
    Boxes along;
    std::ranges::transform(shapes, std::back_inserter(along),
                           [&](const PartSurface* shape) { return part_box(*shape, *axes); });
    pairs.clear();
    for_each_touching(along, add);
  } else if (!are_few) {
    for_each_touching(boxes, add);
  }
  return pairs;
}

}  // namespace

void refuse_too_costly(const Assembly& assembly, const ResolvedAssembly& resolved,
                       std::span<const WeldedRun> runs, double grid, std::size_t most) {
  const Limit limit = limit_of(most);
  const Estimator estimator(resolved, runs, grid, limit);
  if (!estimator.is_within_limit(assembly)) {
    refuse({&estimator, 1}, 0, assembly, limit, kAnyTolerance);
  }
}

void refuse_too_costly(const Assembly& assembly,
                       const std::vector<const ResolvedAssembly*>& sets_of_parts, double grid,
                       std::size_t most, double coarsest,
                       const std::function<const ResolvedAssembly*()>& later) {
  const Limit limit = limit_of(most);
  std::vector<std::vector<WeldedRun>> runs(sets_of_parts.size() + 1);
  std::vector<Estimator> estimators;
  const auto add = [&](const ResolvedAssembly& parts) {
    std::vector<WeldedRun>& own = runs[estimators.size()];
    own = welded_runs(parts);
    estimators.emplace_back(parts, own, grid, limit);
  };
  for (const ResolvedAssembly* const parts : sets_of_parts) {
    add(*parts);
  }
  const auto costly = std::ranges::find_if(
      estimators, [&](const Estimator& e) { return !e.is_within_limit(assembly); });
  if (costly == estimators.end()) {
    return;
  }
  const auto place = static_cast<std::size_t>(costly - estimators.begin());
  if (const ResolvedAssembly* const parts = later()) {
    add(*parts);
  }
  refuse(estimators, place, assembly, limit, coarsest);
}

double expected_triangles(const Assembly& assembly, const ResolvedAssembly& resolved,
                          std::span<const WeldedRun> runs, double grid,
                          std::span<const RingSampling> given, double enough) {
  return Estimator(resolved, runs, grid, {1, 1}, given).of(assembly, enough).all.triangles;
}

double expected_crossings(const Assembly& assembly, const ResolvedAssembly& resolved,
                          const Boxes& boxes, std::span<const WeldedRun> runs, double grid,
                          std::span<const RingSampling> given) {
  std::vector<std::size_t> run_of(resolved.parts.size());
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (const std::uint32_t part : runs[run].parts) {
      run_of[part] = run;
    }
  }
  std::vector<std::optional<double>> segments(resolved.parts.size());
  for (const auto& [part, sampling] :
       Estimator(resolved, runs, grid, {1, 1}, given).samplings(assembly)) {
    segments[part] = sampling.segments;
  }
  const auto joined = joined_parts(resolved);
  double triangles = 0;
  for (const auto& [a, b] : near_pairs(resolved, boxes, [&](std::uint32_t a, std::uint32_t b) {
         return run_of[a] != run_of[b] && segments[a] && segments[b] && !joined[a].contains(b);
       })) {
    triangles += kTrianglesPerSegment * (*segments[a] + *segments[b]);
  }
  return triangles;
}

}  // namespace dupin::assembly
