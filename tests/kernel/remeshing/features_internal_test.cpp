#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "remeshing/features.h"
#include "support/shapes.h"

namespace dupin::remeshing {
namespace {

using dupin::test::box;
using dupin::test::tube;

Features features_of(const TriMesh& mesh) {
  return find_features(mesh, std::vector<std::uint8_t>(mesh.points.size(), 0), {0.7, 0.01});
}

TEST(Features, of_a_box_are_its_edges) {
  const Features features = features_of(box(Vec3::Zero(), Vec3(1, 2, 3)));
  EXPECT_EQ(features.curves.size(), 12U);
  EXPECT_EQ(*std::ranges::max_element(features.regions), 5U);
  EXPECT_TRUE(std::ranges::all_of(features.freedoms,
                                  [](Freedom freedom) { return freedom == Freedom::none; }));
}

TEST(Features, of_a_tube_are_two_loops_with_one_corner_each) {
  const TriMesh mesh = tube(1, 0, 4, 64);
  const Features features = features_of(mesh);
  ASSERT_EQ(features.curves.size(), 2U);
  for (const Curve& curve : features.curves) {
    EXPECT_EQ(curve.ends[0], curve.ends[1]);
    EXPECT_NEAR(curve.length(), 128 * std::sin(M_PI / 64), 1e-12);
  }
  EXPECT_EQ(std::ranges::count(features.freedoms, Freedom::none), 2);
  EXPECT_EQ(std::ranges::count(features.freedoms, Freedom::curve), 126);
}

TEST(Features, are_borders_between_labels_too) {
  TriMesh mesh = tube(1, 0, 4, 64);
  mesh.names = {"wall", "end"};
  for (const Triangle& t : mesh.triangles) {
    const bool is_end = mesh.points[t[0]].z() == mesh.points[t[1]].z() &&
                        mesh.points[t[0]].z() == mesh.points[t[2]].z();
    mesh.labels.push_back(is_end ? 1 : 0);
  }
  const Features features =
      find_features(mesh, std::vector<std::uint8_t>(mesh.points.size(), 0), {3, 0.01});
  EXPECT_EQ(features.curves.size(), 2U);
}

TEST(Curve, is_no_further_from_a_chord_than_it_says) {
  const TriMesh mesh = tube(1, 0, 4, 256);
  const Features features = features_of(mesh);
  const Curve& curve = features.curves[0];
  const double from = 0.3, to = 1.1;
  const Vec3 a = curve.at(from), b = curve.at(to);
  const double bound = curve.deviation(from, to, a, b);
  EXPECT_NEAR(bound, 1 - std::cos(0.4), 1e-3);
  EXPECT_EQ(bound, curve.deviation(to, from, b, a));
  for (double at = from; at < to; at += 0.01) {
    const Vec3 p = curve.at(at);
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    EXPECT_LE((a + t * (b - a) - p).norm(), bound + 1e-12);
  }
}

}  // namespace
}  // namespace dupin::remeshing
