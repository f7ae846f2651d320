#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checking/self_intersection.h"
#include "mesh/coincident_points.h"
#include "support/clipped_triangle.h"

namespace dupin::checking {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = FacePair::Kind;

struct Soup {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;

  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t face) const {
    const Triangle& t = triangles[face];
    return {points[t[0]], points[t[1]], points[t[2]]};
  }
};

/// Random triangles over the points of a coarse grid: full of degenerate positions. About one point
/// in four has a twin with the same coordinates.
Soup random_soup(std::mt19937& random, int side, std::uint32_t points, int triangles) {
  std::uniform_int_distribution<int> coordinate(0, side);
  std::uniform_int_distribution<std::uint32_t> index(0, points - 1);
  Soup soup;
  while (soup.points.size() < points) {
    const bool twin = !soup.points.empty() && random() % 4 == 0;
    soup.points.push_back(twin ? soup.points[random() % soup.points.size()]
                               : Vec3(coordinate(random), coordinate(random), coordinate(random)));
  }
  for (int i = 0; i < triangles; ++i) {
    soup.triangles.push_back({index(random), index(random), index(random)});
  }
  return soup;
}

bool is_degenerate(const Soup& soup, std::uint32_t face) {
  const auto [a, b, c] = soup.corners(face);
  return test::on_one_line({test::rational(a), test::rational(b), test::rational(c)});
}

/// Corners of the same coordinates.
std::vector<test::Rational3> shared(const Soup& soup, std::uint32_t f, std::uint32_t g) {
  std::vector<test::Rational3> common;
  for (const Vec3& p : soup.corners(f)) {
    for (const Vec3& q : soup.corners(g)) {
      if (p == q) {
        common.push_back(test::rational(p));
      }
    }
  }
  return common;
}

bool same_indices(const Soup& soup, std::uint32_t f, std::uint32_t g) {
  std::size_t equal = 0;
  for (const std::uint32_t i : soup.triangles[f]) {
    equal += std::ranges::count(soup.triangles[g], i);
  }
  return equal == shared(soup, f, g).size();
}

std::vector<FacePair> brute_force(const Soup& soup) {
  std::vector<FacePair> pairs;
  for (std::uint32_t f = 0; f < soup.triangles.size(); ++f) {
    for (std::uint32_t g = f + 1; g < soup.triangles.size(); ++g) {
      if (is_degenerate(soup, f) || is_degenerate(soup, g)) {
        continue;
      }
      auto part = test::common_part(soup.corners(f), soup.corners(g));
      const auto common = shared(soup, f, g);
      const bool area = !test::on_one_line(part);
      // Beyond a common corner: another point; beyond a common edge: a point off its line, and
      // then, the triangles being convex, an area.
      const bool beyond = common.empty()
                              ? !part.empty()
                              : common.size() == 1 && std::ranges::any_of(part, [&](const auto& p) {
                                  return p != common[0];
                                });
      if (area || beyond) {
        pairs.push_back({f, g, area ? Kind::overlap : Kind::crossing});
      } else if (!same_indices(soup, f, g)) {
        pairs.push_back({f, g, Kind::contact});
      }
    }
  }
  return pairs;
}

TEST(SelfIntersection, agrees_with_clipping_in_rationals) {
  std::mt19937 random(20260701);
  std::set<Kind> seen;
  for (int round = 0; round < 400; ++round) {
    const int side = 1 + round % 5;
    const Soup soup = random_soup(random, side, 6 + round % 10, 14);
    const auto found = find_self_intersections(soup.points, soup.triangles);
    ASSERT_EQ(found.pairs, brute_force(soup)) << "round " << round;
    for (const FacePair& pair : found.pairs) {
      seen.insert(pair.kind);
    }
    for (std::uint32_t f = 0; f < soup.triangles.size(); ++f) {
      ASSERT_EQ(std::ranges::count(found.degenerate, f), is_degenerate(soup, f)) << round;
    }
  }
  EXPECT_EQ(seen.size(), 3);
}

