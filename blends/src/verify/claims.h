#pragma once

#include <vector>

#include "dupin/blends/certificate.h"
#include "tube.h"

namespace dupin::verifier {

/// Whether a claim that is proved or refuted follows from the certificate's inputs.
[[nodiscard]] bool follows(const Tube& tube, const RegularClaim& claim);
[[nodiscard]] bool follows(const Tube& tube, const TangencyClaim& claim, bool at_end);
[[nodiscard]] bool follows(const std::vector<CertifiedPart>& parts, const CertifiedPart& part,
                           const EmbeddedClaim& claim, const RegularClaim& regular);
[[nodiscard]] bool follows(const std::vector<CertifiedPart>& parts, const ClearanceClaim& claim);

}  // namespace dupin::verifier
