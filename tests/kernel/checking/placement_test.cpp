#include "dupin/kernel/placement.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "support/message_of.h"
#include "support/shapes.h"

namespace dupin {
namespace {

Placement::Point point(const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  return {x, y, z};
}

Placement turned(const Vec3& axis, double degrees, const Vec3& about = Vec3::Zero()) {
  Placement placement;
  placement.rotate(axis, degrees, about);
  return placement;
}

TEST(Placement, sizes_change_by_ratios_as_they_are) {
  Placement placement;
  placement.scale(10, 254);
  EXPECT_EQ(placement.place({25.4, 254, 0})[1], 10);
  EXPECT_EQ(placement.scaled(1), mpq_class(5, 127));
  EXPECT_TRUE(placement.is_exact());
  EXPECT_THROW(placement.scale(1, 0), Error);
  EXPECT_THROW(placement.scale(1, std::nan("")), Error);
}

TEST(Placement, quarter_turns_are_exact_in_whatever_way_they_are_typed) {
  const Vec3 p(0.1, 0.2, 0.3);
  const mpq_class x(0.1), y(0.2), z(0.3);
  for (const double whole : {0.0, 360.0, -360.0, 3600.0}) {
    for (const double length : {1.0, 0.1, 5.0, 1e-300, 1e300}) {
      const Vec3 up(0, 0, length);
      EXPECT_EQ(turned(up, whole).place(p), point(x, y, z));
      EXPECT_EQ(turned(up, whole + 90).place(p), point(-y, x, z));
      EXPECT_EQ(turned(up, whole + 180).place(p), point(-x, -y, z));
      EXPECT_EQ(turned(up, whole - 90).place(p), point(y, -x, z));
      EXPECT_EQ(turned(-up, whole + 270).place(p), point(-y, x, z));
      EXPECT_TRUE(turned(up, whole + 270).is_exact());
    }
  }
  EXPECT_EQ(turned(Vec3(1, 1, 1), 180).place(Vec3(3, 0, 0)), point(-1, 2, 2));
  EXPECT_EQ(turned(Vec3(3, 4, 0), 90).place(Vec3(0, 0, 5)), point(4, -3, 0));
  EXPECT_EQ(turned(Vec3::UnitX(), 90, Vec3(7, 1, 0)).place(Vec3(0, 2, 0)), point(0, 1, 1));
}

TEST(Placement, other_turns_keep_lengths_exactly_and_are_near_what_was_asked_for) {
  for (const double degrees : {1e-9, 12.5, 45.0, 60.0, 89.999, 90.0, 133.0, -200.0, 7531.0}) {
    const Vec3 axis(1, 2, 3);
    const Placement placement = turned(axis, degrees, Vec3(5, 0, 0));
    const Vec3 from = Vec3(1, -2, 0.7) - Vec3(5, 0, 0);
    const Placement::Point to = placement.place(Vec3(1, -2, 0.7));
    const Vec3 n = axis.normalized();
    const double angle = std::remainder(degrees, 360.0) * std::numbers::pi / 180;
    const Vec3 expected = Vec3(5, 0, 0) + from * std::cos(angle) + n.cross(from) * std::sin(angle) +
                          n * n.dot(from) * (1 - std::cos(angle));
    EXPECT_LT((nearest_point(to) - expected).norm(), 1e-14) << degrees;
    const mpq_class x = to[0] - 5;
    EXPECT_EQ(mpq_class(x * x + to[1] * to[1] + to[2] * to[2]),
              mpq_class(16 + 4 + mpq_class(0.7) * mpq_class(0.7)))
        << degrees;
    EXPECT_FALSE(placement.is_exact());
    EXPECT_GT(placement.error(6), 1e-14);
    EXPECT_LT(placement.error(6), 1e-13);
  }
}

TEST(Placement, steps_are_applied_one_after_the_other) {
  Placement placement;
  placement.translate(Vec3(1, 0, 0));
  placement.rotate(Vec3::UnitZ(), 90);
  placement.scale(2);
  placement.translate(Vec3(0.1, 0, 0));
  EXPECT_EQ(placement.place(Vec3(1, 0, 0)), point(mpq_class(0.1), 4, 0));
  EXPECT_EQ(placement.turn(Vec3(1, 0, 0)), point(0, 1, 0));
  EXPECT_EQ(placement.scaled(3), 6);
  EXPECT_TRUE(placement.is_exact());
  EXPECT_EQ(placement.error(1e6), 0);
}

TEST(Placement, a_solid_stays_one_whatever_becomes_of_it) {
  const Solid frame = Solid::from(test::frame());
  for (const double factor : {1.0, 25.4, 1 / 25.4, 0x1p-20}) {
    for (const double degrees : {0.0, 30.0, 90.0}) {
      Placement placement;
      placement.rotate(Vec3(1, 1, 0.3), degrees);
      placement.scale(factor);
      placement.translate(Vec3(1e5, -0.1, 3));
      const Solid solid = placed(frame, placement);
      const mpq_class size(factor);
      EXPECT_EQ(solid.exact_volume(), mpq_class(size * size * size * 64));
      EXPECT_EQ(solid.genus(), 1);
      const Rounded rounded = to_mesh(solid);
      EXPECT_TRUE(check(rounded.mesh()).is_solid());
      EXPECT_LT(rounded.report().largest_move, 1e-10);
    }
  }
}

TEST(Placement, a_solid_with_points_that_are_no_doubles_is_put_there_exactly) {
  // The edges of the tetrahedron meet the planes of the box in thirds.
  const Solid cut =
      subtract(Solid::from(test::tetrahedron(Vec3::Zero(), 1)),
               std::vector{Solid::from(test::tetrahedron(Vec3(0.1, 0.2, -0.3), 0.7))});
  Placement there;
  there.rotate(Vec3(1, 2, 3), 33, Vec3(4, 5, 6));
  there.translate(Vec3(0.1, 0.7, -3));
  const Solid elsewhere = placed(cut, there);
  EXPECT_EQ(elsewhere.exact_volume(), cut.exact_volume());
  Placement up;
  up.scale(0x1p10);
  EXPECT_EQ(placed(cut, up).exact_volume(), mpq_class(cut.exact_volume() * (1 << 30)));
  for (std::uint32_t i = 0; i < cut.point_count(); ++i) {
    const auto before = cut.exact_point(cut.triangles()[i % cut.triangle_count()][0]);
    const auto after =
        placed(cut, up).exact_point(placed(cut, up).triangles()[i % cut.triangle_count()][0]);
    EXPECT_EQ(after[0], before[0] * 1024);
  }
}

TEST(Placement, set_operations_go_on_from_there) {
  Placement placement;
  placement.rotate(Vec3::UnitZ(), 45);
  const std::vector solids = {Solid::from(test::box({-1, -1, -1}, {1, 1, 1})),
                              placed(Solid::from(test::box({-1, -1, -1}, {1, 1, 1})), placement)};
  // A regular octagon but for the error of the turn.
  EXPECT_NEAR(intersect(solids).volume(), 16 * (std::sqrt(2.0) - 1), 1e-12);
  EXPECT_TRUE(check(to_mesh(unite(solids)).mesh()).is_solid());
}

TEST(Placement, of_a_mesh_rounds_each_point) {
  TriMesh open = test::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  Placement placement;
  placement.translate(Vec3(0.5, 0, 0));
  PlacedMesh there = placed(open, placement);
  EXPECT_TRUE(there.is_exact);
  EXPECT_EQ(there.largest_move, 0);
  EXPECT_EQ(there.mesh.points[1].x(), 1.5);
  EXPECT_EQ(there.mesh.triangles, open.triangles);
  placement.translate(Vec3(0x1p60, 0, 0));
  there = placed(open, placement);
  EXPECT_FALSE(there.is_exact);
  EXPECT_EQ(there.largest_move, 1.5);
}

TEST(Placement, refuses_what_is_none_and_what_leaves_the_range) {
  const auto code = [](const auto& action) {
    Placement placement;
    try {
      action(placement);
    } catch (const Error& error) {
      return error.code();
    }
    return Errc::cancelled;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code([&](Placement& p) { p.translate(Vec3(0, nan, 0)); }), Errc::invalid_argument);
  EXPECT_EQ(code([&](Placement& p) { p.rotate(Vec3::Zero(), 90); }), Errc::invalid_argument);
  EXPECT_EQ(code([&](Placement& p) { p.rotate(Vec3::UnitX(), nan); }), Errc::invalid_argument);
  EXPECT_EQ(code([&](Placement& p) { p.scale(0); }), Errc::invalid_argument);
  EXPECT_EQ(code([&](Placement& p) { p.scale(-1); }), Errc::invalid_argument);
  const Solid box = Solid::from(test::box({1, 1, 1}, {2, 2, 2}));
  for (const double factor : {1e40, 1e300, 1e-61, 1e-300}) {
    EXPECT_EQ(code([&](Placement& p) {
                p.scale(factor);
                (void)placed(box, p);
              }),
              Errc::invalid_argument)
        << factor;
    TriMesh open = test::box({1, 1, 1}, {2, 2, 2});
    open.triangles.pop_back();
    EXPECT_EQ(code([&](Placement& p) {
                p.scale(factor);
                (void)placed(open, p);
              }),
              Errc::invalid_argument)
        << factor;
  }
}

TEST(Placement, of_a_mesh_puts_no_point_that_is_nowhere) {
  TriMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
  mesh.points[3].y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(test::message_of([&] { (void)placed(mesh, {}); }, Errc::invalid_argument),
            "a point is nowhere: the y coordinate inf, which must be 0 or from 1e-60 to 1e+39 in "
            "size");
}

TEST(Placement, puts_nothing_that_is_not_finite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    const Placement placement;
    for (const auto& put :
         std::vector<std::function<void()>>{[&] {
                                              (void)placement.place({1, bad, 0});
                                            },
                                            [&] {
                                              (void)placement.turn({0, 0, bad});
                                            },
                                            [&] { (void)placement.scaled(bad); }}) {
      EXPECT_EQ(test::message_of(put, Errc::invalid_argument), "a placement needs finite numbers");
    }
  }
}

}  // namespace
}  // namespace dupin
