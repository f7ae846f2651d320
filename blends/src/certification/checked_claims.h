#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certification/claim_work.h"
#include "verification/claims/claims.h"
#include "verification/claims/loop_clearance.h"
#include "verification/claims/near_parts.h"

// Claims as the checker will believe them. It bounds things in another way than the prover, and
// does no more work than a certificate's length allows: a claim that does not follow for it, as
// little as it may lack, is made weaker or left undecided.

namespace dupin::certification {

using verification::LoopArcs;
using verification::Solid;

/// Of what is left: what the checker looks at of junctions besides their claims. Throws
/// Error{limit_exceeded} if that is more than a certificate may cost.
void reserve_for(const std::vector<CertifiedJunction>& junctions, WorkLeft& left);

/// The part, whose numbers are work for the checker. Throws Error{invalid_argument} for one whose
/// numbers no certificate holds.
[[nodiscard]] Solid admitted(const CertifiedPart& part, ClaimWork& work);

[[nodiscard]] RegularClaim agreed(RegularClaim claim, const Solid& solid, ClaimWork& work);
/// Of a part that is regular.
[[nodiscard]] EmbeddedClaim agreed(EmbeddedClaim claim, const RegularClaim& regular,
                                   const Solid& solid, ClaimWork& work);

/// The end of a piece of a part.
struct PieceEnd {
  std::size_t piece = 0;
  End end = End::start;
};

/// Throws Error{invalid_argument} if the ring is further from its disc than the tolerance, and
/// Error{limit_exceeded} if there is no work left to tell.
[[nodiscard]] TangencyClaim agreed(TangencyClaim claim, const PieceEnd& at, double tolerance,
                                   const Solid& solid, const std::string& name, ClaimWork& work);

/// A share that is added to the error of a mesh, and of how many shares of the work that is left
/// one may be taken to check it.
struct MeshRoom {
  double share;
  std::uint64_t of_work;
};
struct MeshRooms {
  std::vector<MeshRoom> all;
  bool end_without_work = false;  ///< what lacks work for one is not tried with another
};

/// A tight bound may have part of the work, for there are claims to come; one that is not as tight
/// takes little.
[[nodiscard]] MeshRooms first_rooms();
/// Of one mesh of many, whose error is this share of the tolerance: tight if that takes next to no
/// work, or else within the tolerance, which takes far less than a tight bound.
[[nodiscard]] MeshRooms rooms_of_many(double share);
/// Of an error of this share of the tolerance: within that, if the tightest of them is not.
[[nodiscard]] MeshRooms last_rooms(double share);

/// None: undecided.
[[nodiscard]] std::optional<MeshClaim> agreed(MeshClaim claim, const Solid& solid,
                                              const MeshRooms& rooms, ClaimWork& work);
/// Of the mesh of a hub, for which a bound is found.
[[nodiscard]] std::optional<MeshClaim> agreed_of_hub(MeshClaim claim, const Sphere& hub,
                                                     ClaimWork& work);

/// A loop of a fillet, which outlives what is read of it. What does not follow is undecided. Throws
/// Error{invalid_argument} where it is found that the ball touches beyond the ends of the pipes.
[[nodiscard]] LoopClaims agreed(LoopClaims claims, LoopArcs& loop,
                                const verification::RolledPipes& pipes, double tolerance,
                                ClaimWork& work);

/// The pairs of parts that need a claim of their own where all others are claimed to be so far
/// from each other; none: to tell takes too much work.
[[nodiscard]] std::optional<std::vector<verification::PartPair>> pairs_nearer_than(
    double distance, const verification::BoxAxes& axes, const std::vector<Solid>& solids,
    ClaimWork& work);
/// The same of pairs of a part and a loop, or two loops.
[[nodiscard]] std::optional<std::vector<verification::PartPair>> loop_pairs_nearer_than(
    double distance, const verification::BoxAxes& axes, const std::vector<Solid>& solids,
    const std::vector<LoopArcs>& loops, ClaimWork& work);

[[nodiscard]] ClearanceClaim agreed(ClearanceClaim claim, const std::vector<CertifiedPart>& parts,
                                    const std::vector<Solid>& solids, double tolerance,
                                    ClaimWork& work);
/// Of an arm and its hub.
[[nodiscard]] ClearanceClaim agreed_at_hub(ClearanceClaim claim, const std::vector<Solid>& solids,
                                           ClaimWork& work);
/// Of a part and a loop, or two loops: surfaces, parts first.
[[nodiscard]] ClearanceClaim agreed(ClearanceClaim claim, const std::vector<Solid>& solids,
                                    const std::vector<LoopArcs>& loops, ClaimWork& work);

}  // namespace dupin::certification
