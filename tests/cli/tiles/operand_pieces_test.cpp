#include "tiles/operand_pieces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dupin::test {
namespace {

using cli::operand_districts;
using cli::operand_pieces;
using cli::OperandPieces;
using cli::OperandStretch;

// Bars along x and along y through each other, and one apart from all.
struct Grid {
  explicit Grid(int bars) {
    const double end = 10. * bars - 5;
    for (int i = 0; i < bars; ++i) {
      const double at = 10. * i;
      boxes.emplace_back(Vec3(-5, at - 1, -1), Vec3(end, at + 1, 1));
      boxes.emplace_back(Vec3(at - 1, -5, -.5), Vec3(at + 1, end, .5));
    }
    boxes.emplace_back(Vec3(0, 0, 50), Vec3(1, 1, 51));
    triangles.resize(boxes.size(), 100);
  }
  [[nodiscard]] OperandPieces pieces(double most, const std::set<std::size_t>& uncut = {}) const {
    return operand_pieces(operand_districts(boxes, {.absolute = .01}),
                          {boxes, triangles, most, uncut});
  }

  Boxes boxes;
  std::vector<std::size_t> triangles;
};

TEST(OperandPieces, of_few_operands_or_triangles_are_districts) {
  for (const OperandPieces& whole : {Grid(20).pieces(1e9), Grid(20).pieces(0), Grid(8).pieces(1)}) {
    ASSERT_EQ(whole.stretches.size(), 2);
    EXPECT_TRUE(whole.seams.empty());
    for (const OperandStretch& stretch : whole.stretches[0]) {
      EXPECT_FALSE(stretch.is_cut());
    }
  }
  const OperandPieces none = operand_pieces(operand_districts({}, {}), {{}, {}, 1, {}});
  EXPECT_EQ(none.stretches.size(), 1);
  EXPECT_TRUE(none.stretches[0].empty());
}

TEST(OperandPieces, have_all_of_every_operand_between_them) {
  const Grid grid(20);
  const OperandPieces made = grid.pieces(20000);
  EXPECT_GT(made.stretches.size(), 4);
  EXPECT_LT(made.stretches.size(), 20);
  std::vector<double> length(grid.boxes.size());
  std::multiset<std::string> begins, ends;
  for (std::size_t i = 0; i < made.stretches.size(); ++i) {
    EXPECT_TRUE(std::ranges::is_sorted(made.stretches[i], {}, [&](const OperandStretch& stretch) {
      const Vec3& low = grid.boxes[stretch.operand].min();
      return std::array{low.x(), low.y(), low.z()};
    }));
    EXPECT_EQ(made.stretches[i].size(), made.boxes[i].size());
    for (const OperandStretch& stretch : made.stretches[i]) {
      const Eigen::AlignedBox3d& box = grid.boxes[stretch.operand];
      const double from = stretch.from ? stretch.from->place : box.min()[stretch.axis],
                   to = stretch.to ? stretch.to->place : box.max()[stretch.axis];
      EXPECT_LT(from, to);
      length[stretch.operand] += (to - from) / box.sizes()[stretch.axis];
      if (stretch.from) {
        begins.insert(stretch.from->name);
      }
      if (stretch.to) {
        ends.insert(stretch.to->name);
      }
    }
  }
  for (const double all : length) {
    EXPECT_NEAR(all, 1, 1e-12);
  }
  EXPECT_EQ(begins, ends);
  EXPECT_EQ(begins.size(), made.seams.size());
  for (const Seam& seam : made.seams) {
    EXPECT_EQ(begins.count(seam.name), 1);
    EXPECT_LT(seam.pieces[0], seam.pieces[1]);
  }
}

TEST(OperandPieces, touch_at_seams_only) {
  const OperandPieces made = Grid(20).pieces(20000);
  for (std::uint32_t i = 0; i < made.boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < made.boxes.size(); ++j) {
      for (const Eigen::AlignedBox3d& a : made.boxes[i]) {
        for (const Eigen::AlignedBox3d& b : made.boxes[j]) {
          const bool is_seam = std::ranges::any_of(made.seams, [&](const Seam& seam) {
            return seam.pieces == std::array{i, j} && seam.meeting.contains(a.intersection(b));
          });
          EXPECT_TRUE(is_seam || !a.intersects(b)) << i << " " << j;
        }
      }
    }
  }
}

// A bar that cannot be cut, and many through it whose ends could be.
TEST(OperandPieces, ends_alone_are_no_pieces) {
  Grid comb(0);
  comb.boxes.assign(1, {Vec3(-5, -1, -1), Vec3(1005, 1, 1)});
  for (int i = 0; i < 1000; ++i) {
    comb.boxes.emplace_back(Vec3(i, -1, -1), Vec3(i + 1.01, 9, 1));
  }
  comb.triangles.assign(comb.boxes.size(), 100);
  EXPECT_EQ(comb.pieces(20000).stretches.size(), 1);
}

TEST(OperandPieces, some_operands_are_not_cut) {
  const Grid grid(20);
  const std::set<std::size_t> uncut{3, 4};
  const OperandPieces made = grid.pieces(20000, uncut);
  EXPECT_GT(made.stretches.size(), 2);
  for (const std::vector<OperandStretch>& stretches : made.stretches) {
    for (const OperandStretch& stretch : stretches) {
      EXPECT_FALSE(uncut.contains(stretch.operand) && stretch.is_cut());
    }
  }
}

TEST(OperandPieces, what_has_no_triangles_is_with_what_has) {
  Grid grid(20);
  grid.boxes.insert(grid.boxes.begin() + 3, Eigen::AlignedBox3d());
  grid.triangles.push_back(0);
  const OperandPieces made = grid.pieces(20000);
  std::size_t times = 0;
  for (std::size_t i = 0; i < made.stretches.size(); ++i) {
    EXPECT_FALSE(made.boxes[i].empty());
    times += std::size_t(std::ranges::count(made.stretches[i], 3U, &OperandStretch::operand));
  }
  EXPECT_EQ(times, 1);
}

}  // namespace
}  // namespace dupin::test
