#include <set>

#include <gtest/gtest.h>

#include "arrangement/intersection_points.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

using Vector = std::array<mpq_class, 3>;

mpq_class dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Exactly: in the plane, and on the inner side of each edge or on it.
bool contains(const test::Stages& stages, const Triangle& corners, PointId point) {
  const Vector normal = stages.area_vector(corners);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector part = stages.area_vector({corners[k], corners[(k + 1) % 3], point});
    if (dot(part, normal) < 0) {
      return false;
    }
  }
  const Vector a = stages.place(corners[0]), p = stages.place(point);
  return dot(normal, {p[0] - a[0], p[1] - a[1], p[2] - a[2]}) == 0;
}

class IntersectionPointsOf : public testing::TestWithParam<test::Meeting> {
 protected:
  test::Stages stages{GetParam().solids};
  std::vector<TriangleIntersection> intersections = stages.intersections();
  IntersectionPoints points = create_intersection_points(stages.input, intersections);
};

TEST_P(IntersectionPointsOf, lie_on_both_triangles) {
  ASSERT_EQ(points.ends.size(), 2 * intersections.size());
  for (std::size_t i = 0; i < intersections.size(); ++i) {
    const TriangleIntersection& e = intersections[i];
    for (std::size_t end = 0; end < 2; ++end) {
      const bool exists = !points.facets.is_joint(e, end) &&
                          (e.kind == TriangleIntersection::Kind::segment ||
                           (e.kind == TriangleIntersection::Kind::point && end == 0));
      const PointId id = points.ends[2 * i + end];
      ASSERT_EQ(id != kNone, exists);
      if (exists) {
        EXPECT_TRUE(contains(stages, stages.input.triangles[e.first], id));
        EXPECT_TRUE(contains(stages, stages.input.triangles[e.second], id));
      }
    }
  }
}

TEST_P(IntersectionPointsOf, are_numbered_by_first_appearance) {
  PointId next = points.first_new_point;
  std::set<PointId> corners;
  for (const PointId id : points.ends) {
    if (id == kNone) {
      continue;
    }
    EXPECT_LE(id, next);
    next += id == next ? 1 : 0;
    if (id < points.first_new_point) {
      corners.insert(id);
    }
  }
  EXPECT_EQ(next, stages.input.points.size());
  EXPECT_EQ(points.corners, std::vector(corners.begin(), corners.end()));
}

INSTANTIATE_TEST_SUITE_P(Meetings, IntersectionPointsOf, testing::ValuesIn(test::meetings()),
                         test::meeting_name);

TEST(IntersectionPoints, are_one_for_the_triangles_on_both_sides_of_an_edge) {
  // Four edges of a bar pass through the middle of a face; each is met by two of the bar's faces.
  test::Stages stages({test::box({0, 0, 0}, {9, 7, 1}), test::box({4, 1, -1}, {5, 2, 0.5})});
  const auto intersections = stages.intersections();
  const IntersectionPoints points = create_intersection_points(stages.input, intersections);
  std::set<std::array<std::string, 3>> at_corners;
  std::set<PointId> ids;
  for (const PointId id : points.ends) {
    const auto p = id == kNone ? std::array<mpq_class, 3>{} : stages.place(id);
    if (id != kNone && (p[0] == 4 || p[0] == 5) && (p[1] == 1 || p[1] == 2)) {
      ids.insert(id);
      at_corners.insert({p[0].get_str(), p[1].get_str(), p[2].get_str()});
    }
  }
  EXPECT_EQ(at_corners.size(), 4U);
  EXPECT_EQ(ids.size(), 4U);
}

}  // namespace
}  // namespace dupin::arrangement
