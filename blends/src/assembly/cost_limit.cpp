#include "assembly/cost_limit.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include "assembly/part_context.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "surfaces/mesh_cost.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin::assembly {
namespace {

using surfaces::MeshCost;
using tessellation::count_text;

constexpr double kUncounted = std::numeric_limits<double>::infinity();

struct Limit {
  double triangles, pairs;

  /// How much of it is used up; more than 1 is too much.
  [[nodiscard]] double share(const MeshCost& cost) const {
    return std::max(cost.triangles / triangles, cost.pairs / pairs);
  }
};

struct Estimate {
  MeshCost all, worst;  // worst: of the part that asks for most
  std::uint32_t part = 0, segments = 0;

  void add(const MeshCost& cost, std::uint32_t of, std::uint32_t around, const Limit& limit) {
    all.triangles += cost.triangles;
    all.pairs += cost.pairs;
    if (limit.share(cost) > limit.share(worst)) {
      worst = cost;
      part = of;
      segments = around;
    }
  }
};

class Estimator {
 public:
  Estimator(const ResolvedAssembly& resolved, std::span<const WeldedRun> runs, double grid,
            const Limit& limit)
      : resolved_(resolved), runs_(runs), grid_(grid), limit_(limit) {}

  [[nodiscard]] Estimate of(const Assembly& assembly) const {
    Estimate result;
    for (const WeldedRun& run : runs_) {
      const auto sampling = sampling_of(assembly, run);
      for (const std::uint32_t part : run.parts) {
        if (sampling) {
          result.add(cost_of(assembly, part, *sampling), part, sampling->segments, limit_);
        } else {
          result.add({kUncounted, 0}, part, 0, limit_);
        }
      }
    }
    return result;
  }

  /// The same document's least tolerance that is not too costly, to two digits.
  [[nodiscard]] std::optional<double> tolerance_that_would_do(Assembly assembly) const {
    const auto would_do = [&](double tolerance) {
      assembly.tolerance = tolerance;
      return limit_.share(of(assembly).all) <= 1;
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

 private:
  // None for more segments than a ring may have.
  [[nodiscard]] std::optional<RingSampling> sampling_of(const Assembly& assembly,
                                                        const WeldedRun& run) const {
    try {
      return run_sampling(assembly, resolved_, run, 0, grid_);
    } catch (const Error& error) {
      if (error.code() != Errc::limit_exceeded) {
        throw;
      }
      return std::nullopt;
    }
  }

  [[nodiscard]] MeshCost cost_of(const Assembly& assembly, std::uint32_t part,
                                 const RingSampling& sampling) const {
    return with_part_context(assembly, resolved_.parts[part].index, [&] {
      return std::visit(
          [&](const auto& shape) {
            return surfaces::mesh_cost(shape, sampling, assembly.tolerance);
          },
          resolved_.parts[part].shape);
    });
  }

  const ResolvedAssembly& resolved_;
  std::span<const WeldedRun> runs_;
  double grid_;
  Limit limit_;
};

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
    return text + "about " + count_text(estimate.all.triangles) + " triangles" +
           shared(estimate.all.triangles, estimate.worst.triangles) + "; the limit is " +
           count_text(limit.triangles);
  }
  return text + std::to_string(estimate.segments) +
         " segments around this part, whose triangles lie side by side: about " +
         count_text(estimate.all.pairs) + " pairs to compare" +
         shared(estimate.all.pairs, estimate.worst.pairs) + "; the limit is " +
         count_text(limit.pairs);
}

}  // namespace

void refuse_too_costly(const Assembly& assembly, const ResolvedAssembly& resolved,
                       std::span<const WeldedRun> runs, double grid, std::size_t most) {
  const Limit limit{double(most), kPairsPerTriangle * double(most)};
  const Estimator estimator(resolved, runs, grid, limit);
  const Estimate estimate = estimator.of(assembly);
  if (limit.share(estimate.all) <= 1) {
    return;
  }
  const auto enough = estimator.tolerance_that_would_do(assembly);
  const ResolvedPart& part = resolved.parts[estimate.part];
  throw Error(
      Errc::limit_exceeded,
      what_is_asked_for(assembly, estimate, limit) +
          (enough ? "; a tolerance of " + decimal(*enough, 2) + " would do, or a higher limit"
                  : std::string("; fewer segments would do, smaller parts, or a higher limit")),
      part.name, document_place(assembly, part.index));
}

double expected_triangles(const Assembly& assembly, const ResolvedAssembly& resolved,
                          std::span<const WeldedRun> runs, double grid) {
  return Estimator(resolved, runs, grid, {1, 1}).of(assembly).all.triangles;
}

}  // namespace dupin::assembly
