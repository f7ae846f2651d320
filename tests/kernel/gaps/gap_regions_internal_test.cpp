#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "gaps/gap_regions.h"
#include "support/shapes.h"

namespace dupin::gaps {
namespace {

predicates::ExactTriangle exact(const std::array<Vec3, 3>& corners) {
  return {exact::exact_vector(corners[0]), exact::exact_vector(corners[1]),
          exact::exact_vector(corners[2])};
}

TEST(OpposingFaces, are_told_by_the_cosine_exactly) {
  const auto up = exact({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  const auto down = exact({Vec3(0, 0, 1), Vec3(0, 1, 1), Vec3(1, 0, 1)});
  EXPECT_TRUE(opposed(up, down, 1));
  EXPECT_FALSE(opposed(up, up, 1e-9));
  // Tilted about the y axis, the tangent 3/4: the cosine is 4/5.
  const auto tilted = exact({Vec3(0, 0, 1), Vec3(0, 1, 1), Vec3(4, 0, 4)});
  EXPECT_TRUE(opposed(up, tilted, 0.75));
  EXPECT_FALSE(opposed(up, tilted, 0.875));
  EXPECT_EQ(opposed(up, tilted, 0.8), mpq_class(0.8) <= mpq_class(4, 5));
}

using Point2 = std::array<mpq_class, 2>;

mpq_class turn(const Point2& a, const Point2& b, const Point2& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/// Twice the area that two counter-clockwise triangles have in common, by clipping.
mpq_class common_area(std::vector<Point2> part, const std::vector<Point2>& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 &a = other[i], &b = other[(i + 1) % 3];
    std::vector<Point2> kept;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Point2 &p = part[k], &q = part[(k + 1) % part.size()];
      const mpq_class from = turn(a, b, p), to = turn(a, b, q);
      if (from >= 0) {
        kept.push_back(p);
      }
      if (sgn(from) * sgn(to) < 0) {
        const mpq_class t = from / (from - to);
        kept.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
      }
    }
    part = kept;
  }
  mpq_class area = 0;
  for (std::size_t k = 1; k + 1 < part.size(); ++k) {
    area += turn(part[0], part[k], part[k + 1]);
  }
  return area;
}

TEST(OpposingFaces, lie_in_front_of_each_other_where_they_overlap) {
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<int>(random() % 5); };
  int in = 0, out = 0;
  for (int i = 0; i < 4000; ++i) {
    std::array<Vec3, 3> a, b;
    std::vector<Point2> flat_a, flat_b;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = Vec3(number(), number(), 0);
      b[k] = Vec3(number(), number(), 3);
      flat_a.push_back({a[k].x(), a[k].y()});
      flat_b.push_back({b[k].x(), b[k].y()});
    }
    if (turn(flat_a[0], flat_a[1], flat_a[2]) <= 0 || turn(flat_b[0], flat_b[1], flat_b[2]) <= 0) {
      continue;
    }
    std::swap(b[1], b[2]);  // looks down
    const bool overlap = common_area(flat_a, flat_b) > 0;
    ASSERT_EQ(in_front(exact(a), exact(b)), overlap);
    ASSERT_EQ(in_front(exact(b), exact(a)), overlap);
    for (Vec3& p : b) {
      p.z() = -3;
    }
    ASSERT_FALSE(in_front(exact(a), exact(b))) << "passed each other";
    (overlap ? in : out) += 1;
  }
  EXPECT_GT(in, 200);
  EXPECT_GT(out, 200);
}

/// Squares of side 1 in the plane of height `z`, `count` in a row from x = `from`.
TriMesh plate(int from, int count, double z, bool up) {
  TriMesh mesh;
  for (int i = 0; i <= count; ++i) {
    mesh.points.emplace_back(from + i, 0, z);
    mesh.points.emplace_back(from + i, 1, z);
  }
  for (std::uint32_t i = 0; i < 2 * static_cast<std::uint32_t>(count); i += 2) {
    mesh.triangles.push_back({i, i + 2, i + 3});
    mesh.triangles.push_back({i, i + 3, i + 1});
  }
  return up ? mesh : test::reversed(mesh);
}

TEST(GapRegions, are_joined_along_neighbours_and_measured) {
  const TriMesh below = plate(0, 9, 0, true);
  const TriMesh above = test::joined({plate(0, 2, 0.25, false), plate(6, 2, 0.5, false),
                                      plate(3, 2, 4, false), plate(3, 2, 0.25, true)});
  const MeshPair pair = merged(below, above);
  const FaceBoxIndex boxes(pair);
  const auto regions = gap_regions(pair, boxes, {.connect = 1});
  ASSERT_EQ(regions.size(), 2);
  EXPECT_EQ(regions[0].faces_a, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(regions[0].faces_b, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(regions[0].least_squared, mpq_class(1, 16));
  EXPECT_EQ(regions[0].greatest, (Enclosure{0.25, 0.25}));
  EXPECT_EQ(regions[0].pairs, 4) << "triangles that share a diagonal only do not look at others";
  EXPECT_EQ(regions[1].faces_b, (std::vector<std::uint32_t>{4, 5, 6, 7}));
  EXPECT_EQ(regions[1].least, (Enclosure{0.5, 0.5}));
}

}  // namespace
}  // namespace dupin::gaps
