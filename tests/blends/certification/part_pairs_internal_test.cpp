#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "certification/part_pairs.h"

namespace dupin::certification {
namespace {

CertifiedPart ball(double x) { return {"ball", "sphere", Sphere{Vec3(x, 0, 0), 1}, {}}; }

TEST(PartPairs, are_all_in_the_order_of_certificates) {
  EXPECT_THAT(all_pairs(3), testing::ElementsAre(PartPair{0, 1}, PartPair{0, 2}, PartPair{1, 2}));
  EXPECT_TRUE(all_pairs(1).empty());
}

TEST(PartPairs, that_take_little_come_first) {
  std::vector<CertifiedPart> parts{ball(0), ball(3), ball(9), ball(1)};
  parts[0].joined[1] = EndIndex{3, End::start};
  parts[3].joined[0] = EndIndex{0, End::end};
  // 0-1, 0-2, 0-3, 1-2, 1-3, 2-3: by gaps of 1, 7, none but joined, 4, none, 6
  EXPECT_THAT(easiest_first(all_pairs(4), parts), testing::ElementsAre(2, 1, 5, 3, 0, 4));
}

}  // namespace
}  // namespace dupin::certification
