#include <array>
#include <map>
#include <random>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "arrangement/points/coincident_point_index.h"
#include "exact/exact_numbers.h"

namespace dupin::arrangement {
namespace {

using Coordinates3 = std::array<mpq_class, 3>;

Coordinates3 exact_coordinates(const PointTable& points, PointId id) {
  const mesh::ExactPoint p = points.exact_value(id);
  const mpq_class w = exact::rational(p[3]);
  return {exact::rational(p[0]) / w, exact::rational(p[1]) / w, exact::rational(p[2]) / w};
}

// Of each point, by rational coordinates; how many differ.
std::size_t expect_first_coincident(PointTable& points, double extent) {
  CoincidentPointIndex index(points, extent, 10);
  std::map<Coordinates3, PointId> first;
  for (PointId id = 0; id < points.size(); ++id) {
    const PointId expected = first.emplace(exact_coordinates(points, id), id).first->second;
    EXPECT_EQ(index.first_coincident(id), expected) << id;
  }
  return first.size();
}

// Points of few coordinates, of any weight, some by 2^-60 beside others: far below their intervals
// and the cells of the index.
TEST(CoincidentPointIndex, finds_the_first_of_equal_points) {
  const UpwardRounding rounding;
  std::mt19937 random(17);
  for (const double extent : {1e-3, 4.0, 1e12}) {
    PointTable points;
    for (int i = 0; i < 100; ++i) {
      points.add(Vec3(static_cast<double>(random() % 3), static_cast<double>(random() % 3), 0) *
                 (extent / 4));
    }
    for (int i = 0; i < 400; ++i) {
      const double weight = static_cast<double>(1 + random() % 6);
      const double beside = random() % 2 == 0 ? 0 : 0x1p-60;
      mesh::ExactPoint p;
      p[3] = CGAL::Mpzf(weight);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto step = static_cast<double>(random() % 3);
        p[k] = CGAL::Mpzf(k == 2 ? 0 : weight * step * extent / 4) + CGAL::Mpzf(beside * extent);
      }
      points.add(p);
    }
    const std::size_t distinct = expect_first_coincident(points, extent);
    EXPECT_LT(distinct, 400U);
    EXPECT_GT(distinct, 20U);
  }
}

// Hundreds of points in one cell, each several times and of several weights; for some of these the
// prime of the names (exact/residue.h) divides the weight, so that they have none.
TEST(CoincidentPointIndex, tells_apart_what_is_crowded) {
  const UpwardRounding rounding;
  std::mt19937 random(23);
  PointTable points;
  points.add(Vec3(1, 1, 1));
  const CGAL::Mpzf prime = CGAL::Mpzf(0x1p61) - CGAL::Mpzf(1);
  for (int i = 0; i < 1500; ++i) {
    mesh::ExactPoint p;
    p[3] = random() % 8 == 0 ? prime : CGAL::Mpzf(static_cast<double>(1 + random() % 5));
    for (std::size_t k = 0; k < 3; ++k) {
      const double beside = static_cast<double>(random() % 7) * 0x1p-70;
      p[k] = p[3] * (CGAL::Mpzf(1) + CGAL::Mpzf(beside));
    }
    points.add(p);
  }
  const std::size_t distinct = expect_first_coincident(points, 4);
  EXPECT_GT(distinct, 300U);
  EXPECT_LT(distinct, 344U);
}

TEST(CoincidentPointIndex, tightens_what_is_wide_and_nothing_else) {
  const UpwardRounding rounding;
  PointTable points;
  // A line that rises by 2^-40 above the plane, and one across it.
  const Vec3 second(1, 1.0 / 3, 0.7), third(0.3, 1, 0.9), up(0, 0, 0x1p-40);
  const Vec3 from = (second + third) / 2 + up, to = from + second / 2 - third / 4 + up;
  const PointId o = points.add(Vec3(0, 0, 0)), u = points.add(second), v = points.add(third),
                a = points.add(from), b = points.add(to), z = points.add(Vec3(0.1, 0.7, 5));
  const PointId flat =
      points.add(ImplicitPoint{ImplicitPoint::Kind::line_plane, 0, {a, b, o, u, v}});
  const PointId steep =
      points.add(ImplicitPoint{ImplicitPoint::Kind::line_plane, 0, {a, z, o, u, v}});
  const auto width = [&points](PointId id) {
    const Interval x = points.interval(id, 0);
    return x.sup() - x.inf();
  };
  const double wide = width(flat), narrow = width(steep);
  ASSERT_GT(wide, 0x1p-38);
  ASSERT_LT(narrow, 0x1p-40);
  CoincidentPointIndex(points, 8, 2).tighten_wide(o, points.size());
  EXPECT_LT(width(flat), 0x1p-49);
  EXPECT_EQ(width(steep), narrow);
}

}  // namespace
}  // namespace dupin::arrangement
