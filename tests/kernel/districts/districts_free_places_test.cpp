#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/districts.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

constexpr double kMargin = .125;

// A run along x, from 0 to 100, and what is across it, 4 wide.
struct Crossed {
  explicit Crossed(const std::vector<double>& places) {
    const auto add = [&](const Vec3& low, const Vec3& high, int axis) {
      boxes.emplace_back(Vec3(low.array() - kMargin), Vec3(high.array() + kMargin));
      items.push_back(Cuttable{axis, low[axis], high[axis], 1});
    };
    add({0, -1, -1}, {100, 1, 1}, 0);
    for (const double place : places) {
      add({place - 2, -20, -2}, {place + 2, 20, 2}, 1);
    }
  }
  [[nodiscard]] std::vector<std::vector<double>> cuts(double distance) const {
    return FreePlaces(boxes, items).cuts(distance);
  }

  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<std::optional<Cuttable>> items;
};

// What is across is as much wider as boxes are, and as the stretches' boxes will be.
TEST(FreePlaces, are_at_planes_or_beside_what_is_there) {
  Crossed crossed({50});
  EXPECT_EQ(crossed.cuts(25)[0], (std::vector{25., 50 + 2 + 2 * kMargin + 1, 75.}));
  EXPECT_EQ(crossed.cuts(10)[1], (std::vector{-10., 1 + 2 * kMargin + 1, 10.}));
  crossed.items[0].reset();
  EXPECT_TRUE(crossed.cuts(25)[0].empty());
  EXPECT_FALSE(crossed.cuts(10)[1].empty());
}

TEST(FreePlaces, are_those_nearest_to_planes) {
  EXPECT_EQ(Crossed({26, 48}).cuts(25)[0],
            (std::vector{26 - 2 - 2 * kMargin - 1, 48 + 2 + 2 * kMargin + 1, 75.}));
}

TEST(FreePlaces, are_in_the_middle_of_what_is_narrow) {
  EXPECT_EQ(Crossed({47, 52}).cuts(50)[0], std::vector{49.5});
  const std::vector<double> places = Crossed({47, 51.5}).cuts(4)[0];
  EXPECT_GT(places.size(), 10);
  for (const double place : places) {
    EXPECT_TRUE(place < 47 || place > 51.5) << "boxes about stretches would touch both";
  }
}

TEST(FreePlaces, are_apart_from_each_other) {
  const std::vector<double> places = Crossed({30, 60}).cuts(.25)[0];
  EXPECT_GT(places.size(), 50);
  for (std::size_t i = 1; i < places.size(); ++i) {
    EXPECT_GT(places[i], places[i - 1] + 1);
  }
}

TEST(FreePlaces, are_as_many_as_it_takes) {
  const Crossed crossed({30, 60});
  const auto longest = [](const FreePlaces::Cuts& cuts) {
    double result = 0, last = 0;
    for (const double place : cuts[0]) {
      result = std::max(result, place - last);
      last = place;
    }
    return std::max(result, 100 - last);
  };
  const FreePlaces places(crossed.boxes, crossed.items);
  std::size_t before = 0;
  for (const double most : {90., 40., 20., 10.}) {
    const FreePlaces::Cuts cuts = places.best_cuts(100, most, longest);
    ASSERT_EQ(cuts.size(), 3);
    EXPECT_LE(longest(cuts), most);
    EXPECT_GT(cuts[0].size(), before);
    EXPECT_LE(cuts[0].size(), 4 * 4 * 100 / most);
    before = cuts[0].size();
  }
  // Nothing comes closer than what is across is wide.
  EXPECT_GT(longest(places.best_cuts(100, .1, longest)), 4);
  EXPECT_TRUE(places.best_cuts(100, .1, [](const auto&) { return 100; }).empty()) << "no better";
  EXPECT_TRUE(places.best_cuts(100, 100, longest).empty()) << "there is nothing to do";
  EXPECT_TRUE(FreePlaces(crossed.boxes, {}).best_cuts(100, 1, longest).empty());
}

TEST(FreePlaces, groups_are_no_heavier_than_wanted) {
  const std::vector<std::array<std::uint32_t, 2>> pairs{{3, 2}, {1, 2}, {0, 1}, {2, 3}, {4, 0}};
  EXPECT_EQ(grouped({1, 2, 3, 4, 9}, pairs, 7), (std::vector<std::uint32_t>{0, 0, 2, 2, 4}));
  EXPECT_EQ(grouped({1, 2, 3, 4, 9}, pairs, 10), (std::vector<std::uint32_t>{0, 0, 0, 0, 4}));
  EXPECT_EQ(grouped({1, 2, 3, 4, 9}, pairs, 19), (std::vector<std::uint32_t>{0, 0, 0, 0, 0}));
  EXPECT_EQ(grouped({1, 2, 3, 4, 9}, pairs, 0), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(grouped({100, 4, 100}, std::array{pairs[2], pairs[1]}, 100),
            (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(grouped({100, 3, 100}, std::array{pairs[2], pairs[1]}, 100),
            (std::vector<std::uint32_t>{0, 0, 2}))
      << "which is little";
}

// However many things are beside an item, and in whatever order they come.
TEST(FreePlaces, are_between_thousands_of_things) {
  std::mt19937 random(5);
  std::vector<Eigen::AlignedBox3d> boxes{{Vec3(0, -1, -1), Vec3(1000, 1, 1)}};
  std::vector<double> places;
  for (int i = 0; i < 3000; ++i) {
    places.push_back(std::uniform_real_distribution<double>(0, 300)(random) +
                     (i % 2 == 0 ? 0 : 600));
  }
  for (const double place : places) {
    boxes.emplace_back(Vec3(place, 0, 0), Vec3(place + 40, 5, 5));
  }
  const auto cuts = FreePlaces(boxes, {Cuttable{0, 0, 1000, 1}}).cuts(20);
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_GT(cuts[0].size(), 10U);
  for (const double cut : cuts[0]) {
    EXPECT_TRUE((cut > 340 - 1 && cut < 600) || cut > 940 - 1) << cut;
  }
}

TEST(FreePlaces, are_of_numbers) {
  const Eigen::AlignedBox3d box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const auto refused = [&](const Cuttable& item) {
    EXPECT_THROW(FreePlaces(std::vector{box}, {item}), Error);
  };
  const double nan = std::nan("");
  refused({-1, 0, 1, .1});
  refused({3, 0, 1, .1});
  refused({0, nan, 1, .1});
  refused({0, 0, INFINITY, .1});
  refused({0, 0, 1, nan});
  EXPECT_THROW(FreePlaces(std::vector<Eigen::AlignedBox3d>(), {Cuttable{0, 0, 1, .1}}), Error);
  Eigen::AlignedBox3d bad = box;
  bad.min().y() = nan;
  EXPECT_THROW(FreePlaces(std::vector{bad}, {}), Error);
  const FreePlaces places(std::vector{box}, {Cuttable{0, 0, 1, .1}});
  for (const double distance : {0.0, -1.0, nan, double(INFINITY)}) {
    EXPECT_THROW((void)places.cuts(distance), Error);
  }
}

TEST(FreePlaces, groups_are_of_things_with_weights) {
  const std::vector<std::array<std::uint32_t, 2>> pair{{0, 1}}, outside{{0, 2}};
  EXPECT_THROW((void)grouped({1, std::nan("")}, pair, 2), Error);
  EXPECT_THROW((void)grouped({1, 1}, pair, std::nan("")), Error);
  EXPECT_THROW((void)grouped({1, 1}, outside, 2), Error);
}

}  // namespace
}  // namespace dupin
