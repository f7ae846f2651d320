#pragma once

#include "dupin/blends/certificate.h"
#include "verification/solid.h"

namespace dupin::verification {

/// Whether the claim follows from the numbers of the piece, at its start or its end.
[[nodiscard]] bool follows(const Piece& piece, const TangencyClaim& claim, End end);

/// Whether what the other claims leave out at the joints is less than the tolerance and than the
/// ring is wide: how far the piece is off, all along its size, because it does not begin or end as
/// its ring says.
[[nodiscard]] bool is_near(const TangencyClaim& claim, const Ring& ring, double size_of_piece,
                           double tolerance);

}  // namespace dupin::verification
