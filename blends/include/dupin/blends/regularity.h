#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "dupin/blends/ringed_surface.h"

namespace dupin {

/// A part of a surface's parameter range [0, 1].
struct ParameterInterval {
  double from = 0, to = 1;
  friend bool operator==(const ParameterInterval&, const ParameterInterval&) = default;
};

/// How far a ringed surface is from folding: proven bounds of its margin, min over t of 1 - kappa R
/// [MS06] eq. (11), and where it is attained.
struct Regularity {
  double lower = 0;  ///< the margin is at least this: positive proves that no rings overlap locally
  double upper = 0;  ///< the margin is at most this: not positive disproves it
  ParameterInterval minimum;  ///< contains every t where the margin is attained
  /// violations(surface, 0)
  std::vector<ParameterInterval> folded;
  /// Where the spine's velocity could not be told from zero (lower is then minus infinity).
  std::vector<ParameterInterval> stops;
};

struct RegularityOptions {
  double width = 1e-6;  ///< aimed at for upper - lower, relative to max kappa R where that is > 1
};

/// Certified bounds of the margin: for polynomial radius laws by subdivision of exact rational
/// Bernstein polynomials of the stored numbers; for CyclideRadius with directed rounding of its
/// radii besides; for lines and (nominal) arcs in closed form, rounded outward.
[[nodiscard]] Regularity regularity(const RingedSurface& surface,
                                    const RegularityOptions& options = {});

/// Where the margin is missed: outside of these intervals 1 - kappa R > margin is proven, inside it
/// fails, up to their ends' last few bits. Disjoint, ascending.
[[nodiscard]] std::vector<ParameterInterval> violations(const RingedSurface& surface,
                                                        double margin);

enum class Verdict { proved, refuted, undecided };

/// The enumerator's name.
[[nodiscard]] std::string_view name(Verdict verdict);

/// The outcome of one subdivision proof of 1 - kappa R > margin on [0, 1].
struct MarginProof {
  Verdict verdict = Verdict::undecided;
  std::size_t leaves = 0;                 ///< subintervals on which the claim was proven
  int depth = 0;                          ///< of the deepest subinterval looked at
  std::vector<ParameterInterval> proven;  ///< these subintervals, ascending
  ParameterInterval where;  ///< refuted: holds the counterexample; undecided: where it failed
};

/// Proves or refutes the claim by Bernstein coefficients, without looking for the margin itself.
[[nodiscard]] MarginProof prove_margin(const RingedSurface& surface, double margin);

}  // namespace dupin
