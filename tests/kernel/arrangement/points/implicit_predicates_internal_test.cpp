#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "arrangement/points/implicit_predicates.h"
#include "exact/exact_numbers.h"

namespace dupin::arrangement {
namespace {

using Coordinates3 = std::array<mpq_class, 3>;

// Doubles of a coarse grid, and points on lines and planes through them: signs of 0 are common.
class Predicates : public testing::Test {
 protected:
  Predicates() {
    const auto coordinate = [this] { return static_cast<double>(random() % 5) - 2; };
    for (int i = 0; i < 40; ++i) {
      points.add(Vec3(coordinate(), coordinate(), coordinate()));
    }
    while (points.size() < 100) {
      add_where_a_line_meets_a_plane();
    }
    for (PointId id = 0; id < points.size(); ++id) {
      const mesh::ExactPoint p = points.exact_value(id);
      const mpq_class w = exact::rational(p[3]);
      exact_coordinates.push_back(
          {exact::rational(p[0]) / w, exact::rational(p[1]) / w, exact::rational(p[2]) / w});
    }
  }

  PointId any() { return static_cast<PointId>(random() % points.size()); }
  [[nodiscard]] const Coordinates3& at(PointId id) const { return exact_coordinates[id]; }

  // Of the vectors from a, seen along `axis`.
  [[nodiscard]] mpq_class turn_of(PointId a, PointId b, PointId c, int axis) const {
    const auto i = static_cast<std::size_t>((axis + 1) % 3),
               j = static_cast<std::size_t>((axis + 2) % 3);
    return (at(b)[i] - at(a)[i]) * (at(c)[j] - at(a)[j]) -
           (at(b)[j] - at(a)[j]) * (at(c)[i] - at(a)[i]);
  }
  [[nodiscard]] mpq_class volume_of(PointId a, PointId b, PointId c, PointId p) const {
    mpq_class sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      sum += turn_of(a, b, c, axis) * (at(p)[k] - at(a)[k]);
    }
    return sum;
  }

  UpwardRounding rounding;
  std::mt19937 random{6};
  PointTable points;
  std::vector<Coordinates3> exact_coordinates;

 private:
  void add_where_a_line_meets_a_plane() {
    ImplicitPoint definition{ImplicitPoint::Kind::line_plane, 0, {}};
    std::array<Vec3, 5> p;
    for (std::size_t k = 0; k < 5; ++k) {
      definition.of[k] = static_cast<PointId>(random() % points.double_count());
      p[k] = points.coordinates(definition.of[k]);
    }
    const Vec3 normal = (p[3] - p[2]).cross(p[4] - p[2]);
    if (normal.dot(p[1] - p[0]) != 0) {
      points.add(definition);
      points.add(definition);
    }
  }
};

TEST_F(Predicates, are_the_signs_of_exact_determinants) {
  std::array<int, 3> sides{}, turns{}, comparisons{};
  const auto count = [](std::array<int, 3>& seen, int sign) {
    ++seen[static_cast<std::size_t>(sign + 1)];
  };
  for (int round = 0; round < 5000; ++round) {
    const PointId a = any(), b = any(), c = any(), p = any();
    const int axis = round % 3;
    const auto k = static_cast<std::size_t>(axis);
    const int side = side_of_plane(points, a, b, c, p), turned = turn(points, a, b, c, axis),
              compared = compare(points, a, b, axis);
    ASSERT_EQ(side, sgn(volume_of(a, b, c, p)));
    ASSERT_EQ(turned, sgn(turn_of(a, b, c, axis)));
    ASSERT_EQ(compared, sgn(mpq_class(at(a)[k] - at(b)[k])));
    ASSERT_EQ(coincide(points, a, b), at(a) == at(b));
    count(sides, side);
    count(turns, turned);
    count(comparisons, compared);
  }
  for (const auto& seen : {sides, turns, comparisons}) {
    for (const int times : seen) {
      EXPECT_GT(times, 200) << "all signs occur";
    }
  }
}

TEST_F(Predicates, on_exact_points_are_the_same) {
  for (int round = 0; round < 1000; ++round) {
    const PointId a = any(), b = any(), c = any();
    const int axis = round % 3;
    const mesh::ExactPoint p = points.exact_value(a), q = points.exact_value(b),
                           r = points.exact_value(c);
    EXPECT_EQ(exact_turn(p, q, r, axis), sgn(turn_of(a, b, c, axis)));
    EXPECT_EQ(exact_compare(p, q, axis), compare(points, a, b, axis));
  }
}

TEST(FilteredSign, is_certain_only_where_the_interval_has_one_sign) {
  const UpwardRounding rounding;
  EXPECT_TRUE(sign_of(Interval(1, 2)).certain);
  EXPECT_EQ(sign_of(Interval(1, 2)).sign, 1);
  EXPECT_EQ(sign_of(Interval(-2, -1)).sign, -1);
  EXPECT_TRUE(sign_of(Interval(0, 0)).certain);
  EXPECT_FALSE(sign_of(Interval(0, 1)).certain);
  EXPECT_FALSE(sign_of(Interval(-1, 1)).certain);
}

// Fins at the edge from point 0 to point 1, which runs along (1, 2, 2).
struct Fins {
  ArrangementInput input;
  std::vector<double> angles;
  std::vector<HalfPlane> half_planes;
};

Fins random_fins(std::mt19937& random, std::uint32_t count) {
  const Vec3 axis(1, 2, 2), u(2, 1, -2), w = axis.cross(u) / 3;
  Fins fins;
  fins.input.points.add(Vec3(Vec3::Zero()));
  fins.input.points.add(axis);
  for (std::uint32_t i = 0; i < count; ++i) {
    // Whole steps, so that no two are nearly equal; opposite ones occur.
    double angle = 0;
    do {
      angle = 2 * M_PI * static_cast<double>(random() % 24) / 24;
    } while (std::find(fins.angles.begin(), fins.angles.end(), angle) != fins.angles.end());
    fins.angles.push_back(angle);
    const double along = static_cast<double>(random() % 9) - 4;
    const PointId apex =
        fins.input.points.add(Vec3(along * axis + std::cos(angle) * u + std::sin(angle) * w));
    const bool forward = random() % 2 == 0;
    fins.input.triangles.push_back(forward ? Triangle{0, 1, apex} : Triangle{1, 0, apex});
    fins.half_planes.push_back({apex, i, forward, i});
  }
  return fins;
}

TEST(FacetOrder, is_that_of_angles_from_the_first) {
  const UpwardRounding rounding;
  std::mt19937 random(23);
  for (int round = 0; round < 500; ++round) {
    Fins fins = random_fins(random, 2 + static_cast<std::uint32_t>(round) % 10);
    const auto from_first = [&](const HalfPlane& h) {
      const double turned = fins.angles[h.owner] - fins.angles[0];
      return turned < 0 ? turned + 2 * M_PI : turned;
    };
    std::vector<HalfPlane> expected = fins.half_planes;
    std::ranges::sort(expected, {}, from_first);
    order_facets_around_edge(fins.input, fins.half_planes);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(fins.half_planes[i].owner, expected[i].owner) << round;
    }
  }
}

}  // namespace
}  // namespace dupin::arrangement
