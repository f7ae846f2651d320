#include <random>

#include <gtest/gtest.h>

#include "arrangement/points/coincident_point_index.h"
#include "arrangement/points/implicit_predicates.h"
#include "exact/exact_numbers.h"

namespace dupin::arrangement {
namespace {

using Kind = ImplicitPoint::Kind;
using Place = std::array<mpq_class, 3>;

Place place(const PointTable& points, PointId id) {
  const mesh::ExactPoint p = points.exact_value(id);
  const mpq_class w = exact::rational(p[3]);
  return {exact::rational(p[0]) / w, exact::rational(p[1]) / w, exact::rational(p[2]) / w};
}

class Points : public testing::Test {
 protected:
  PointId at(double x, double y, double z) { return points.add(Vec3(x, y, z)); }

  UpwardRounding rounding;
  PointTable points;
};

TEST_F(Points, are_where_a_line_meets_a_plane) {
  const PointId a = at(0, 0, 0), b = at(1, 2, 3), o = at(1, 0, 0), u = at(0, 1, 0), v = at(0, 0, 1);
  const PointId p = points.add(ImplicitPoint{Kind::line_plane, 0, {a, b, o, u, v}});
  EXPECT_EQ(place(points, p), (Place{mpq_class(1, 6), mpq_class(1, 3), mpq_class(1, 2)}));
}

TEST_F(Points, are_where_two_lines_cross) {
  const PointId a = at(0, 0, 5), b = at(3, 1, 5), c = at(0, 1, 5), d = at(1, 0, 5);
  const PointId p = points.add(ImplicitPoint{Kind::two_lines, 2, {a, b, c, d}});
  EXPECT_EQ(place(points, p), (Place{mpq_class(3, 4), mpq_class(1, 4), 5}));
}

TEST_F(Points, are_where_three_planes_meet) {
  const PointId o = at(0, 0, 0), x = at(1, 0, 0), y = at(0, 1, 0), z = at(0, 0, 1),
                xy = at(1, 1, 0), xyz = at(1, 1, 1), xzzz = at(1, 0, 3);
  const PointId p =
      points.add(ImplicitPoint{Kind::three_planes, 0, {x, y, z, o, xy, xyz, o, xzzz, y}});
  // x + y + z = 1, x = y, z = 3 x.
  EXPECT_EQ(place(points, p), (Place{mpq_class(1, 5), mpq_class(1, 5), mpq_class(3, 5)}));
}

// By any definition that doubles give, lines seen along any axis, with and without a zero there.
TEST_F(Points, are_meetings_of_lines_and_planes) {
  std::vector<PointId> given;
  for (int k = 0; k < 3; ++k) {
    for (const double height : {0.0, 0.75}) {
      const auto corner = [&](double u, double v) {
        Vec3 point;
        point[k] = height;
        point[(k + 1) % 3] = u;
        point[(k + 2) % 3] = v;
        return points.add(point);
      };
      given.insert(given.end(), {corner(0, 0), corner(3, 1), corner(0, 1), corner(1, 0)});
    }
  }
  const PointId o = at(1, 0, 0), u = at(0, 1, 0), v = at(0, 0, 1), far = at(2, 3, 5);
  const auto is_same_place = [this](PointId id) {
    ASSERT_TRUE(points.is_meeting(id));
    const PointId other = points.add(points.meeting(id).point());
    EXPECT_EQ(place(points, other), place(points, id));
  };
  for (std::uint8_t k = 0; k < 3; ++k) {
    for (std::size_t i = 8 * k; i < 8 * k + 8U; i += 4) {
      is_same_place(points.add(
          ImplicitPoint{Kind::two_lines, k, {given[i], given[i + 1], given[i + 2], given[i + 3]}}));
    }
  }
  const PointId p = points.add(ImplicitPoint{Kind::line_plane, 0, {given[0], far, o, u, v}});
  is_same_place(p);
  EXPECT_FALSE(
      points.is_meeting(points.add(ImplicitPoint{Kind::line_plane, 0, {p, far, o, u, v}})));
  EXPECT_FALSE(points.is_meeting(points.add(points.exact_value(p)))) << "given by its coordinates";
  EXPECT_FALSE(points.is_meeting(points.add(
      ImplicitPoint{Kind::three_planes, 0, {o, u, v, given[0], far, u, given[0], far, v}})));
}

TEST_F(Points, have_the_same_balls_after_these_were_forgotten) {
  const PointId a = at(0, 0, 0), b = at(1, 2, 3), o = at(1, 0, 0), u = at(0, 1, 0), v = at(0, 0, 1);
  const PointId p = points.add(ImplicitPoint{Kind::line_plane, 0, {a, b, o, u, v}});
  const PointId given = points.add(points.exact_value(p));
  const auto bounds = [&] {
    const exact::Ball x = points.ball(p)[0], y = points.ball(given)[1];
    return std::array{x.infimum(), x.supremum(), y.infimum(), y.supremum()};
  };
  const auto before = bounds();
  points.forget_balls();
  EXPECT_EQ(bounds(), before);
  EXPECT_LE(before[0], 1.0 / 6);
  EXPECT_GE(before[1], 1.0 / 6);
}

// Random lines and planes, nearly parallel ones among them.
TEST_F(Points, lie_within_their_intervals) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<std::array<PointId, 5>> given;
  for (int round = 0; round < 300; ++round) {
    const double slope = round % 3 == 0 ? 0x1p-40 : 1;
    std::array<PointId, 5> ids{};
    for (std::size_t k = 0; k < ids.size(); ++k) {
      ids[k] = at(uniform(random), uniform(random), slope * uniform(random));
    }
    given.push_back(ids);
  }
  for (const auto& ids : given) {
    ImplicitPoint definition{Kind::line_plane, 0, {}};
    std::copy(ids.begin(), ids.end(), definition.of.begin());
    const PointId p = points.add(definition);
    const Place exact = place(points, p);
    const auto expect_within = [&] {
      for (int k = 0; k < 3; ++k) {
        const Interval i = points.interval(p, k);
        EXPECT_TRUE(!std::isfinite(i.inf()) || exact[static_cast<std::size_t>(k)] >= i.inf());
        EXPECT_TRUE(!std::isfinite(i.sup()) || exact[static_cast<std::size_t>(k)] <= i.sup());
      }
    };
    expect_within();
    points.tighten(p);
    expect_within();
    for (int k = 0; k < 3; ++k) {
      const Interval i = points.interval(p, k);
      EXPECT_LE(i.sup() - i.inf(), 0x1p-40 * (1 + std::abs(i.sup())));
    }
    const ImplicitPoint& d = points.definition(p);
    EXPECT_EQ(side_of_plane(points, d.of[2], d.of[3], d.of[4], p), 0) << "by exact arithmetic";
  }
}

// Of each kind, and by exact coordinates alone. Balls tell apart what intervals do not.
TEST_F(Points, lie_within_their_balls) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<std::array<PointId, 9>> given;
  for (int round = 0; round < 100; ++round) {
    std::array<PointId, 9> ids{};
    for (std::size_t k = 0; k < ids.size(); ++k) {
      ids[k] = at(uniform(random), uniform(random), k < 4 ? 0 : uniform(random));
    }
    given.push_back(ids);
  }
  const auto expect_within = [&](PointId p) {
    const Place exact = place(points, p);
    const exact::BallPoint ball = points.ball(p);
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class off = exact[k] - mpq_class(ball[k].high()) - mpq_class(ball[k].low());
      EXPECT_LE(abs(off), mpq_class(ball[k].radius()));
      EXPECT_LE(ball[k].radius(), 0x1p-70 * (1 + std::abs(ball[k].high())));
    }
  };
  for (const auto& ids : given) {
    const PointId pierced =
        points.add(ImplicitPoint{Kind::line_plane, 0, {ids[4], ids[5], ids[6], ids[7], ids[8]}});
    const PointId crossed =
        points.add(ImplicitPoint{Kind::two_lines, 2, {ids[0], ids[1], ids[2], ids[3]}});
    const PointId corner = points.add(ImplicitPoint{Kind::three_planes, 0, ids});
    const PointId of_implicit =
        points.add(ImplicitPoint{Kind::line_plane, 0, {pierced, corner, ids[0], ids[4], ids[7]}});
    for (const PointId p : {pierced, crossed, corner, of_implicit}) {
      expect_within(p);
      // The same place, and one that is nearer than intervals tell.
      mesh::ExactPoint moved = points.exact_value(p);
      const PointId again = points.add(moved);
      expect_within(again);
      EXPECT_TRUE(coincide(points, p, again));
      moved[0] = moved[0] + moved[3] * CGAL::Mpzf(0x1p-65);
      const PointId beside = points.add(moved);
      EXPECT_EQ((points.ball(beside)[0] - points.ball(p)[0]).sign(), 1);
      EXPECT_EQ(compare(points, p, beside, 0), -1);
      EXPECT_EQ(turn_of(points.ball(p), points.ball(beside), points.ball(ids[6]), 2).sign,
                turn(points, p, beside, ids[6], 2));
      EXPECT_EQ(turn(points, p, again, ids[6], 2), 0);
    }
  }
}

TEST_F(Points, of_one_place_are_found_whatever_defines_them) {
  const PointId a = at(0, 0, 0), b = at(3, 1, 0), c = at(0, 1, 0), d = at(1, 0, 0), e = at(0, 1, 7),
                three_quarters = at(0.75, 0.25, 0), below = at(1, -1, 0);
  CoincidentPointIndex places(points, 7, 4);
  EXPECT_EQ(places.first_coincident(three_quarters), three_quarters);
  const PointId crossing = points.add(ImplicitPoint{Kind::two_lines, 2, {a, b, c, d}});
  EXPECT_EQ(places.first_coincident(crossing), three_quarters);
  const PointId piercing = points.add(ImplicitPoint{Kind::line_plane, 0, {a, b, c, d, e}});
  EXPECT_EQ(places.first_coincident(piercing), three_quarters);
  EXPECT_TRUE(coincide(points, crossing, piercing));
  const PointId elsewhere = points.add(ImplicitPoint{Kind::two_lines, 2, {a, b, c, below}});
  EXPECT_EQ(places.first_coincident(elsewhere), elsewhere);
}

}  // namespace
}  // namespace dupin::arrangement
