#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "certification/prove_loop_clearance.h"
#include "dupin/blends/certify.h"
#include "support/named_parts.h"

namespace dupin::certification {
namespace {

using test::fillet;
using test::pipe;

Assembly assembly(std::vector<Part> parts) {
  return {"d.json", Unit::millimetre, 0.05, {}, std::move(parts)};
}

const ClearanceClaim& claim_of(const Certificate& certificate, const std::string& first,
                               const std::string& second) {
  return *std::ranges::find_if(certificate.fillet_clearances, [&](const ClearanceClaim& claim) {
    return certificate.surface_name(claim.first) == first &&
           certificate.surface_name(claim.second) == second;
  });
}

// Every loop with every part but its pipes, and with every later loop.
TEST(ProveLoopClearance, tells_what_touches_fillets) {
  const Certificate certificate = certify(assembly({pipe("run", {-20, 0, 0}, {20, 0, 0}, 4),
                                                    pipe("branch", {-6, 0, 0}, {-6, 0, 12}, 2),
                                                    pipe("cross", {8, -12, 0}, {8, 12, 0}, 2.5),
                                                    fillet("throat", "run", "branch", 1),
                                                    fillet("throats", "run", "cross", 0.5),
                                                    {"flange", SphereAt{{-6, 0, 14}, 3}},
                                                    {"lug", SphereAt{{-3, 0, 4.5}, 0.8}}}));
  verify(certificate);
  EXPECT_TRUE(std::ranges::all_of(certificate.fillet_clearances, [](const ClearanceClaim& claim) {
    return claim.verdict == Verdict::proved;
  }));
  const std::size_t loops = 3, parts = 5;
  EXPECT_EQ(certificate.fillet_clearances.size(), loops * (parts - 2) + loops * (loops - 1) / 2);
  const ClearanceClaim& far = claim_of(certificate, "flange", "throat");
  EXPECT_FALSE(far.overlap);
  // From its lowest point to the highest of the fillet's feet, on the branch.
  const double foot = std::sqrt(25.0 - 0);
  EXPECT_GT(far.distance, 0.85 * (14 - 3 - foot));
  EXPECT_LT(far.distance, std::hypot(14 - foot, 2) - 3 + 1e-9);
  EXPECT_TRUE(claim_of(certificate, "lug", "throat").overlap);
  EXPECT_FALSE(claim_of(certificate, "lug", "throats").overlap);
  EXPECT_GT(claim_of(certificate, "throats", "throats").distance, 3);
  EXPECT_GT(claim_of(certificate, "throat", "throats").distance, 3);
}

}  // namespace
}  // namespace dupin::certification
