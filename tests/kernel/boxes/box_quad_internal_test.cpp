#include <gtest/gtest.h>

#include "boxes/box_quad.h"
#include "kernel/boxes/random_boxes_internal.h"

namespace dupin::boxes {
namespace {

TEST(BoxQuad, says_of_each_box_whether_it_overlaps_another) {
  constexpr std::size_t kFour = BoxQuad::kSize;
  const auto boxes = random_boxes(4000, 3);
  int met = 0;
  for (std::size_t i = 0; i + kFour < boxes.size(); i += kFour) {
    BoxQuad quad;
    for (std::size_t k = 0; k < kFour; ++k) {
      quad.set(k, boxes[i + k]);
      ASSERT_EQ(quad[k].low, boxes[i + k].low);
      ASSERT_EQ(quad[k].high, boxes[i + k].high);
      ASSERT_TRUE(k + 1 < kFour || quad.joined().contains(boxes[i + k]));
    }
    const Box large{{-0.3F, -0.3F, -0.3F}, {0.1F, 0.4F, 0.3F}};
    for (const Box& box : {boxes[i + kFour], large, boxes[i]}) {
      for (std::size_t k = 0; k < kFour; ++k) {
        ASSERT_EQ((quad.overlapping(box) >> k & 1) != 0, boxes[i + k].overlaps(box)) << i + k;
        met += boxes[i + k].overlaps(box) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(met, 1000);
}

TEST(BoxQuad, of_boxes_that_touch_and_of_nothing) {
  const Box box{{0, 0, 0}, {0.5F, 0.5F, 0.5F}};
  BoxQuad quad;
  EXPECT_EQ(quad.overlapping(box), 0U);
  EXPECT_EQ(quad.overlapping(Box::nothing()), 0U);
  quad.set(2, {{0.5F, 0.5F, -1}, {1, 1, 0}});
  EXPECT_EQ(quad.overlapping(box), 4U) << "a corner in common";
  EXPECT_EQ(quad.overlapping(Box::nothing()), 0U);
  EXPECT_EQ(quad.joined().low, quad[2].low);
}

}  // namespace
}  // namespace dupin::boxes
