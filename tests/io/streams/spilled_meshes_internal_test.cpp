#include <gtest/gtest.h>

#include "io/streams/pieces.h"
#include "streams/spilled_meshes.h"

namespace dupin::streams {
namespace {

TEST(SpilledMeshes, give_back_what_they_were_given_with_the_labels_of_the_whole) {
  for (const std::vector<std::string>& names : test::kCompanies) {
    const test::Pieces all(names, Coordinates::binary64);
    SpilledMeshes spilled;
    for (const Rounded& piece : all.rounded) {
      spilled.append(spilled_piece(piece.mesh()));
    }
    spilled.number_labels();
    const TriMesh whole = all.all();
    EXPECT_EQ(spilled.names(), whole.names);
    EXPECT_EQ(spilled.have_labels(), !whole.labels.empty());
    EXPECT_EQ(spilled.points(), whole.points.size());
    EXPECT_EQ(spilled.triangles(), whole.triangles.size());
    std::size_t face = 0;
    for (std::size_t i = 0; i < spilled.size(); ++i) {
      const TriMesh mesh = spilled.mesh(i);
      EXPECT_EQ(mesh.points, all.rounded[i].mesh().points);
      EXPECT_EQ(mesh.triangles, all.rounded[i].mesh().triangles);
      for (const std::uint32_t label : mesh.labels) {
        EXPECT_EQ(mesh.names[label], whole.names[whole.labels[face]]);
        EXPECT_EQ(spilled.numbers(i)[label], whole.labels[face++]);
      }
    }
    EXPECT_EQ(face, whole.labels.size());
  }
}

TEST(SpilledMeshes, are_without_ends) {
  const TriMesh bar = test::bar(0, 2, "a", true);
  const std::vector<std::uint32_t> end{8, 9};
  const std::vector<std::string> names{"none", "end"};
  const MeshPiece piece = open_piece(bar, end, names);
  EXPECT_EQ(piece.triangles, 10);
  EXPECT_EQ(piece.points, 8);
  EXPECT_EQ(piece.names, std::vector<std::string>{"a"});
  ASSERT_EQ(piece.borders.size(), 2);
  EXPECT_TRUE(piece.borders[0].points.empty());
  const MeshBorder& border = piece.borders[1];
  EXPECT_EQ(border.name, "end");
  EXPECT_EQ(border.points, (std::vector<std::uint32_t>{0, 3, 1, 2}));
  EXPECT_EQ(border.corners.size(), 8 * 3) << "all at the side";
  EXPECT_EQ(border.labels, std::vector<std::string>(8, "a"));
  SpilledMeshes spilled;
  spilled.append(piece);
  spilled.number_labels();
  EXPECT_EQ(spilled.mesh(0).triangles.size(), 10);
  EXPECT_EQ(spilled.mesh(0).points, bar.points);
  EXPECT_EQ(spilled.borders(0).size(), 2);
}

// A point within an end goes with it.
TEST(SpilledMeshes, lose_points_of_ends_alone) {
  TriMesh bar = test::bar(0, 2, "a", false);
  bar.points.emplace_back(2, .5, .5);
  bar.triangles.resize(10);
  bar.labels.resize(10);
  for (std::uint32_t i = 0; i < 4; ++i) {
    bar.triangles.push_back({4 + i, 4 + (i + 1) % 4, 8});
    bar.labels.push_back(1);
  }
  const MeshPiece piece =
      open_piece(bar, std::vector<std::uint32_t>{10, 11, 12, 13}, std::vector<std::string>{"end"});
  EXPECT_EQ(piece.points, 8);
  EXPECT_EQ(piece.borders.at(0).points, (std::vector<std::uint32_t>{4, 7, 5, 6}));
}

}  // namespace
}  // namespace dupin::streams
