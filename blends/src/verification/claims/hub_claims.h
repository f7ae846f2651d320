#pragma once

#include <cstdint>

#include "dupin/blends/certificate.h"
#include "verification/solid.h"

// Whether what is claimed of the hubs of junctions follows. The lemma and its proof are in
// docs/certificate_format.md.

namespace dupin::verification {

/// Whether the part ends in a piece of a cyclide whose last sphere is the hub itself, bitwise: it
/// touches the hub along its last circle then.
[[nodiscard]] bool is_arm(const Solid& arm, const Sphere& hub);

/// Whether the caps of the hub within the last circles of two of its arms, on the side from which
/// these come, have no point in common. Takes so much work:
inline constexpr std::uint64_t kWorkOfCaps = 16;
[[nodiscard]] bool caps_are_disjoint(const Solid& one, const Solid& other);

/// Whether all circles of a stretch of an arm, but for its last one, lie outside of the hub.
[[nodiscard]] bool keeps_outside(const Solid& arm, const ParameterInterval& t, const Sphere& hub);

/// Whether the disc in which the arm begins has no point in the hub in front of the plane of the
/// arm's last circle. Circles alone would let the hub come in through there. Two looks, which are
/// not counted.
[[nodiscard]] bool begins_outside(const Solid& arm, const Sphere& hub);

/// Whether a claim that is proved, that an arm has nothing in common with its hub but the cap,
/// follows; the arm is the claim's first part, the hub, with the parameters [0, 1], the second.
[[nodiscard]] bool follows_at_hub(const Solid& arm, const Sphere& hub, const ClearanceClaim& claim);

/// Whether the claim about a hub's mesh follows.
[[nodiscard]] bool follows_of_hub(const Sphere& hub, const MeshClaim& claim);

}  // namespace dupin::verification
