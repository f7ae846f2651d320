#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "arrangement/faces/face_outlines.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

using Vector = std::array<mpq_class, 3>;

mpq_class dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

class OutlinesOf : public testing::TestWithParam<test::Meeting> {
 protected:
  test::Stages stages{GetParam().solids};
  Constraints constraints = stages.incidences();
  Subdivision divided = stages.subdivision(constraints);

  [[nodiscard]] std::span<const Subdivision::OutlineCorner> corners(std::size_t outline) const {
    const auto& [region, begin, end] = divided.outlines[outline];
    return std::span(divided.outline_corners).subspan(begin, end - begin);
  }
  [[nodiscard]] const Triangle& support(std::size_t outline) const {
    return stages.input.support(divided.regions[divided.outlines[outline].region].support);
  }
};

// With the areas that add up (face_triangulator_internal_test), regions side by side and no more.
TEST_P(OutlinesOf, regions_have_their_segments_between_them) {
  std::map<std::array<PointId, 3>, int> sides;  // by triangle
  for (std::size_t i = 0; i < divided.outlines.size(); ++i) {
    const auto around = corners(i);
    ASSERT_GE(around.size(), 3U);
    const std::uint32_t triangle = divided.regions[divided.outlines[i].region].support;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const auto &here = around[k], &onward = around[(k + 1) % around.size()];
      const PointId low = std::min(here.point, onward.point),
                    high = std::max(here.point, onward.point);
      ++sides[{triangle, low, high}];
      EXPECT_GT(dot(stages.area_vector({here.point, onward.point, here.apex}),
                    stages.area_vector(support(i))),
                0)
          << "the apex lies where the region does";
    }
  }
  for (const Constraints::Segment& s : constraints.segments) {
    const auto side = sides.find({s.triangle, std::min(s.from, s.to), std::max(s.from, s.to)});
    EXPECT_TRUE(side == sides.end() || side->second == 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Meetings, OutlinesOf, testing::ValuesIn(test::meetings()),
                         test::meeting_name);

TEST(FaceOutlines, are_what_most_faces_have) {
  test::Stages stages({test::tube(1, -3, 3, 12), test::box({-3, -0.5, -0.25}, {3, 0.5, 0.25})});
  Constraints constraints = stages.incidences();
  const Subdivision divided = stages.subdivision(constraints);
  EXPECT_GT(divided.outlines.size(), 20U);
  EXPECT_EQ(divided.outlines.size(), divided.regions.size());
  EXPECT_TRUE(divided.triangles.empty());
}

// Segments in a triangle of the plane x + y + z = 64, each between two of the points.
struct Drawing {
  std::vector<std::array<int, 2>> points;            // by x and y; on an edge, as they follow on it
  std::vector<std::array<std::size_t, 2>> segments;  // by the triangle's corners, then these
};

bool finds_outlines(const Drawing& drawing) {
  TriMesh mesh;
  mesh.points = {Vec3(0, 0, 64), Vec3(64, 0, 0), Vec3(0, 64, 0), Vec3(0, 0, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  test::Stages stages({mesh});
  Constraints constraints = stages.incidences();
  const auto [a, b, c] = stages.input.triangles[0];
  std::vector<PointId> ids = {a, b, c};
  for (const auto& [x, y] : drawing.points) {
    ids.push_back(stages.input.points.add(Vec3(x, y, 64 - x - y)));
  }
  for (std::size_t i = 3; i < ids.size(); ++i) {
    const auto& [x, y] = drawing.points[i - 3];
    if (x > 0 && y > 0 && x + y < 64) {
      constraints.insides.push_back({0, ids[i]});
    } else {
      constraints.on_edges.push_back({y == 0   ? edge_key(a, b)
                                      : x == 0 ? edge_key(a, c)
                                               : edge_key(b, c),
                                      ids[i]});
    }
  }
  std::ranges::stable_sort(constraints.on_edges, {}, &Constraints::OnEdge::edge);
  for (const auto& [from, to] : drawing.segments) {
    constraints.segments.push_back({0, ids[from], ids[to], kNone});
  }
  FaceOutlines outlines(stages.input, constraints);
  return outlines.find(0, projection_of(stages.input.points, stages.input.triangles[0]));
}

TEST(FaceOutlines, are_of_simple_regions_that_hang_together) {
  EXPECT_TRUE(finds_outlines({{}, {}})) << "the triangle";
  EXPECT_TRUE(finds_outlines({{{10, 0}, {0, 10}}, {{3, 4}}})) << "across a corner";
  EXPECT_TRUE(finds_outlines({{{10, 0}, {0, 10}, {9, 9}}, {{3, 5}, {5, 4}}})) << "a bent way";
  EXPECT_TRUE(finds_outlines({{{10, 0}, {0, 10}, {5, 5}}, {{3, 5}, {5, 4}}})) << "a straight one";
  EXPECT_TRUE(finds_outlines({{{9, 9}}, {{0, 3}, {1, 3}, {2, 3}}})) << "a star";
  EXPECT_TRUE(finds_outlines({{{10, 0}, {0, 10}}, {{3, 4}, {4, 3}}})) << "the same twice";
  EXPECT_FALSE(finds_outlines({{{9, 9}}, {}})) << "a point alone";
  EXPECT_FALSE(finds_outlines({{{9, 9}}, {{0, 3}}})) << "a dead end";
  EXPECT_FALSE(finds_outlines({{{9, 9}, {12, 9}, {9, 12}}, {{3, 4}, {4, 5}, {5, 3}}})) << "a hole";
  EXPECT_FALSE(finds_outlines({{{9, 9}, {12, 9}, {9, 12}}, {{3, 4}, {4, 5}, {5, 3}, {0, 3}}}))
      << "one on a bridge";
  EXPECT_FALSE(finds_outlines({{{10, 0}, {0, 5}, {20, 0}, {0, 10}}, {{3, 6}, {5, 4}}}))
      << "segments that cross";
  EXPECT_FALSE(finds_outlines({{{10, 0}, {0, 10}, {5, 5}}, {{3, 4}, {0, 5}}}))
      << "one that ends on another";
  EXPECT_FALSE(finds_outlines({{{10, 0}, {0, 10}, {5, 5}}, {{3, 4}, {3, 5}, {5, 4}}}))
      << "segments on one another";
  EXPECT_FALSE(finds_outlines({{{10, 0}}, {{0, 3}}})) << "along an edge";
  EXPECT_FALSE(finds_outlines({{{9, 9}, {5, 20}, {30, 20}, {20, 20}},
                               {{0, 3}, {1, 3}, {2, 3}, {3, 4}, {4, 2}, {6, 3}, {6, 5}, {5, 3}}}))
      << "two that meet in a point";
}

// Regions of all kinds: a polygon that goes round once, with spikes, bays and straight angles.
TEST(OutlineTriangulator, fills_polygons_exactly) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.05, 1);
  std::size_t tried = 0;
  for (const std::uint32_t count : {3U, 4U, 5U, 8U, 20U, 100U}) {
    for (int round = 0; round < 20; ++round, ++tried) {
      test::Stages stages({test::tetrahedron()});
      const std::uint32_t plane =
          static_cast<std::uint32_t>(stages.input.triangles.size());  // of three points below
      Subdivision divided;
      // On a lattice, so that x + y + z = 0 holds exactly; each third corner lies on a line.
      std::vector<Vec3> corners;
      for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count, radius = 1 + 3 * part(random);
        const double x = std::round(0x1p20 * radius * std::cos(angle)) * 0x1p-18,
                     y = std::round(0x1p20 * radius * std::sin(angle)) * 0x1p-18;
        corners.push_back({x, y, -x - y});
        if (i % 3 == 2) {
          const Vec3 middle = (corners[corners.size() - 2] + corners.back()) / 2;
          corners.insert(corners.end() - 1, middle);
        }
      }
      for (const Vec3& corner : corners) {
        divided.outline_corners.push_back({stages.input.points.add(corner), 0, 0});
      }
      const PointId o = stages.input.points.add(Vec3(0, 0, 0)),
                    u = stages.input.points.add(Vec3(1, 0, -1)),
                    v = stages.input.points.add(Vec3(0, 1, -1));
      stages.input.triangles.push_back({o, u, v});
      divided.regions.push_back({0, 0, plane});
      divided.outlines.push_back({0, 0, static_cast<std::uint32_t>(corners.size())});
      std::vector<Subdivision::SubTriangle> triangles;
      OutlineTriangulator(stages.input).append(divided, divided.outlines[0], triangles);
      ASSERT_EQ(triangles.size(), corners.size() - 2);
      Vector sum, expected;
      for (const Subdivision::SubTriangle& t : triangles) {
        const Vector area = stages.area_vector(t.corners);
        ASSERT_GT(area[2], 0) << "turned as the plane";
        for (std::size_t k = 0; k < 3; ++k) {
          sum[k] += area[k];
        }
      }
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector area =
            stages.area_vector({o, divided.outline_corners[i].point,
                                divided.outline_corners[(i + 1) % corners.size()].point});
        for (std::size_t k = 0; k < 3; ++k) {
          expected[k] += area[k];
        }
      }
      ASSERT_EQ(sum, expected);
    }
  }
  EXPECT_EQ(tried, 120U);
}

}  // namespace
}  // namespace dupin::arrangement
