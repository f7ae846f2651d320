#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "verification/work.h"

namespace dupin::verification {
namespace {

TEST(Work, without_a_limit_is_free) { EXPECT_NO_THROW(spend(~std::uint64_t(0))); }

TEST(Work, is_counted_by_the_innermost_limit) {
  const WorkLimit outer(100);
  spend(40);
  EXPECT_EQ(outer.left(), 60U);
  {
    const WorkLimit inner(10);
    EXPECT_NO_THROW(spend(10));
    EXPECT_THROW(spend(1), Error);
    EXPECT_EQ(inner.left(), 0U);
  }
  EXPECT_NO_THROW(spend(60));
  EXPECT_THROW(spend(1), Error);
}

TEST(Work, that_is_refused_is_not_spent) {
  WorkLimit limit(5);
  EXPECT_THROW(spend(6), Error);
  EXPECT_EQ(limit.left(), 5U);
  limit.set_left(7);
  EXPECT_NO_THROW(spend(7));
}

TEST(Work, remembers_the_least_that_was_left) {
  WorkLimit limit(10);
  spend(4);
  limit.set_left(9);
  spend(1);
  EXPECT_EQ(limit.left(), 8U);
  EXPECT_EQ(limit.least(), 6U);
}

TEST(Work, for_boxes_of_parts_is_allowed_once_where_there_is_no_fillet) {
  Certificate certificate;
  certificate.parts.resize(2);
  certificate.apart = 1;
  const std::uint64_t boxes = work_for(certificate) - CertificateLimits::kWork;
  EXPECT_GT(boxes, 0U);
  certificate.fillets.resize(1);
  certificate.fillets[0].loops.resize(1);
  EXPECT_EQ(work_for(certificate) - CertificateLimits::kWork, boxes + boxes / 2 * 3);
}

TEST(Work, that_a_certificate_allows_is_linear_in_its_numbers) {
  Certificate certificate;
  EXPECT_EQ(work_for(certificate), CertificateLimits::kWork);
  certificate.parts.resize(1);
  certificate.parts[0].shape = Chain{};
  certificate.claims.resize(1);
  certificate.claims[0].regular.emplace();
  certificate.claims[0].embedded.emplace();
  certificate.claims[0].mesh.emplace();
  EXPECT_EQ(work_for(certificate), CertificateLimits::kWork);
  certificate.claims[0].regular->leaves.resize(3);
  certificate.claims[0].embedded->leaves.resize(5);
  certificate.claims[0].mesh->knots.resize(7);
  certificate.clearances.resize(2);
  certificate.clearances[1].leaves.resize(11);
  EXPECT_EQ(work_for(certificate), CertificateLimits::kWork + CertificateLimits::kWorkPerNumber *
                                                                  (2 * 3 + 6 * 5 + 7 + 6 * 11));
}

// It is asked before anything is admitted.
TEST(Work, is_allowed_for_parts_that_have_claims_and_claims_that_have_parts) {
  Certificate certificate;
  certificate.parts.resize(1);
  certificate.parts[0].shape = Chain(std::vector<RingedSurface>(1));
  EXPECT_EQ(work_for(certificate), CertificateLimits::kWork);
  certificate.claims.resize(1);
  EXPECT_GT(work_for(certificate), CertificateLimits::kWork);
}

// What one thread comes to that asks in order: whether it holds, what is left but where that did
// not do, and what was thrown.
struct Outcome {
  bool holds = false;
  std::uint64_t left = 0;
  std::string thrown;
  bool operator==(const Outcome&) const = default;
};

template <class All>
Outcome outcome(std::uint64_t units, const All& all) {
  const WorkLimit limit(units);
  Outcome result;
  try {
    result.holds = all();
  } catch (const Error& error) {
    result.thrown = error.message();
    if (error.code() == Errc::limit_exceeded) {
      return result;
    }
  }
  result.left = limit.left();
  return result;
}

TEST(Work, of_many_threads_is_that_of_one) {
  constexpr std::size_t kCount = 1000;
  for (const std::size_t fails : {kCount, std::size_t(0), std::size_t(17), std::size_t(990)}) {
    for (const std::size_t throws : {kCount, std::size_t(16), std::size_t(600)}) {
      for (const std::uint64_t units : {0, 10, 400, 2000, 100'000}) {
        const auto check = [&](std::size_t i) {
          spend(i % 5);
          if (i == throws || i == throws + 20) {
            throw Error(Errc::invalid_argument, std::to_string(i));
          }
          return i < fails;
        };
        const Outcome expected = outcome(units, [&] {
          std::size_t i = 0;
          while (i < kCount && check(i)) {
            ++i;
          }
          return i == kCount;
        });
        EXPECT_EQ(outcome(units, [&] { return holds_of_all(kCount, check); }), expected)
            << fails << " " << throws << " " << units;
      }
    }
  }
  EXPECT_TRUE(holds_of_all(0, [](std::size_t) { return false; }));
}

// Three deep, as bands of pieces of parts are.
constexpr std::size_t kParts = 5, kPieces = 70, kBands = 90;

template <class Check>
bool bands_hold(const Check& check, bool by_all_threads) {
  const auto all = [&](std::size_t count, const std::function<bool(std::size_t)>& holds) {
    std::size_t i = 0;
    while (!by_all_threads && i < count && holds(i)) {
      ++i;
    }
    return by_all_threads ? holds_of_all(count, holds) : i == count;
  };
  return all(kParts, [&](std::size_t part) {
    return all(kPieces, [&](std::size_t piece) {
      return all(kBands, [&](std::size_t band) { return check(part, piece, band); });
    });
  });
}

TEST(Work, on_bands_of_pieces_of_parts_is_that_of_one) {
  std::mt19937 random(4);
  const auto place = [&] { return std::array<std::size_t, 3>{random() % 6, random() % 80, 0}; };
  for (int i = 0; i < 60; ++i) {
    const auto fails = place(), throws = place(), costs = place();
    const std::uint64_t units = random() % 3'000'000;
    const auto check = [&](std::size_t part, std::size_t piece, std::size_t band) {
      spend(band + 1);
      const std::array<std::size_t, 3> at{part, piece, band};
      if (at == costs) {
        spend(500'000);
      }
      if (at == throws) {
        throw Error(Errc::invalid_argument, "it throws");
      }
      return at != fails;
    };
    EXPECT_EQ(outcome(units, [&] { return bands_hold(check, true); }),
              outcome(units, [&] { return bands_hold(check, false); }))
        << i;
  }
}

// Whoever forges a certificate decides where it ends.
TEST(Work, of_many_threads_is_bounded_together_wherever_it_ends) {
  constexpr std::uint64_t kUnits = 400'000, kUnsaid = 100'000;  // a thousand of each thread
  for (const std::size_t dear : {std::size_t(0), std::size_t(1), kParts}) {
    for (const std::uint64_t dear_band : {500, 2'000, 20'000}) {
      std::atomic<std::uint64_t> asked = 0;
      const Outcome found = outcome(kUnits, [&] {
        return bands_hold(
            [&](std::size_t part, std::size_t, std::size_t) {
              for (std::uint64_t i = 0; i < (part == dear || dear == kParts ? dear_band : 1); ++i) {
                spend(10);
                asked += 10;
              }
              return true;
            },
            true);
      });
      EXPECT_NE(found.thrown.find("more work"), std::string::npos);
      EXPECT_LE(asked, 2 * kUnits + kUnsaid);
    }
  }
}

}  // namespace
}  // namespace dupin::verification
