#include <cmath>

#include <gtest/gtest.h>

#include "meshing/edge_lengths.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

struct Case {
  explicit Case(TriMesh given)
      : mesh(std::move(given)),
        features(find_features(mesh, 0.7, 0.01, 0)),
        surface(mesh.points, mesh.triangles, features.regions) {}
  TriMesh mesh;
  Features features;
  mesh::ReferenceSurface surface;
};

TEST(EdgeLengths, are_what_curvature_allows) {
  const Case tube(test::tube(10, 0, 60, 512));
  const Vec3 on_rim(10, 0, 0);
  for (const double distance : {0.01, 0.04, 0.16}) {
    const EdgeLengths lengths(tube.surface, tube.features, distance, 8);
    // s a / 2 with a = s / R, found in steps of a fifth.
    const double best = std::sqrt(2 * 10 * distance);
    EXPECT_LE(lengths.at(on_rim), best * 1.05);
    EXPECT_GE(lengths.at(on_rim), best * 0.7);
  }
  const EdgeLengths coarse(tube.surface, tube.features, 100, 8);
  EXPECT_EQ(coarse.at(on_rim), 8) << "the largest allowed";
}

TEST(EdgeLengths, are_the_largest_on_flat_faces) {
  const Case box(test::box(Vec3::Zero(), Vec3(10, 10, 10)));
  EXPECT_EQ(EdgeLengths(box.surface, box.features, 0.01, 2).at(Vec3(5, 0, 0)), 2);
}

TEST(EdgeLengths, leave_room_to_faces_that_are_not_at_the_curve) {
  // Two boxes a gap apart: a rim of one, and the face of the other.
  const double gap = 0.125;
  const Case boxes(test::joined({test::box(Vec3::Zero(), Vec3(10, 10, 10)),
                                 test::box(Vec3(10 + gap, -5, -5), Vec3(20, 15, 15))}));
  const EdgeLengths lengths(boxes.surface, boxes.features, 0.01, 2);
  EXPECT_EQ(lengths.at(Vec3(10, 5, 0)), gap / 2);
  EXPECT_EQ(lengths.at(Vec3(0, 5, 0)), 2);
  EXPECT_EQ(lengths.at(Vec3(5, 5, 10)), 2) << "at no curve";
}

TEST(EdgeLengths, are_refused_with_a_distance_that_is_not_0) {
  const Vec3 place(2.1, 1.4, 2.1);
  EXPECT_NE(
      too_near(place, 0x1p-53).message().find("within 1.11022e-16 of each other near (2.1, 1.4"),
      std::string::npos);
  EXPECT_NE(too_near(place, 0).message().find("than doubles can tell near (2.1, 1.4, 2.1)"),
            std::string::npos);
}

}  // namespace
}  // namespace dupin::meshing
