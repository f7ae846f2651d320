#pragma once

#include "dupin/blends/certificate.h"
#include "verification/solid.h"

namespace dupin::verification {

/// Whether the claim says nothing besides its verdict: evidence for that alone, numbers in range.
[[nodiscard]] bool has_form(const Solid& solid, const RegularClaim& claim);

/// Whether a claim that is proved or refuted follows from the part's numbers.
[[nodiscard]] bool follows(const Solid& solid, const RegularClaim& claim);

}  // namespace dupin::verification
