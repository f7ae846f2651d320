#pragma once

#include "dupin/blends/certificate.h"
#include "verification/solid.h"

namespace dupin::verification {

/// Whether the claim follows from the part's numbers.
[[nodiscard]] bool follows(const Solid& solid, const MeshClaim& claim);

}  // namespace dupin::verification
