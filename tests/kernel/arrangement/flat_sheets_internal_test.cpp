#include <random>

#include <gtest/gtest.h>

#include "arrangement/flat_sheets.h"
#include "arrangement/intersection_points.h"
#include "kernel/arrangement/stages_internal.h"
#include "kernel/exact_validity_internal.h"
#include "support/pipe_cases.h"
#include "support/tiled_boxes.h"

namespace dupin::arrangement {
namespace {

// A box from the origin with a top of so many strips, at this height.
TriMesh strips(double width, double length, std::size_t count, double low, double high,
               std::size_t along) {
  std::mt19937 random(0);
  test::Cuts cuts{{{0, width}, {0, length}, {low, high}}};
  for (std::size_t i = 1; i < count; ++i) {
    const double end = cuts[along].back();
    cuts[along].insert(cuts[along].end() - 1, end * double(i) / double(count));
  }
  return test::tiled_box(cuts, random);
}

// The edges inside of sheets, by the corners of all triangles.
std::size_t edges_inside(test::Stages& stages) {
  const FlatSheets sheets = create_intersection_points(stages.input, stages.intersections()).sheets;
  std::vector<EdgeKey> found;
  for (const Triangle& triangle : stages.input.triangles) {
    for (Feature f = 3; f < kInside; ++f) {
      const EdgeKey edge = edge_of(triangle, f);
      if (sheets.at(edge) != nullptr) {
        found.push_back(edge);
      }
    }
  }
  std::ranges::sort(found);
  const auto twice = std::ranges::unique(found);
  EXPECT_EQ(std::size_t(twice.end() - twice.begin()), found.size() / 2) << "all of two triangles";
  return std::size_t(twice.begin() - found.begin());
}

// Boxes on either side of a plane, in which one is cut along one axis, and one along the other.
std::vector<TriMesh> crossed(std::size_t count) {
  return {strips(7, 8, count, -1, 0, 0), strips(6, 9, count, 0, 1, 1)};
}

TEST(FlatSheets, have_the_edges_that_others_cross_in_their_plane) {
  for (const std::size_t count : {2U, 5U, 9U}) {
    test::Stages stages(crossed(count));
    EXPECT_GE(edges_inside(stages), 2 * (count - 1));
    EXPECT_LE(edges_inside(stages), 2 * (2 * count - 1)) << "and diagonals";
    test::Stages above({crossed(count)[0], strips(6, 9, count, .5, 1, 1)});
    EXPECT_EQ(edges_inside(above), 0U) << "in another plane";
  }
}

TEST(FlatSheets, end_where_labels_do) {
  std::vector<TriMesh> meshes = crossed(5);
  for (TriMesh& mesh : meshes) {
    mesh.names = {"one", "two"};
    mesh.labels.assign(mesh.triangles.size(), 1);
  }
  test::Stages alike(meshes);
  const std::size_t all = edges_inside(alike);
  for (std::size_t t = 0; t < meshes[0].triangles.size(); t += 2) {
    meshes[0].labels[t] = 0;
  }
  test::Stages other(meshes);
  EXPECT_LT(edges_inside(other), all);
  for (TriMesh& mesh : meshes) {
    mesh.names.clear();
    mesh.labels.clear();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      mesh.names.push_back("t" + std::to_string(t));
      mesh.labels.push_back(t);
    }
  }
  test::Stages apart(meshes);
  EXPECT_EQ(edges_inside(apart), 0U);
}

TEST(FlatSheets, are_none_of_copies) {
  test::Stages stages({strips(7, 8, 5, -1, 0, 0), strips(7, 8, 5, -1, 0, 0), crossed(5)[1]});
  EXPECT_LE(edges_inside(stages), 9U) << "of the third";
}

// As many as the ends have corners, and not their square, however they are turned.
TEST(FlatSheets, leave_no_trace_of_edges_that_cross) {
  for (const int sides : {8, 32, 128}) {
    for (const char* const kind : {"", "_rot"}) {
      const std::vector<Solid> pipes =
          test::solids_of(test::pipe_case("flush_" + std::to_string(sides) + kind));
      const Solid united = test::arranged(pipes, union_rule(2));
      EXPECT_TRUE(test::is_closed_manifold(united.exact()));
      EXPECT_EQ(test::self_intersections(united.exact()), 0U);
      if (*kind == '\0') {
        EXPECT_LE(united.exact().triangles.size(), 20U * unsigned(sides)) << sides;
      }
    }
  }
}

}  // namespace
}  // namespace dupin::arrangement
