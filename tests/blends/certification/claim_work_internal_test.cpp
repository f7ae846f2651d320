#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "certification/claim_work.h"
#include "dupin/blends/certificate.h"

namespace dupin::certification {
namespace {

constexpr std::uint64_t kChecks = CertificateLimits::kWork;

// What one thread comes to that visits them in order.
WorkLeft in_order(std::size_t count, WorkLeft left,
                  const std::function<void(std::size_t, ClaimWork&)>& visit) {
  for (std::size_t i = 0; i < count; ++i) {
    ClaimWork work(left);
    visit(i, work);
    left = work.taken().rest_of(left);
  }
  return left;
}

void expect_same(std::size_t count, const WorkLeft& left,
                 const std::function<int(std::size_t, ClaimWork&)>& found_by) {
  std::vector<int> expected(count, -1), found(count, -1);
  const WorkLeft rest = in_order(
      count, left, [&](std::size_t i, ClaimWork& work) { expected[i] = found_by(i, work); });
  WorkLeft own = left;
  for_each_claim(count, own, [&](std::size_t i, ClaimWork& work) { found[i] = found_by(i, work); });
  EXPECT_EQ(found, expected);
  EXPECT_EQ(own.searches, rest.searches);
  EXPECT_EQ(own.checks, rest.checks);
  EXPECT_EQ(own.refused, rest.refused);
}

TEST(ClaimWork, of_searches_is_what_those_before_left) {
  // Each takes up to 10 units while there are any, and says how many; then half of the rest.
  const auto search = [](std::size_t i, ClaimWork& work) {
    int found = 0;
    while (found < 10 && !work.searches().is_used_up()) {
      work.searches().spend(1);
      ++found;
    }
    const std::uint64_t spent = work.searches().spent();
    while (i % 7 == 0 && work.searches().has_half_since(spent)) {
      work.searches().spend(1);
      ++found;
    }
    return 2 * found + (work.searches().has(5) ? 1 : 0);
  };
  for (const std::uint64_t units : {0, 1, 95, 1000, 100'000}) {
    expect_same(200, {units, kChecks}, search);
  }
}

TEST(ClaimWork, of_checks_is_what_those_before_left) {
  // A third spend more than they are allowed, a third less, and a third find that it is not so.
  const auto check = [](std::size_t i, ClaimWork& work) {
    work.allow_checks(3);
    const bool holds = work.holds(10, [&] {
      verification::spend(i % 3 == 0 ? 5 : 40);
      return i % 3 != 1;
    });
    const bool lacked = work.lacks_work();
    work.forget_lack();
    const bool again = work.holds(1, [&] {
      verification::spend(2);
      return true;
    });
    return 4 * int(holds) + 2 * int(lacked) + int(again);
  };
  for (const std::uint64_t units : {0, 1, 30, 200, 1000, 100'000}) {
    expect_same(200, {0, units}, check);
  }
}

TEST(ClaimWork, refused_has_an_end) {
  const auto check = [](std::size_t, ClaimWork& work) {
    return int(work.holds(100,
                          [&] {
                            verification::spend(kChecks);
                            return false;
                          })) +
           2 * int(work.holds(1, [] { return true; }));
  };
  for (const std::uint64_t refused : {std::uint64_t(0), 7 * kChecks, 9 * kChecks}) {
    expect_same(30, {0, kChecks, refused}, check);
    expect_same(30, {0, kChecks / 2, refused}, check);
  }
}

TEST(ClaimWork, throws_what_is_first) {
  WorkLeft left{10, kChecks};
  const auto visit = [](std::size_t i, ClaimWork& work) {
    work.searches().spend(1);
    if (i == 3 || i == 5) {
      throw Error(Errc::invalid_argument, std::to_string(i));
    }
    if (i > 3 && work.searches().is_used_up()) {
      throw Error(Errc::internal, "none left");
    }
  };
  try {
    for_each_claim(100, left, visit);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.message(), "3");
  }
}

}  // namespace
}  // namespace dupin::certification
