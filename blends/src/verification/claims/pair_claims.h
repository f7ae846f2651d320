#pragma once

#include <vector>

#include "dupin/blends/certificate.h"
#include "numbers/interval.h"
#include "verification/solid.h"

namespace dupin::verification {

/// The ends at which two parts are joined.
struct JoinedEnds {
  End first = End::start, second = End::start;
  /// Their rims do not reach into the other part.
  bool have_rims_apart = true;
};

/// Whether the claim says nothing besides its verdict: evidence for that alone, and a distance only
/// where one is proved.
[[nodiscard]] bool has_form(const EmbeddedClaim& claim);
[[nodiscard]] bool has_form(const ClearanceClaim& claim);

/// An upper bound of x.w for the points of the discs of a stretch, of so many cells, and of the
/// balls of the joints with kneecaps that it touches; infinite where the numbers do not tell.
[[nodiscard]] double furthest(const Solid& solid, const ParameterInterval& t,
                              const numbers::IntervalVec& w, int cells);

/// Whether all points of a box are inside: the discs' planes pass them within the stretch, and they
/// are nearer than the radii then. The part is one that is full.
[[nodiscard]] bool crosses(const Solid& solid, const ParameterInterval& t,
                           const numbers::IntervalVec& box);

/// Whether it is a stretch of one piece, or of a ball, or a run of whole pieces.
[[nodiscard]] bool has_leaf(const Solid& solid, const ParameterInterval& t);

/// Whether a claim that is proved or refuted follows from the part's numbers; `regular` is known to
/// follow if it says that it is proved.
[[nodiscard]] bool follows(const Solid& solid, const EmbeddedClaim& claim,
                           const RegularClaim& regular);

/// Whether a claim that is proved or refuted follows from the numbers of both parts, whose rings at
/// the joints are the same.
[[nodiscard]] bool follows(const Solid& first, const Solid& second,
                           const std::vector<JoinedEnds>& joints, const ClearanceClaim& claim);

}  // namespace dupin::verification
