#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "certification/search_work.h"
#include "dupin/blends/certificate.h"
#include "verification/work.h"

namespace dupin::certification {

/// What the checker may look at for nothing, in all claims together.
constexpr std::uint64_t kMostRefused = 8 * CertificateLimits::kWork;

/// What is left for the claims to come: for searches, for the checker, and what that has looked at
/// for nothing.
struct WorkLeft {
  std::uint64_t searches = 0, checks = 0, refused = 0;
};

/// What was taken of it by a ClaimWork that has ended.
class WorkTaken {
 public:
  /// Whether all would have come out the same if so much had been left at the beginning.
  [[nodiscard]] bool is_same_with(const WorkLeft& left) const;
  /// What is left of it then.
  [[nodiscard]] WorkLeft rest_of(const WorkLeft& left) const;

 private:
  friend class ClaimWork;
  explicit WorkTaken(const WorkLeft& begun) : begun_(begun), searches_(begun.searches) {}

  WorkLeft begun_;
  SearchWork searches_;
  std::uint64_t least_checks_ = 0;                // that there have to be to begin with
  std::uint64_t checks_left_ = 0;                 // of those that there were
  std::uint64_t refused_ = 0;                     // besides what was refused before
  std::uint64_t refused_from_ = 0;                // of what was refused before, the least
  std::uint64_t refused_to_ = ~std::uint64_t(0);  // and the most
  bool ran_out_ = false;                          // a check did
};

/// The work on one claim, or a few of one part, which limits what this thread's checks may cost
/// while it lives.
class ClaimWork {
 public:
  explicit ClaimWork(const WorkLeft& left) : taken_(left), limit_(left.checks) {}

  [[nodiscard]] SearchWork& searches() { return taken_.searches_; }

  /// So much more for the checker, as for the numbers of a part's shape.
  void allow_checks(std::uint64_t units) { limit_.set_left(limit_.left() + units); }

  /// Whether the checker finds so, with `allowance` and what is left, or a share of that: one of
  /// so many. What it refuses costs the certificate nothing, for it is not claimed; but it took
  /// time, which has an end.
  [[nodiscard]] bool holds(std::uint64_t allowance, const std::function<bool()>& check,
                           std::uint64_t shares = 1);

  /// Whether it was work, not truth, that a check lacked since that was forgotten.
  [[nodiscard]] bool lacks_work() const { return lacks_work_; }
  void forget_lack() { lacks_work_ = false; }

  [[nodiscard]] WorkTaken taken() const;

 private:
  [[nodiscard]] bool has_refused_too_much();

  WorkTaken taken_;
  verification::WorkLimit limit_;
  bool lacks_work_ = false;
};

/// Calls `visit(index, work)` for all indices below `count`, by all threads, with the results of
/// one that visits them in order, each with what the one before left: what would have come out
/// otherwise with that, or threw, is visited again in its turn. The last visit of an index counts.
void for_each_claim(std::size_t count, WorkLeft& left,
                    const std::function<void(std::size_t, ClaimWork&)>& visit);

}  // namespace dupin::certification
