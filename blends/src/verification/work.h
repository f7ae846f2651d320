#pragma once

#include <cstddef>
#include <cstdint>
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

 private:
  std::uint64_t left_;
  WorkLimit* outer_;
  friend void spend(std::uint64_t units);
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

}  // namespace dupin::verification
