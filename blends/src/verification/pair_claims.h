#pragma once

#include <vector>

#include "dupin/blends/certificate.h"
#include "verification/solid.h"

namespace dupin::verification {

/// The ends at which two parts are joined.
struct JoinedEnds {
  End first = End::start, second = End::start;
};

/// Whether the claim says nothing besides its verdict: evidence for that alone, and a distance only
/// where one is proved.
[[nodiscard]] bool has_form(const EmbeddedClaim& claim);
[[nodiscard]] bool has_form(const ClearanceClaim& claim);

/// Whether a claim that is proved or refuted follows from the part's numbers; `regular` is known to
/// follow if it says that it is proved.
[[nodiscard]] bool follows(const Solid& solid, const EmbeddedClaim& claim,
                           const RegularClaim& regular);

/// Whether a claim that is proved or refuted follows from the numbers of both parts, whose rings at
/// the joints are the same.
[[nodiscard]] bool follows(const Solid& first, const Solid& second,
                           const std::vector<JoinedEnds>& joints, const ClearanceClaim& claim);

}  // namespace dupin::verification
