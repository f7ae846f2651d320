#pragma once

#include <variant>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/kneecap.h"
#include "dupin/blends/ringed_surface.h"
#include "dupin/blends/ringed_tube.h"
#include "dupin/blends/sphere.h"
#include "dupin/blends/spline_pipe.h"

namespace dupin {

/// The geometry of a part.
using PartSurface = std::variant<RingedSurface, Sphere, EllipticTube, RationalRingedTube,
                                 SplinePipe, CyclideTube, KneecapChain>;

/// The ring of a part's port, its normal pointing out of the part; none where the part is closed.
[[nodiscard]] const Ring* port_ring(const PartSurface& surface, End end);

/// The pieces of a cyclide chain or blend; none of other surfaces.
[[nodiscard]] std::vector<PeArc> cyclide_pieces(const PartSurface& surface);

}  // namespace dupin
