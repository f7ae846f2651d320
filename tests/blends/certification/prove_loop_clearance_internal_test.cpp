#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "certification/prove_loop_clearance.h"
#include "dupin/blends/certify.h"
#include "dupin/kernel/error.h"
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

// Equal pipes, of which two end opposite in the third: the loops meet in the corners, where each
// touches the end of the other's branch.
TEST(ProveLoopClearance, tells_what_meets_in_corners) {
  for (const double degrees : {90., 60., 35.}) {
    for (const double far : {0., 1.7e6}) {
      const double angle = degrees * std::numbers::pi / 180;
      const Vec3 at = far * Vec3(1, -0.3, 0.123),
                 along = far > 0 ? Vec3(1, 2, -0.5).normalized() : Vec3(1, 0, 0),
                 across = std::cos(angle) * along + std::sin(angle) * along.unitOrthogonal();
      const Certificate certificate = certify(
          assembly({pipe("run", at - 60 * along, at + 60 * along, 4),
                    pipe("there", at, at + 60 * across, 4), pipe("back", at, at - 60 * across, 4),
                    fillet("throat", "run", "there", 0.6), fillet("other", "run", "back", 0.5)}));
      verify(certificate);
      EXPECT_EQ(certificate.findings(), 0U) << degrees << ' ' << far;
      for (const auto& loops : certificate.fillet_claims) {
        EXPECT_LT(loops.front().contact.value().offset, 1e-13 * (1 + far) * 60)
            << "whatever the angle is";
      }
      ASSERT_EQ(certificate.fillet_clearances.size(), 3U);
      for (const ClearanceClaim& claim : certificate.fillet_clearances) {
        EXPECT_EQ(claim.distance, 0);
        EXPECT_GT(claim.corner, 0);
        EXPECT_LT(claim.corner, 1e-13 * (1 + far) * 60);
      }
    }
  }
}

Assembly header(int branches) {
  std::vector<Part> parts{pipe("run", {-10, 0, 0}, {10. * branches, 0, 0}, 4)};
  for (int i = 0; i < branches; ++i) {
    const std::string name = std::to_string(i);
    parts.push_back(pipe(name, {10. * i, 0, 0}, {10. * i, 0, 12}, 2));
    parts.push_back(fillet("throat-" + name, "run", name, 0.5));
  }
  return assembly(std::move(parts));
}

// Of what is near: what is written grows with the parts, not with their pairs.
TEST(ProveLoopClearance, lists_neighbours_only_where_the_rest_is_apart) {
  const auto near = [](int branches) { return certify(header(branches), {.apart = 6}); };
  const Certificate five = near(5), ten = near(10);
  EXPECT_NO_THROW(verify(five));
  EXPECT_NO_THROW(verify(ten));
  // A loop with both neighbours' pipes and loops.
  EXPECT_EQ(five.fillet_clearances.size(), 3U * 4);
  EXPECT_EQ(ten.fillet_clearances.size(), 3U * 9);
  EXPECT_EQ(five.findings(), 0U);
  // As before there may be more claims than have to.
  const Certificate all = certify(header(5), {.apart = 0});
  EXPECT_EQ(all.fillet_clearances.size(), 5U * 4 + 5 * 4 / 2);
  Certificate more = five;
  more.fillet_clearances = all.fillet_clearances;
  EXPECT_NO_THROW(verify(more));
  const auto refused = [](Certificate c, const auto& forge) {
    forge(c.fillet_clearances);
    EXPECT_THROW(verify(c), Error);
  };
  refused(five, [](auto& claims) { claims.erase(claims.begin() + 4); });
  refused(five, [](auto& claims) { claims.pop_back(); });
  refused(five, [](auto& claims) { std::swap(claims[3], claims[4]); });
  refused(five, [](auto& claims) { claims.insert(claims.begin() + 2, claims[2]); });
  refused(five, [](auto& claims) { claims[2].distance *= 3; });
  refused(five, [](auto& claims) { claims[2].second = 99; });
  Certificate wider = five;
  wider.apart = 16;
  EXPECT_THROW(verify(wider), Error) << "more are nearer than that";
  Certificate every = five;
  every.apart = 0;
  EXPECT_THROW(verify(every), Error);
}

}  // namespace
}  // namespace dupin::certification
