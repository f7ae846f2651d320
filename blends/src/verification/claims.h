#pragma once

#include <array>
#include <vector>

#include "dupin/blends/certificate.h"
#include "verification/solid.h"

namespace dupin::verification {

/// The ends at which two parts are joined.
struct JoinedEnds {
  End first, second;
};

/// Whether a claim that is proved or refuted follows from the certificate's inputs.
[[nodiscard]] bool follows(const Solid& solid, const RegularClaim& claim);
[[nodiscard]] bool follows(const Piece& piece, const TangencyClaim& claim, End end);
[[nodiscard]] bool follows(const Solid& solid, const EmbeddedClaim& claim,
                           const RegularClaim& regular);
[[nodiscard]] bool follows(const Solid& first, const Solid& second,
                           const std::vector<JoinedEnds>& joints, const ClearanceClaim& claim);
[[nodiscard]] bool follows(const Solid& solid, const MeshClaim& claim);

}  // namespace dupin::verification
