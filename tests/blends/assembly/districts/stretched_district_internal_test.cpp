#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/districts/common_rings.h"
#include "assembly/districts/stretched_district.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::fillet;
using test::pipe;

// Two headers with a pipe between them.
Assembly ladder() {
  return {"ladder.json",
          Unit::millimetre,
          0.1,
          {},
          {pipe("low", {0, 0, 0}, {40, 0, 0}, 1), pipe("rung", {20, 0, 0}, {20, 20, 0}, .5),
           fillet("f", "low", "rung", .25), pipe("high", {0, 20, 0}, {40, 20, 0}, 1)}};
}

struct Ladder {
  Assembly assembly = ladder();
  ResolvedAssembly resolved = resolve(assembly);
  DistrictParts members = districts_of_parts(resolved, .125).at(0);
  Divisible whole{resolved, members, common_rings(district(assembly, resolved, members), {})};
};

TEST(StretchedDistrict, has_a_box_and_a_sampling_for_each_stretch) {
  const Ladder ladder;
  const StretchedDistrict made = stretched(ladder.whole, {{0, {10, 30}}, {2, {8}}});
  EXPECT_EQ(made.members.parts, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(made.members.fillets, ladder.members.fillets);
  ASSERT_EQ(made.members.boxes.size(), 7);
  EXPECT_EQ(made.members.boxes.back().min(), ladder.members.boxes.back().min()) << "the fillet's";
  const double from = ladder.members.boxes[0].min().x();
  EXPECT_LT(from, 0);
  EXPECT_EQ(made.members.boxes[0].min(), ladder.members.boxes[0].min());
  EXPECT_DOUBLE_EQ(made.members.boxes[0].max().x(), 10 - from);
  EXPECT_DOUBLE_EQ(made.members.boxes[3].min().x(), 10 + from);
  EXPECT_DOUBLE_EQ(made.members.boxes[4].max().x(), 40 - from);
  for (const auto* samplings : {&made.common.samplings, &made.common.second_samplings}) {
    ASSERT_EQ(samplings->size(), 6);
    EXPECT_EQ((*samplings)[3].phase, (*samplings)[0].phase);
    EXPECT_EQ((*samplings)[5].phase, (*samplings)[2].phase);
  }
  EXPECT_EQ(made.common.samplings[5].segments, ladder.whole.common.samplings[2].segments);
}

TEST(StretchedDistrict, keeps_cuts_between_groups) {
  const Ladder ladder;
  const PipeCuts cuts{{0, {10, 30}}, {2, {8, 16}}};
  const StretchedDistrict made = stretched(ladder.whole, cuts);
  // By box: low, rung, high, two more of low, two more of high, the fillet.
  const std::vector<std::uint32_t> groups{0, 1, 0, 1, 1, 0, 1, 1};
  const FewerCuts fewer = cuts_between(made, cuts, [&](std::uint32_t box) { return groups[box]; });
  EXPECT_EQ(fewer.cuts, (PipeCuts{{0, {10}}, {2, {16}}}));
  EXPECT_EQ(fewer.boxes, (std::vector<std::uint32_t>{0, 1, 2, 3, 6, 7}));
}

}  // namespace
}  // namespace dupin::assembly
