#pragma once

#include "dupin/blends/certificate.h"

namespace dupin::certification {

/// Upper bounds of how far a piece's end is from the ring stored there.
[[nodiscard]] TangencyClaim end_tangency(const CertifiedPiece& piece, End end);

}  // namespace dupin::certification
