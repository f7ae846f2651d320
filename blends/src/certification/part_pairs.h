#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dupin/blends/certificate.h"
#include "verification/claims/near_parts.h"

namespace dupin::certification {

using verification::PartPair;

/// Of so many parts, in the order of certificates.
[[nodiscard]] std::vector<PartPair> all_pairs(std::uint32_t parts);

/// The places of pairs in the order in which their claims are looked for, so that those that take
/// much are left when the work is used up: joined ones first, then those that their boxes show to
/// be the farthest apart.
[[nodiscard]] std::vector<std::size_t> easiest_first(const std::vector<PartPair>& pairs,
                                                     const std::vector<CertifiedPart>& parts);

}  // namespace dupin::certification
