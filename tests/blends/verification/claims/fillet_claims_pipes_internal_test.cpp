// What pipes differ by from the quadrics on which a fillet's balls roll.
#include <array>

#include <gtest/gtest.h>

#include "blends/tubes.h"
#include "verification/claims/fillet_claims.h"
#include "verification/piece.h"

namespace dupin::verification {
namespace {

// One is further off, the other one leans more; it is in either order that both count.
TEST(FilletClaims, are_about_the_larger_difference_of_both_pipes) {
  const Piece cone(test::cone({0, 0, 0}, {4, 0, 0}, 1, 2), 0);
  const Ring quadric{Vec3(4, 0, 0), Vec3::UnitX(), 2, .25};
  Ring wide = quadric, steep = quadric;
  wide.radius += 0x1p-10;
  steep.slope += 0x1p-20;
  for (const auto& quadrics : {std::array{wide, steep}, std::array{steep, wide}}) {
    const RolledPipes found = rolled_pipes(quadrics, {&cone, &cone});
    EXPECT_NEAR(found.difference.offset, 0x1p-10, 1e-13);
    EXPECT_NEAR(found.difference.deviation, 1.6 * 0x1p-20, 1e-13);
    EXPECT_EQ(found.starts[1].center, Vec3(0, 0, 0));
  }
}

TEST(FilletClaims, leave_less_to_quadrics_by_what_pipes_differ) {
  const ContactClaim left = about_quadrics({3, 2}, {1, .5});
  EXPECT_NEAR(left.offset, 2, 1e-13);
  EXPECT_NEAR(left.deviation, 1.5, 1e-13);
  const ContactClaim less = about_quadrics({1, 1}, {0x1p-80, 0x1p-80});
  EXPECT_LT(less.offset, 1) << "by however little";
  EXPECT_LT(less.deviation, 1);
}

}  // namespace
}  // namespace dupin::verification
