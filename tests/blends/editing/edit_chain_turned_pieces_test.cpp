#include <gtest/gtest.h>

#include "dupin/blends/edit_chain.h"
#include "dupin/kernel/decimal.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

// With its bias sphere 5 where it is put.
Assembly hook(const PeVector& bias) {
  std::vector<PeVector> spheres = test::crane_hook_spheres();
  spheres[5] = bias;
  return {"d.json",
          Unit::millimetre,
          0.01,
          {},
          {{"hook", CyclideChainThrough{ChainDirection{Vec3(0, -1, 0), 0}, spheres, {}}}}};
}

TEST(TurnedPieces, are_none_where_bias_spheres_lie_on_the_way) {
  EXPECT_TRUE(turned_pieces(hook(test::crane_hook_spheres()[5]), 0, kEditMargin).empty());
}

TEST(TurnedPieces, come_with_a_move_of_a_junction_that_turns_them) {
  const Assembly before = hook(test::sphere(0, 0, 0, .87));
  const auto turned = turned_pieces(before, 0, kEditMargin);
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_EQ(turned[0].piece, 2U);
  EXPECT_EQ(turned[0].bias_sphere, 5U);
  ASSERT_TRUE(turned[0].remedy);
  const auto& [sphere, to] = *turned[0].remedy;
  EXPECT_TRUE(sphere == 4 || sphere == 6) << sphere;
  EXPECT_EQ(to.m.x(), rounded(to.m.x(), kPlaceDigits));
  Assembly after = before;
  after.parts[0].shape = move_sphere(before, 0, sphere, to);
  EXPECT_TRUE(turned_pieces(after, 0, kEditMargin).empty());
  EXPECT_NO_THROW(check_edit(after, 0, kEditMargin));
}

TEST(TurnedPieces, may_have_no_remedy) {
  for (const PeVector& bias : {test::sphere(-900, 900, 900, .9), test::sphere(-1, 4, 0, .9)}) {
    const auto turned = turned_pieces(hook(bias), 0, kEditMargin);
    ASSERT_EQ(turned.size(), 1U);
    EXPECT_FALSE(turned[0].remedy);
  }
}

}  // namespace
}  // namespace dupin
