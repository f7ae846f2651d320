// The tables B1 to B9 of the mathematics, computed with 40 digits, to 1e-12 relative.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "blends/canal/canal_tables.h"
#include "blends/canal/residuals.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/blends/nurbs.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using test::canal_tables;
using test::CanalRow;
using test::CanalTable;
using test::kPi;

void expect_close(const Vec3& found, const Vec3& expected) {
  EXPECT_LT((found - expected).norm(), 1e-12 * std::max(1.0, expected.norm()))
      << found.transpose() << " is not " << expected.transpose();
}

void expect_close(double found, double expected) {
  EXPECT_NEAR(found, expected, 1e-12 * std::max(1.0, std::abs(expected)));
}

TEST(RationalFilletOracle, FeetCirclesAndMiddlePoints) {
  for (const CanalTable& table : canal_tables()) {
    const CanalFillet fillet = rational_fillet(table.quadrics, table.radii, table.side);
    for (const CanalRow& row : table.rows) {
      SCOPED_TRACE(table.name + " at " + std::to_string(row.parameter));
      const MovingBall at = ball(fillet, row.parameter);
      const ContactArc arc = contact_arc(fillet.quadrics, at);
      expect_close(at.center, row.center);
      expect_close(at.radius, row.radius);
      expect_close(arc.feet[0], row.first_foot);
      expect_close(arc.feet[1], row.second_foot);
      expect_close(arc.center, row.circle_center);
      expect_close(arc.radius, row.circle_radius);
      expect_close(arc.weight, row.weight);
      expect_close(arc.middle, row.middle);
    }
  }
}

TEST(RationalFilletOracle, RangesAndResiduals) {
  for (const CanalTable& table : canal_tables()) {
    SCOPED_TRACE(table.name);
    const CanalFillet fillet = rational_fillet(table.quadrics, table.radii, table.side);
    EXPECT_LT(test::residual(fillet), 1e-14);
    for (int k = 0; k < 1000; ++k) {
      const double radius = ball(fillet, 2 * kPi * k / 1000).radius;
      EXPECT_GT(radius, table.least_radius - 2e-3 * table.largest_radius);
      EXPECT_LT(radius, table.largest_radius + 2e-3 * table.largest_radius);
    }
  }
}

TEST(RationalFilletOracle, LeastRegularities) {
  for (const CanalTable& table : canal_tables()) {
    SCOPED_TRACE(table.name);
    const CanalFillet fillet = rational_fillet(table.quadrics, table.radii, table.side);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 96; ++k) {
      const MovingBall at = ball(fillet, 2 * kPi * k / 96);
      least = std::min(least, least_regularity(at, contact_arc(fillet.quadrics, at)));
    }
    // The table's samples are fewer on each arc.
    EXPECT_LT(least, table.regularity + 1e-9);
    EXPECT_GT(least, table.regularity - 3e-3);
  }
}

/// The fillet of B1 with constant g, and what the table says of it.
std::array<double, 4> radii_of_constant_size(double g) {
  const double at_0 = (8 * g - 2) / (1 - 2 * g);
  const double at_quarter = (8 * g - (1 + g * g) * 2) / ((1 - g) * (1 - g));
  return {at_0, at_quarter, at_0, at_quarter};
}

TEST(RationalFilletOracle, RegularitiesOfConstantSize) {
  const CanalTable table = canal_tables()[0];
  const auto least = [&](double g) {
    const CanalFillet fillet = rational_fillet(table.quadrics, radii_of_constant_size(g), 1);
    EXPECT_NEAR(std::get<RationalCrossing>(fillet.motion).size[0], g, 1e-15);
    const MovingBall at = ball(fillet, 0);
    return least_regularity(at, contact_arc(fillet.quadrics, at));
  };
  // The table's are of 9 samples on the arc.
  EXPECT_NEAR(least(.275), .7696142486 - 3e-3, 3e-3);
  EXPECT_NEAR(least(.3), .5536734392 - 3e-3, 3e-3);
  EXPECT_NEAR(least(.35), .1197966073 - 3e-3, 3e-3);
  for (const double g : {.4, .45}) {
    try {
      (void)rational_fillet(table.quadrics, radii_of_constant_size(g), 1);
      ADD_FAILURE() << "g = " << g << " folds";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::irregular_surface);
      EXPECT_NE(error.message().find("folds"), std::string::npos) << error.message();
    }
  }
}

Vec3 evaluated(const CanalNet& net, double q, double t) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  const std::array<double, 3> across{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
  for (std::size_t j = 0; j < 3; ++j) {
    std::array<Eigen::Vector4d, 11> row;
    for (std::size_t i = 0; i < 11; ++i) {
      row[i] = Eigen::Vector4d(net[j][i].data());
    }
    for (std::size_t n = 10; n > 0; --n) {
      for (std::size_t i = 0; i < n; ++i) {
        row[i] = (1 - q) * row[i] + q * row[i + 1];
      }
    }
    sum += across[j] * row[0];
  }
  return sum.head<3>() / sum[3];
}

TEST(ExactNets, AreTheFilletsArcs) {
  std::mt19937 random(31);
  const test::Placement place = test::random_placement(random);
  std::array<Ring, 2> quadrics{place(canal_tables()[0].quadrics[0]),
                               place(canal_tables()[0].quadrics[1])};
  for (const bool swapped : {false, true}) {
    for (const int side : {1, -1}) {
      const CanalFillet fillet = rational_fillet(quadrics, radii_of_constant_size(.3), side);
      const auto nets = exact_nets(fillet);
      ASSERT_TRUE(nets) << swapped << side;
      for (int quarter = 0; quarter < 4; ++quarter) {
        for (const double share : {0.0, .2, .5, .9, 1.0}) {
          const double local = share * kPi / 2;  // from the end where the sine is 0
          const double q = quarter % 2 == 0 ? std::tan(local / 2) : 1 - std::tan(local / 2);
          const double parameter =
              quarter % 2 == 0 ? (quarter - 2) * kPi / 2 + local : (quarter - 1) * kPi / 2 - local;
          const MovingBall at = ball(fillet, parameter);
          const ContactArc arc = contact_arc(quadrics, at);
          expect_close(evaluated(nets->at(quarter), q, 0), arc.feet[0]);
          expect_close(evaluated(nets->at(quarter), q, 1), arc.feet[1]);
          const Vec3 middle = evaluated(nets->at(quarter), q, .4);
          EXPECT_NEAR((middle - at.center).norm(), at.radius, 1e-13);
          EXPECT_NEAR((middle - arc.center).dot(at.velocity.normalized()), 0, 1e-13);
        }
      }
    }
    std::swap(quadrics[0], quadrics[1]);
  }
}

TEST(ExactNets, AreThereForConstantSizeAtRightAnglesOnly) {
  const auto tables = canal_tables();
  EXPECT_TRUE(exact_nets(rational_fillet(tables[0].quadrics, tables[0].radii, 1)));
  EXPECT_FALSE(exact_nets(rational_fillet(tables[0].quadrics, {1, .4, 1, .4}, 1)));
  for (std::size_t i = 1; i < tables.size(); ++i) {
    EXPECT_FALSE(exact_nets(rational_fillet(tables[i].quadrics, tables[i].radii, tables[i].side)))
        << tables[i].name;
  }
  EXPECT_FALSE(exact_nets(rolling_ball_fillets(tables[0].quadrics, .5)[0]));
}

}  // namespace
}  // namespace dupin
