#pragma once

// The verifier: whether the claims of a certificate follow from its numbers. It is the part of the
// program that has to be believed, so it is small, shares only number types and plain values with
// the prover, and reads shapes again in its own way: bernstein.h and tube.h exactly, jet.h and
// motion.h in intervals. A part is discs that move, with centre y(t), unit normal n(t) and radius
// R(t); ' is d/dt. A claim comes with its leaves, stretches of t small enough that one look at
// intervals or signs of Bernstein coefficients settles each; verifying is to check that the leaves
// cover what is claimed and that each of them holds. Each kind of claim has a `follows` of its own.
// The lemmas and their proofs are in docs/certificate_format.md; the regularity condition
// 1 - kappa R > 0 is [MS06] eq. (11).

#include "verification/claims/fillet_claims.h"
#include "verification/claims/hub_claims.h"
#include "verification/claims/mesh_claim.h"
#include "verification/claims/pair_claims.h"
#include "verification/claims/regular_claim.h"
#include "verification/claims/tangency_claim.h"

namespace dupin::verification {

/// Where a part is joined to another. Rims apart reach at most the tolerance beyond the joint, or
/// are one in both. Throws Error{invalid_argument} if their rings differ there.
[[nodiscard]] std::vector<JoinedEnds> joints(const std::vector<Solid>& solids,
                                             const std::vector<CertifiedPart>& parts,
                                             std::uint32_t first, std::uint32_t second,
                                             double tolerance);

}  // namespace dupin::verification
