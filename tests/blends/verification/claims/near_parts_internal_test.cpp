#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "support/fillet_loops.h"
#include "verification/claims/near_parts.h"
#include "verification/work.h"

namespace dupin::verification {
namespace {

using test::ball;

std::vector<PartPair> all_pairs(std::uint32_t count) {
  std::vector<PartPair> pairs;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t k = i + 1; k < count; ++k) {
      pairs.push_back({i, k});
    }
  }
  return pairs;
}

Solid unknown() {
  CertifiedPart part;
  part.shape = Chain();
  return Solid(part);
}

// Cubes about the balls, told by doubles, whose errors the gaps are far from.
TEST(NearParts, are_those_whose_boxes_are_near) {
  std::mt19937_64 random(3);
  for (const std::size_t count : {0U, 1U, 2U, 9U, 60U, 700U}) {
    for (const double flat : {1.0, 0.0}) {  // in space, or on a plane
      std::uniform_real_distribution<double> place(-40, 40), size(.1, 3);
      std::vector<Sphere> spheres;
      std::vector<Solid> solids;
      for (std::size_t i = 0; i < count; ++i) {
        spheres.push_back({Vec3(place(random), place(random), flat * place(random)), size(random)});
        solids.push_back(ball(spheres.back().center, spheres.back().radius));
      }
      const double distance = size(random);
      std::vector<PartPair> expected;
      for (const auto& [i, k] : all_pairs(std::uint32_t(count))) {
        const Vec3 gap = (spheres[i].center - spheres[k].center).cwiseAbs();
        if (gap.maxCoeff() < spheres[i].radius + spheres[k].radius + distance) {
          expected.push_back({i, k});
        }
      }
      EXPECT_EQ(pairs_nearer_than(distance, {}, solids), expected) << count;
    }
  }
}

TEST(NearParts, may_be_exactly_so_far) {
  const std::vector<Solid> solids = {ball({0, 0, 0}, 1), ball({6, 0, 0}, 1)};
  EXPECT_EQ(pairs_nearer_than(4 * (1 - 0x1p-50), {}, solids).size(), 0U);
  EXPECT_EQ(pairs_nearer_than(4 * (1 + 0x1p-50), {}, solids).size(), 1U);
  EXPECT_EQ(pairs_nearer_than(4 * (1 + 0x1p-50), {}, {solids[1], solids[0]}).size(), 1U);
}

// In a turned frame balls are as far from each other as they are without; what has no length, or is
// turned no better, tells less.
TEST(NearParts, are_told_by_boxes_along_other_axes) {
  const Vec3 right = Vec3(3, 4, 0) / 5, up = Vec3(-4, 3, 0) / 5, towards(0, 0, 1);
  const std::vector<Solid> solids = {ball({0, 0, 0}, 1), ball(6 * right, 1),
                                     ball(6 * right + 6 * up, 1)};
  const auto count = [&](double distance, const Directions& axes) {
    return pairs_nearer_than(distance, axes, solids).size();
  };
  EXPECT_EQ(pairs_nearer_than(3.9, {}, solids).size(), 2U);
  for (const double scale : {1.0, 1e-60, 3.7, 1e60}) {
    const Directions axes{scale * right, -5 * up, towards};
    EXPECT_EQ(count(4 * (1 - 0x1p-45), axes), 0U) << scale;
    EXPECT_EQ(count(4 * (1 + 0x1p-45), axes), 3U) << scale;
  }
  EXPECT_EQ(count(3.9, {right, Vec3::Zero(), towards}), 1U);
  EXPECT_EQ(count(3.9, {right, right, right}), 1U);
  EXPECT_EQ(count(3.9, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}), 3U);
}

// All discs and knees lie in the boxes along any axes.
TEST(NearParts, have_boxes_along_other_axes_about_all_their_discs) {
  const Solid bent = test::solid(test::elbow(10, 3, 1));
  const Directions axes{Vec3(1, 2, 3), Vec3(-1, 1, .5), Vec3(0, 1, -2)};
  for (int i = 0; i <= 30; ++i) {
    const double angle = i / 10.0;
    const Vec3 middle(std::cos(angle), std::sin(angle), 0);
    for (const Vec3& place :
         {Vec3(10.99 * middle), Vec3(9.01 * middle), Vec3(10 * middle + .99 * Vec3(0, 0, 1))}) {
      EXPECT_EQ(pairs_nearer_than(1e-9, axes, {bent, ball(place, 1e-9)}).size(), 1U) << angle;
    }
  }
  EXPECT_TRUE(pairs_nearer_than(1, axes, {bent, ball({40, 0, 0}, 1)}).empty());
}

TEST(NearParts, are_all_with_what_nothing_is_known_of) {
  std::vector<Solid> solids;
  for (int i = 0; i < 30; ++i) {
    solids.push_back(i == 17 ? unknown() : ball(Vec3(9 * i, 0, 0), 1));
  }
  const auto pairs = pairs_nearer_than(1, {}, solids);
  EXPECT_EQ(pairs.size(), 29U);
  EXPECT_TRUE(
      std::ranges::all_of(pairs, [](const PartPair& p) { return p[0] == 17 || p[1] == 17; }));
}

