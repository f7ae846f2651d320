#include <gtest/gtest.h>

#include "streams/point_numbers.h"

namespace dupin::streams {
namespace {

MeshPiece piece(std::uint32_t points, const std::vector<MeshBorder>& borders) {
  return {.bytes = {}, .points = points, .borders = borders, .is_elsewhere = true};
}

std::vector<std::uint32_t> numbers(const PointNumbers& own, std::uint32_t points) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < points; ++i) {
    result.push_back(own.of(i));
  }
  return result;
}

using Numbers = std::vector<std::uint32_t>;

class PointsOfPieces : public testing::Test {
 public:
  PointsOfPieces() {
    meshes.append(piece(4, {{"a", {3, 1}, {}, {}}}));
    meshes.append(piece(3, {}));
    meshes.append(piece(5, {{"b", {0, 2}, {}, {}}, {"a", {1, 4}, {}, {}}}));
    meshes.append(piece(3, {{"b", {2, 1}, {}, {}}}));
  }
  SpilledMeshes meshes;
};

TEST_F(PointsOfPieces, are_one_where_two_share_a_border) {
  const NumberedPoints all = numbered_points(meshes, std::vector<std::size_t>{0, 1, 2, 3});
  EXPECT_EQ(all.count, 4 + 3 + 3 + 1);
  EXPECT_EQ(numbers(all.pieces[0], 4), (Numbers{0, 1, 2, 3}));
  EXPECT_EQ(numbers(all.pieces[1], 3), (Numbers{4, 5, 6}));
  EXPECT_EQ(numbers(all.pieces[2], 5), (Numbers{7, 3, 8, 9, 1}));
  EXPECT_EQ(numbers(all.pieces[3], 3), (Numbers{10, 8, 7}));
  ASSERT_EQ(all.pieces[2].shared.size(), 2);
  EXPECT_EQ(all.pieces[2].shared[0].piece, 0);
  EXPECT_EQ(all.pieces[2].shared[0].border, 1);
  EXPECT_EQ(all.pieces[2].shared[1].piece, 3);
  EXPECT_EQ(all.pieces[2].shared[1].border, 0);
  EXPECT_EQ(all.pieces[0].shared.at(0).piece, 2);
  EXPECT_EQ(all.pieces[0].shared.at(0).of_piece, 1);
  EXPECT_TRUE(all.pieces[1].shared.empty());
}

TEST_F(PointsOfPieces, are_their_own_where_the_other_piece_is_not_there) {
  const NumberedPoints some = numbered_points(meshes, std::vector<std::size_t>{2, 3});
  EXPECT_EQ(some.count, 5 + 1);
  EXPECT_EQ(numbers(some.pieces[0], 5), (Numbers{0, 1, 2, 3, 4}));
  EXPECT_EQ(numbers(some.pieces[1], 3), (Numbers{5, 2, 0}));
  EXPECT_EQ(some.pieces[0].shared.at(0).piece, 1) << "by its place among these";
}

}  // namespace
}  // namespace dupin::streams
