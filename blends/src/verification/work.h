#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "dupin/blends/certificate.h"

namespace dupin::verification {

/// What the checks of this thread may cost while this lives: whoever wrote the certificate decides
/// how much is asked of them. A unit is about a microsecond.
class WorkLimit {
 public:
  explicit WorkLimit(std::uint64_t units);
  ~WorkLimit();
  WorkLimit(const WorkLimit&) = delete;
  WorkLimit& operator=(const WorkLimit&) = delete;

  [[nodiscard]] std::uint64_t left() const;
  void set_left(std::uint64_t units);
  /// The least that has been left since it began.
  [[nodiscard]] std::uint64_t least() const;
  void set_least(std::uint64_t units);

 private:
  std::uint64_t left_, least_;
  WorkLimit* outer_;
};

/// What a certificate's length allows its checks to cost: see CertificateLimits.
[[nodiscard]] std::uint64_t work_for(const Certificate& certificate);
/// The part of it for these numbers alone.
[[nodiscard]] std::uint64_t work_for(const std::vector<DiscPairs>& leaves);
[[nodiscard]] std::uint64_t work_for(const RegularClaim& claim);
[[nodiscard]] std::uint64_t work_for(const MeshClaim& claim);
/// The numbers of a loop of a fillet, and the leaves of a claim that it is regular.
[[nodiscard]] std::uint64_t work_for_loop();
[[nodiscard]] std::uint64_t work_for_arcs(const RegularClaim& claim);
/// The boxes of parts of which some have no claim about their clearance.
[[nodiscard]] std::uint64_t work_for_boxes(std::size_t parts);
[[nodiscard]] std::uint64_t work_for(const CertifiedPart& part, const PartClaims& claims);

/// Throws Error{limit_exceeded} where the limit does not allow it; without a limit all is allowed.
void spend(std::uint64_t units);

/// Whether `check(index)` is true of all indices below `count`, by all threads. What is found,
/// spent and thrown is what one thread would that asks them in order, up to the first that is not;
/// where the limit does not allow it, any of it may be left. All threads together, and the calls
/// that `check` makes, spend no more than twice what is left, but for a few units.
[[nodiscard]] bool holds_of_all(std::size_t count, const std::function<bool(std::size_t)>& check);

}  // namespace dupin::verification
