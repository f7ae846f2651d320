#include "certification/claim_work.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <vector>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin::certification {

// Where checks ran out of work, they would have had they had less.
bool WorkTaken::is_same_with(const WorkLeft& left) const {
  return left.checks >= least_checks_ && (!ran_out_ || left.checks <= begun_.checks) &&
         searches_.is_same_with(left.searches) && refused_from_ <= left.refused &&
         left.refused <= refused_to_;
}

WorkLeft WorkTaken::rest_of(const WorkLeft& left) const {
  return {left.searches - std::min(left.searches, searches_.spent()),
          left.checks + checks_left_ - begun_.checks, left.refused + refused_};
}

// What runs out of work is taken to have had all that a certificate may take, or that share of it:
// not to depend on what those before left.
bool ClaimWork::holds(std::uint64_t allowance, const std::function<bool()>& check,
                      std::uint64_t shares) {
  if (allowance > 0 && has_refused_too_much()) {
    return false;
  }
  const std::uint64_t before = limit_.left(), most = before / shares + allowance;
  const verification::WorkLimit own(most);
  bool holds = false;
  try {
    holds = check();
  } catch (const Error& error) {
    if (error.code() != Errc::limit_exceeded) {
      throw;
    }
    taken_.ran_out_ = lacks_work_ = true;
    taken_.refused_ += CertificateLimits::kWork / shares + allowance;
    return false;
  }
  const std::uint64_t spent = most - own.left();
  const std::uint64_t beyond = spent - std::min(spent, allowance);
  limit_.set_least(std::min(limit_.least(), before - shares * beyond));
  if (holds) {
    limit_.set_left(before + allowance - spent);
  } else {
    taken_.refused_ += spent;
  }
  return holds;
}

bool ClaimWork::has_refused_too_much() {
  if (taken_.begun_.refused + taken_.refused_ > kMostRefused) {
    const std::uint64_t own = std::min(kMostRefused + 1, taken_.refused_);
    taken_.refused_from_ = std::max(taken_.refused_from_, kMostRefused + 1 - own);
    return true;
  }
  taken_.refused_to_ = std::min(taken_.refused_to_, kMostRefused - taken_.refused_);
  return false;
}

WorkTaken ClaimWork::taken() const {
  WorkTaken result = taken_;
  result.checks_left_ = limit_.left();
  result.least_checks_ = taken_.begun_.checks - std::min(taken_.begun_.checks, limit_.least());
  return result;
}

namespace {

using Visit = std::function<void(std::size_t, ClaimWork&)>;

WorkTaken visited(std::size_t index, const WorkLeft& left, const Visit& visit) {
  ClaimWork work(left);
  visit(index, work);
  return work.taken();
}

// A little more than there is: what others leave of their allowances is added to it.
WorkLeft left_ahead(const WorkLeft& left) {
  constexpr std::uint64_t kShare = 8;
  return {left.searches, left.checks + left.checks / kShare, left.refused};
}

// Some that were visited ahead of their turn, from `begin` on, with what is left before the first
// of them; none in place of what threw. They end where they have taken what there is together.
std::vector<std::optional<WorkTaken>> visited_ahead(std::size_t begin, std::size_t count,
                                                    const WorkLeft& left, const Visit& visit) {
  std::vector<std::optional<WorkTaken>> result(count);
  const WorkLeft ahead = left_ahead(left);
  std::atomic<std::size_t> next = 0;
  std::atomic<std::uint64_t> searches = 0, checks = 0;
  for_each_in_parallel(count, [&](std::size_t) {
    if (searches > left.searches || checks > left.checks) {
      return;
    }
    const std::size_t i = next++;
    try {
      result[i] = visited(begin + i, ahead, visit);
      const WorkLeft rest = result[i]->rest_of(ahead);
      searches += ahead.searches - rest.searches;
      checks += rest.refused - ahead.refused + ahead.checks - std::min(ahead.checks, rest.checks);
    } catch (const Error&) {
      return;  // thrown again in its turn, if it is thrown then
    }
  });
  result.resize(next);
  return result;
}

}  // namespace

void for_each_claim(std::size_t count, WorkLeft& left, const Visit& visit) {
  constexpr std::size_t kAtOnce = 1 << 12;
  for (std::size_t begin = 0; begin < count;) {
    const auto ahead = visited_ahead(begin, std::min(kAtOnce, count - begin), left, visit);
    for (const auto& taken : ahead) {
      left =
          (taken && taken->is_same_with(left) ? *taken : visited(begin, left, visit)).rest_of(left);
      ++begin;
    }
  }
}

}  // namespace dupin::certification
