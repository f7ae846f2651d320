#include <gtest/gtest.h>

#include "drawing/stretches.h"

namespace dupin::drawing {
namespace {

using Pairs = std::vector<std::pair<double, double>>;

Pairs pairs(const std::vector<Stretch>& all) {
  Pairs result;
  for (const Stretch& one : all) {
    result.emplace_back(one.from, one.to);
  }
  return result;
}

TEST(Stretches, have_complements) {
  EXPECT_EQ(pairs(complement({}, 3)), (Pairs{{0, 3}}));
  EXPECT_EQ(pairs(complement({{0, 3}}, 3)), (Pairs{}));
  EXPECT_EQ(pairs(complement({{0, 1}, {1.5, 2}}, 3)), (Pairs{{1, 1.5}, {2, 3}}));
  EXPECT_EQ(pairs(complement({{1, 3}}, 3)), (Pairs{{0, 1}}));
}

TEST(Stretches, have_intersections) {
  EXPECT_EQ(pairs(intersection({{0, 2}, {3, 5}}, {{1, 4}})), (Pairs{{1, 2}, {3, 4}}));
  EXPECT_EQ(pairs(intersection({{0, 1}}, {{1, 2}})), (Pairs{}));
  EXPECT_EQ(pairs(intersection({{0, 9}}, {{1, 2}, {3, 4}, {8, 10}})),
            (Pairs{{1, 2}, {3, 4}, {8, 9}}));
  EXPECT_EQ(pairs(intersection({{0, 9}}, {})), (Pairs{}));
}

TEST(Stretches, cut_polylines) {
  const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 4}};
  using Line = std::vector<Vec3>;
  EXPECT_EQ(cut(line, {0, 3}), line);
  EXPECT_EQ(cut(line, {.5, 2.25}), (Line{{.5, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 1}}));
  EXPECT_EQ(cut(line, {1, 2}), (Line{{1, 0, 0}, {1, 2, 0}}));
  EXPECT_EQ(cut(line, {1.25, 1.5}), (Line{{1, .5, 0}, {1, 1, 0}}));
}

}  // namespace
}  // namespace dupin::drawing
