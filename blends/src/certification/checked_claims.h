#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "verification/claims.h"
#include "verification/loop_clearance.h"
#include "verification/near_parts.h"
#include "verification/work.h"

namespace dupin::certification {

/// Claims as the checker will believe them. It bounds things in another way than the prover, and
/// does no more work than a certificate's length allows: a claim that does not follow for it, as
/// little as it may lack, is made weaker or left undecided.
class CheckedClaims {
 public:
  /// The next part. Throws Error{invalid_argument} for one whose numbers no certificate holds.
  void read(const CertifiedPart& part);

  /// Before all else: what the checker looks at of junctions besides their claims. Throws
  /// Error{limit_exceeded} if that is more than a certificate may cost.
  void reserve_for(const std::vector<CertifiedJunction>& junctions);

  /// The next loop of a fillet, which outlives this. What does not follow is undecided, but for
  /// the contact, which does.
  [[nodiscard]] LoopClaims agreed(const CanalFillet& loop, LoopClaims claims);
  [[nodiscard]] const std::vector<verification::LoopArcs>& loops() const { return loops_; }

  [[nodiscard]] const verification::Solid& solid(std::uint32_t part) const { return solids_[part]; }

  /// Of the mesh of a hub, for which a bound is found.
  [[nodiscard]] std::optional<MeshClaim> agreed_of_hub(MeshClaim claim, const Sphere& hub);
  /// Of an arm and its hub.
  [[nodiscard]] ClearanceClaim agreed_at_hub(ClearanceClaim claim);

  // About the part that was read last.
  [[nodiscard]] RegularClaim agreed(RegularClaim claim);
  [[nodiscard]] EmbeddedClaim agreed(EmbeddedClaim claim, const RegularClaim& regular);
  /// Whether it was work, not truth, that the last claim lacked.
  [[nodiscard]] bool lacks_work() const { return lacks_work_; }
  /// Throws Error{invalid_argument} if the ring is further from its disc than the tolerance, and
  /// Error{limit_exceeded} if there is no work left to tell.
  [[nodiscard]] TangencyClaim agreed(TangencyClaim claim, std::size_t piece, End end,
                                     double tolerance);

  /// The pairs of parts that need a claim of their own where all others are claimed to be so far
  /// from each other; none: to tell takes too much work.
  [[nodiscard]] std::optional<std::vector<verification::PartPair>> pairs_nearer_than(
      double distance);

  /// The same of pairs of a part and a loop, or two loops.
  [[nodiscard]] std::optional<std::vector<verification::PartPair>> loop_pairs_nearer_than(
      double distance);

  /// None: undecided.
  [[nodiscard]] std::optional<MeshClaim> agreed(MeshClaim claim, std::uint32_t part);
  [[nodiscard]] ClearanceClaim agreed(ClearanceClaim claim,
                                      const std::vector<CertifiedPart>& parts);
  /// Of a part and a loop, or two loops: surfaces, parts first.
  [[nodiscard]] ClearanceClaim agreed(ClearanceClaim claim);

 private:
  template <class Follows>
  ClearanceClaim nearer(ClearanceClaim claim, const Follows& follows);

  template <class Check>
  bool holds(std::uint64_t allowance, const Check& check);

  verification::WorkLimit limit_{CertificateLimits::kWork};
  std::uint64_t refused_work_ = 0;
  bool lacks_work_ = false;
  std::vector<verification::Solid> solids_;
  std::vector<verification::LoopArcs> loops_;
  std::vector<std::string> names_;
};

}  // namespace dupin::certification
