#include <cstdint>
#include <limits>

#include "blends/random_blends.h"

namespace dupin {
namespace {

TEST(Certificate, never_claims_embedded_what_meets_itself) { test::compare_prover_and_mesh(1, 40); }

TEST(Certificate, holds_whatever_work_its_searches_may_take) {
  const auto pipe = [](const std::string& name, const Vec3& from, const Vec3& to) {
    return Part{name, PipeBetween{from, to, 1}};
  };
  const Assembly assembly{
      "pipes.json",
      Unit::millimetre,
      0.05,
      {},
      {pipe("one", Vec3(-5, 0, 0), Vec3(5, 0, 0)), pipe("across", Vec3(0, -5, 1), Vec3(0, 5, 1)),
       pipe("far", Vec3(0, 0, 9), Vec3(5, 0, 9)),
       pipe("crossed", Vec3(3, -5, 0.5), Vec3(3, 5, 0.5))}};
  const Certificate found = certify(assembly), first_looks = certify(assembly, {.work = 0});
  verify(found);
  verify(first_looks);
  EXPECT_EQ(found.findings(), 0U);
  const auto all = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(certify(assembly, {.work = all}).findings(), 0U) << "no limit";
  EXPECT_EQ(first_looks.findings(), 2U) << "those that overlap";
  // The far one is the third.
  for (const std::size_t i : {1U, 3U, 5U}) {
    EXPECT_EQ(first_looks.clearances[i].verdict, Verdict::proved);
  }
}

}  // namespace
}  // namespace dupin