// Along every axis and in every piece: the other one is at a place that only that stretch reaches.
TEST(NearParts, have_boxes_about_all_their_discs) {
  const Solid bent = test::solid(test::elbow(10, 3, 1)),
              chain = test::solid(test::cylinder({0, 0, 0}, {9, 0, 0}, 1),
                                  test::cylinder({9, 0, 0}, {9, 9, 0}, 2));
  const auto is_near = [](const Solid& solid, const Vec3& place) {
    return !pairs_nearer_than(1e-9, {}, {solid, ball(place, 1e-9)}).empty();
  };
  for (const double angle : {0.0, .7, 1.4, 2.2, 3.0}) {
    EXPECT_TRUE(is_near(bent, 10.9 * Vec3(std::cos(angle), std::sin(angle), 0))) << angle;
    EXPECT_TRUE(is_near(bent, Vec3(10 * std::cos(angle), 10 * std::sin(angle), .99))) << angle;
    EXPECT_TRUE(is_near(bent, Vec3(10 * std::cos(angle), 10 * std::sin(angle), -.99))) << angle;
  }
  EXPECT_FALSE(is_near(bent, Vec3(0, 0, 1.1)));
  EXPECT_FALSE(is_near(bent, Vec3(0, 12, 0)));
  EXPECT_FALSE(is_near(bent, Vec3(0, -2.5, 0)));
  EXPECT_TRUE(is_near(chain, Vec3(.1, .9, 0)));
  EXPECT_TRUE(is_near(chain, Vec3(9, 8.9, 1.9)));
  EXPECT_TRUE(is_near(chain, Vec3(7.1, 8.9, 0)));
  EXPECT_FALSE(is_near(chain, Vec3(4, 0, 2.1)));
}

TEST(NearParts, of_a_scattered_lot_take_little_work) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0, 1000);
  std::vector<Solid> solids;
  for (int i = 0; i < 20'000; ++i) {
    solids.push_back(ball(Vec3(place(random), place(random), place(random)), 1));
  }
  const WorkLimit limit(work_for_boxes(solids.size()));
  EXPECT_NO_THROW(static_cast<void>(pairs_nearer_than(1, {}, solids)));
  const WorkLimit small(1000);
  EXPECT_THROW(static_cast<void>(pairs_nearer_than(1, {}, solids)), Error);
}

// They are halved across the axis along which they lie.
TEST(NearParts, in_a_row_take_little_work_whatever_its_direction) {
  constexpr int kCount = 20'000;
  for (const Vec3& step : {Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(0, 0, 4)}) {
    std::vector<Solid> solids;
    for (int i = 0; i < kCount; ++i) {
      solids.push_back(ball((i * 7919 % kCount) * step, 1));
    }
    const WorkLimit limit(work_for_boxes(solids.size()));
    EXPECT_NO_THROW(EXPECT_TRUE(pairs_nearer_than(1, {}, solids).empty())) << step.transpose();
  }
}

TEST(NearParts, at_one_place_are_all_pairs) {
  const std::vector<Solid> solids(700, ball({1, 2, 3}, 1));
  EXPECT_EQ(pairs_nearer_than(1, {}, solids), all_pairs(700));
}

// Whoever writes a certificate may put one part near to all others.
TEST(NearParts, cost_work_for_every_pair_that_is_looked_at) {
  constexpr std::uint64_t kUnits = 1'000'000;
  constexpr int kCount = 4096;
  std::vector<Solid> solids;
  for (int i = 0; i < kCount; ++i) {
    solids.push_back(ball(Vec3(9 * i, 0, 0), 1));
  }
  const auto used = [&] {
    const WorkLimit limit(kUnits);
    static_cast<void>(pairs_nearer_than(1, {}, solids));
    return kUnits - limit.left();
  };
  const std::uint64_t in_a_row = used();
  solids.insert(solids.begin(), ball({0, 0, 0}, 1e6));
  EXPECT_GE(used(), in_a_row + kCount);
}

// Loops come after the parts; of what nothing is known it is near all.
TEST(NearParts, are_pairs_with_loops_in_their_order) {
  const std::vector<Solid> solids{ball({0, 0, 0}, 1), ball({100, 0, 0}, 1), ball({0, 0, 9}, 1)};
  const CanalFillet loop = test::loops_of_all_kinds().front().loop;
  std::vector<ArcCell> cells;
  for (int i = 0; i < 512; ++i) {
    cells.push_back(regular_cell(loop, {i / 256.0, (i + 1) / 256.0}, 0).value());
  }
  const auto found = loop_pairs_nearer_than(8, {}, solids, {{&loop, cells}, {&loop, {}}});
  const std::vector<PartPair> expected{{0, 3}, {2, 3}, {3, 4}, {0, 4}, {1, 4}, {2, 4}};
  EXPECT_EQ(found, expected);
  const Directions axes{Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(loop_pairs_nearer_than(8, axes, solids, {{&loop, cells}, {&loop, {}}}), expected);
  const Directions upwards{Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)};
  EXPECT_EQ(loop_pairs_nearer_than(8, upwards, solids, {{&loop, cells}}),
            (std::vector<PartPair>{{0, 3}, {1, 3}, {2, 3}}));
  EXPECT_LT(place_of({2, 3}, 3), place_of({3, 4}, 3));
  EXPECT_LT(place_of({3, 4}, 3), place_of({0, 4}, 3));
}

// Two cones that grow along the x axis and shrink on the way back: the ball of their joint reaches
// further than all discs.
TEST(NearParts, are_near_to_what_a_kneecap_adds) {
  const Vec3 back(std::cos(2.6), std::sin(2.6), 0);
  CertifiedPart bend;
  bend.shape = kneecap_chain(std::vector<PeVector>{test::sphere(-4, 0, 0, 1),
                                                   test::sphere(-2, 0, 0, 2),
                                                   test::sphere(0, 0, 0, 3),
                                                   {2 * back, 2},
                                                   {4 * back, 1}});
  std::vector<Solid> solids;
  solids.emplace_back(bend);
  solids.push_back(ball(Vec3(4.5, 0, 0), 1));
  EXPECT_TRUE(pairs_nearer_than(.499, {}, solids).empty());
  EXPECT_EQ(pairs_nearer_than(.501, {}, solids).size(), 1U);
}

}  // namespace
}  // namespace dupin::verification
