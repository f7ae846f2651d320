#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "meshing/delaunay_refinement.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

Refinement refinement(double length) {
  Refinement wanted;
  wanted.edge_length = [length](const Vec3&) { return length; };
  wanted.radius = length;
  wanted.distance = 0.01;
  wanted.smallest_angle = 0.43;
  wanted.fill = true;
  wanted.most_points = 100'000;
  return wanted;
}

Tetrahedra refined(const TriMesh& mesh, const Refinement& wanted) {
  return refine(mesh, find_features(mesh, 0.7, 0.01, 0), wanted, {});
}

double volume(const Tetrahedra& mesh) {
  double sum = 0;
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    const Vec3& p = mesh.points[a];
    sum += (mesh.points[b] - p).cross(mesh.points[c] - p).dot(mesh.points[d] - p) / 6;
  }
  return sum;
}

TEST(DelaunayRefinement, fills_a_box) {
  const Tetrahedra mesh = refined(test::box(Vec3::Zero(), Vec3(4, 2, 1)), refinement(0.5));
  EXPECT_NEAR(volume(mesh), 8, 1e-9);
  EXPECT_GT(mesh.tetrahedra.size(), 100U);
  EXPECT_EQ(mesh.triangles.size(), mesh.regions.size());
  EXPECT_EQ(*std::ranges::max_element(mesh.regions), 5U);
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    EXPECT_TRUE(is_positive(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]));
  }
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const Vec3 middle = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3;
    const Vec3 normal = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    EXPECT_GT(normal.dot(middle - Vec3(2, 1, 0.5)), 0) << "turned outward";
  }
}

// Without scaling there were none below 1e-30, or the generator crashed.
TEST(DelaunayRefinement, does_not_depend_on_the_unit) {
  const Tetrahedra one = refined(test::tube(2, 0, 6, 32), refinement(0.5));
  ASSERT_FALSE(one.tetrahedra.empty());
  for (const double unit : {0x1p-190, 0x1p-100, 0x1p-3, 0x1p20, 0x1p125}) {
    SCOPED_TRACE(unit);
    TriMesh mesh = test::tube(2, 0, 6, 32);
    for (Vec3& point : mesh.points) {
      point *= unit;
    }
    Refinement wanted = refinement(0.5 * unit);
    wanted.distance *= unit;
    Features features = find_features(test::tube(2, 0, 6, 32), 0.7, 0.01, 0);
    for (Curve& curve : features.curves) {
      for (Vec3& point : curve.points) {
        point *= unit;
      }
    }
    const Tetrahedra scaled = refine(mesh, features, wanted, {});
    EXPECT_EQ(scaled.tetrahedra, one.tetrahedra);
    ASSERT_EQ(scaled.points.size(), one.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i) {
      EXPECT_EQ(scaled.points[i], unit * one.points[i]);
    }
  }
}

TEST(DelaunayRefinement, is_the_same_each_time) {
  const TriMesh mesh = test::tube(2, 0, 6, 32);
  const Tetrahedra once = refined(mesh, refinement(0.5)), again = refined(mesh, refinement(0.5));
  EXPECT_EQ(once.points, again.points);
  EXPECT_EQ(once.tetrahedra, again.tetrahedra);
}

TEST(DelaunayRefinement, ends_at_the_number_of_points_allowed) {
  Refinement wanted = refinement(0.05);
  wanted.most_points = 500;
  try {
    (void)refined(test::box(Vec3::Zero(), Vec3(4, 2, 1)), wanted);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    EXPECT_THAT(error.what(), testing::HasSubstr("more than 500 points"));
  }
}

// Where it would go on and on, that is no fault of the limit.
TEST(DelaunayRefinement, gives_up_at_more_points_than_are_of_use) {
  const TriMesh box = test::box(Vec3::Zero(), Vec3(4, 2, 1));
  Refinement wanted = refinement(0.5);
  const std::size_t all = refined(box, wanted).points.size();
  wanted.most_useful_points = 2 * all;
  EXPECT_EQ(refined(box, wanted).points.size(), all);
  wanted.most_useful_points = all / 2;
  EXPECT_TRUE(refined(box, wanted).points.empty());
}

TEST(DelaunayRefinement, begins_at_seeds_where_there_are_no_curves) {
  const TriMesh mesh = test::tube(2, 0, 6, 32);
  const Features none = find_features(mesh, 3, 0.01, 0);
  ASSERT_TRUE(none.curves.empty());
  Refinement wanted = refinement(0.5);
  wanted.distance = 0.3;
  EXPECT_TRUE(refine(mesh, none, wanted, {}).tetrahedra.empty());
  for (const Vec3& point : {Vec3(2, 0, 3), Vec3(2, 0, 3.2), mesh.points[1], Vec3(0, 0, 0),
                            Vec3(0, 0, 6), mesh.points[16]}) {
    wanted.seeds.push_back({point, 0, true});
  }
  EXPECT_NEAR(volume(refine(mesh, none, wanted, {})), M_PI * 24, 0.2 * M_PI * 24);
}

}  // namespace
}  // namespace dupin::meshing