TEST(SelfIntersection, of_needles_agrees_with_clipping_in_rationals) {
  std::mt19937 random(17);
  std::size_t pairs = 0;
  for (int round = 0; round < 20; ++round) {
    Soup soup;
    const auto near = [&](const Vec3& p) -> Vec3 {
      std::uniform_int_distribution<int> offset(-4, 4);
      return p + Vec3(offset(random), offset(random), offset(random));
    };
    for (std::uint32_t i = 0; i < 40; ++i) {
      const Vec3 from = near(Vec3::Zero());
      soup.points.insert(soup.points.end(), {from, near(from), near(Vec3(900, 700, -800))});
      soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto found = find_self_intersections(soup.points, soup.triangles);
    ASSERT_EQ(found.pairs, brute_force(soup)) << "round " << round;
    pairs += found.pairs.size();
  }
  EXPECT_GT(pairs, 1000U);
}

// Corners on one line but for rounding, on either side of the planes of triangles that have theirs
// there: as where surfaces cross.
TEST(SelfIntersection, at_rounded_creases_agrees_with_clipping_in_rationals) {
  std::mt19937 random(23);
  const Vec3 origin(0.1, 0.7, -0.3), direction(1.0 / 3, -0.71, 0.53);
  std::size_t pairs = 0, apart = 0;
  for (int round = 0; round < 40; ++round) {
    Soup soup;
    std::uniform_real_distribution<double> off(-1, 1);
    const auto on_crease = [&]() -> Vec3 { return origin + off(random) * direction; };
    const auto beside = [&]() -> Vec3 {
      return on_crease() + Vec3(off(random), off(random), off(random));
    };
    for (std::uint32_t i = 0; i < 24; ++i) {
      const Vec3 second = i % 3 == 0 ? on_crease() : beside();
      soup.points.insert(soup.points.end(), {on_crease(), second, beside()});
      soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto found = find_self_intersections(soup.points, soup.triangles);
    ASSERT_EQ(found.pairs, brute_force(soup)) << "round " << round;
    pairs += found.pairs.size();
    apart += 24 * 23 / 2 - found.pairs.size();
  }
  EXPECT_GT(pairs, 1000);
  EXPECT_GT(apart, 1000);
}

TEST(SelfIntersection, sees_the_same_after_an_exact_shear_off_the_axes) {
  // Multiplication by 3 and addition are exact here, so the shear keeps every coincidence while no
  // plane stays parallel to an axis.
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    Soup soup = random_soup(random, 4, 12, 20);
    const auto before = find_self_intersections(soup.points, soup.triangles);
    for (Vec3& p : soup.points) {
      p = Vec3(3 * p.x() + p.y(), 3 * p.y() + p.z() + 1e6, 3 * p.z() + p.x() - 1e5);
    }
    const auto after = find_self_intersections(soup.points, soup.triangles);
    ASSERT_EQ(before.pairs, after.pairs) << "round " << round;
    ASSERT_EQ(before.degenerate, after.degenerate) << "round " << round;
  }
}

/// The pairs that a single ulp decides: a triangle and one whose corner is lifted by `lift` ulp off
/// its oblique plane.
TEST(SelfIntersection, is_decided_by_one_ulp) {
  const double third = 1.0 / 3;
  Soup soup{
      {{0, 0, 0}, {1, 0, third}, {0, 1, third}, {0.25, 0.25, third / 2}, {1, 1, 9}, {0, 1, 9}},
      {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(find_self_intersections(soup.points, soup.triangles).crossings, 1);
  soup.points[3].z() = std::nextafter(third / 2, 1);
  EXPECT_EQ(find_self_intersections(soup.points, soup.triangles).crossings, 0);
}

TEST(SelfIntersection, keeps_the_lowest_pairs_and_complete_counts) {
  std::mt19937 random(3);
  const Soup soup = random_soup(random, 3, 40, 300);
  const auto all = find_self_intersections(soup.points, soup.triangles);
  ASSERT_GT(all.pairs.size(), 5000);
  const auto few = find_self_intersections(soup.points, soup.triangles, {.limit = 10});
  EXPECT_EQ(few.pairs, std::vector(all.pairs.begin(), all.pairs.begin() + 10));
  EXPECT_EQ(few.crossings, all.crossings);
  EXPECT_EQ(few.overlaps, all.overlaps);
  EXPECT_EQ(few.contacts, all.contacts);
}

TEST(SelfIntersection, examines_the_pairs_of_active_triangles_only) {
  std::mt19937 random(11);
  const Soup soup = random_soup(random, 3, 30, 100);
  const auto all = find_self_intersections(soup.points, soup.triangles).pairs;
  for (const bool every_seventh : {true, false}) {  // or all others
    std::vector<std::uint8_t> active(soup.triangles.size());
    for (std::size_t i = 0; i < active.size(); ++i) {
      active[i] = (i % 7 == 0) == every_seventh ? 1 : 0;
    }
    std::vector<FacePair> expected = all;
    std::erase_if(expected, [&](const FacePair& pair) {
      return active[pair.first] == 0 && active[pair.second] == 0;
    });
    const auto found = find_self_intersections(soup.points, soup.triangles, {.active = active});
    EXPECT_EQ(found.pairs, expected);
    EXPECT_EQ(found.pairs.size(), found.crossings + found.overlaps + found.contacts);
    for (const std::uint32_t f : found.degenerate) {
      EXPECT_EQ(active[f], 1);
    }
  }
}

std::set<std::pair<std::uint32_t, std::uint32_t>> faces_of(const SelfIntersections& found) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> faces;
  for (const FacePair& pair : found.pairs) {
    faces.emplace(pair.first, pair.second);
  }
  return faces;
}

TEST(SelfIntersection, takes_points_that_coincide_for_the_same_where_told_so) {
  std::mt19937 random(11);
  std::size_t contacts = 0;
  for (int round = 0; round < 200; ++round) {
    const Soup soup = random_soup(random, 3, 24, 30);
    const SelfIntersections all = find_self_intersections(soup.points, soup.triangles);
    const std::vector<std::uint32_t> first = mesh::coincident_representatives(soup.points);
    EXPECT_EQ(
        find_self_intersections(soup.points, soup.triangles, {.representatives = first}).pairs,
        all.pairs);
    std::vector<std::uint32_t> none(soup.points.size());
    std::iota(none.begin(), none.end(), 0U);
    const SelfIntersections strict =
        find_self_intersections(soup.points, soup.triangles, {.representatives = none});
    EXPECT_EQ(strict.contacts, 0);
    EXPECT_EQ(faces_of(strict), faces_of(all)) << "round " << round;
    EXPECT_EQ(strict.degenerate, all.degenerate);
    contacts += all.contacts;
  }
  EXPECT_GT(contacts, 1000);
}

TEST(SelfIntersection, does_not_depend_on_the_order_of_the_triangles) {
  std::mt19937 random(12);
  const Soup soup = random_soup(random, 40, 800, 1500);
  Soup mixed = soup;
  std::vector<std::uint32_t> order(soup.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return soup.points[soup.triangles[a][0]].x() < soup.points[soup.triangles[b][0]].x();
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    mixed.triangles[i] = soup.triangles[order[i]];
  }
  const SelfIntersections one = find_self_intersections(soup.points, soup.triangles);
  const SelfIntersections other = find_self_intersections(mixed.points, mixed.triangles);
  EXPECT_EQ(one.crossings, other.crossings);
  EXPECT_EQ(one.overlaps, other.overlaps);
  EXPECT_EQ(one.contacts, other.contacts);
}

TEST(SelfIntersection, is_found_at_every_scale) {
  for (const double scale : {1e-300, 1e-150, 1e-12, 1.0, 1e12, 1e100, 1e300}) {
    Soup soup{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {2, 1, 2}, {9, 9, 9}},
              {{0, 1, 2}, {3, 4, 5}, {4, 5, 6}}};
    for (Vec3& p : soup.points) {
      p *= scale;
    }
    const auto found = find_self_intersections(soup.points, soup.triangles);
    EXPECT_THAT(found.pairs, ElementsAre(FacePair{0, 1, Kind::crossing})) << scale;
    EXPECT_THAT(found.degenerate, IsEmpty()) << scale;
  }
}

TEST(SelfIntersection, may_end_where_there_are_enough_pairs) {
  std::mt19937 random(11);
  const Soup soup = random_soup(random, 4, 60, 120);
  const std::size_t count = find_self_intersections(soup.points, soup.triangles).count();
  ASSERT_GT(count, 100);
  for (const std::size_t enough : {std::size_t{1}, count / 2, count, count + 1}) {
    const SelfIntersections found =
        find_self_intersections(soup.points, soup.triangles, {.enough = enough});
    EXPECT_EQ(found.is_cut_short, enough <= count) << enough;
    EXPECT_GE(found.count(), std::min(enough, count));
  }
}

TEST(SelfIntersection, of_nothing_is_nothing) {
  EXPECT_TRUE(find_self_intersections({}, {}).none());
}

TEST(SelfIntersection, counts_and_keeps_the_pairs_that_are_wanted) {
  std::mt19937 random(17);
  const Soup soup = random_soup(random, 40, 800, 1500);
  const SelfIntersections all = find_self_intersections(soup.points, soup.triangles);
  const auto wanted = [](const FacePair& pair) {
    return pair.kind == Kind::crossing && pair.first % 3 == 0;
  };
  std::vector<FacePair> expected;
  std::ranges::copy_if(all.pairs, std::back_inserter(expected), wanted);
  const SelfIntersections some =
      find_self_intersections(soup.points, soup.triangles, {.wanted = wanted});
  EXPECT_EQ(some.pairs, expected);
  EXPECT_EQ(some.crossings, expected.size());
  EXPECT_EQ(some.overlaps + some.contacts, 0);
  ASSERT_GT(expected.size(), 2);
  const auto first =
      find_self_intersections(soup.points, soup.triangles, {.limit = 1, .wanted = wanted});
  EXPECT_THAT(first.pairs, ElementsAre(expected.front()));
}

TEST(SelfIntersection, examines_the_pairs_that_it_is_told_to) {
  std::mt19937 random(18);
  const Soup soup = random_soup(random, 40, 800, 1500);
  const SelfIntersections all = find_self_intersections(soup.points, soup.triangles);
  const auto examined = [](std::uint32_t first, std::uint32_t second) {
    return (first + second) % 3 == 0;
  };
  std::vector<FacePair> expected = all.pairs;
  std::erase_if(expected, [&](const FacePair& pair) { return !examined(pair.first, pair.second); });
  const SelfIntersections some =
      find_self_intersections(soup.points, soup.triangles, {.examined = examined});
  EXPECT_EQ(some.pairs, expected);
  EXPECT_EQ(some.count(), expected.size());
  EXPECT_LT(10, expected.size());
  EXPECT_LT(expected.size(), all.pairs.size());
  EXPECT_EQ(some.degenerate, all.degenerate);
}

}  // namespace
}  // namespace dupin::checking
