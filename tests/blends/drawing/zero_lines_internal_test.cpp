#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "drawing/polyline.h"
#include "drawing/zero_lines.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "support/source_folder.h"

namespace dupin::drawing {
namespace {

double distance(const Vec3& point, const std::vector<ZeroLine>& curves) {
  double least = std::numeric_limits<double>::infinity();
  for (const ZeroLine& curve : curves) {
    for (std::size_t i = 1; i < curve.size(); ++i) {
      least =
          std::min(least, distance_from_segment(point, curve[i - 1].position, curve[i].position));
    }
  }
  return least;
}

// The plane z = height(x, y) over the unit square.
template <class Gradient>
Sheet graph(const Gradient& gradient) {
  return {[=](double x, double y) {
            const auto [dx, dy] = gradient(x, y);
            return SheetPoint{{x, y, 0}, Vec3(-dx, -dy, 1).normalized()};
          },
          16, 16, false};
}

TEST(ZeroLines, cross_a_cell_by_the_way_its_middle_has) {
  // n.x = 0 on (x - 1/2)(y - 1/2) = c: a hyperbola, whose branches one cell has to keep apart.
  for (const double c : {-1e-4, 1e-4}) {
    Sheet sheet =
        graph([=](double x, double y) { return std::pair((x - 0.5) * (y - 0.5) - c, 0.); });
    sheet.rows = sheet.columns = 5;
    const auto curves = zero_lines(sheet, Vec3::UnitX(), 1e-5);
    EXPECT_EQ(curves.size(), 2);
    for (const ZeroLine& curve : curves) {
      for (const ZeroPoint& point : curve) {
        EXPECT_NEAR((point.position[0] - 0.5) * (point.position[1] - 0.5), c, 1e-11);
        EXPECT_EQ((point.position[0] - 0.5) * c > 0, (curve[0].position[1] - 0.5) > 0);
      }
    }
  }
}

TEST(ZeroLines, close) {
  const auto curves = zero_lines(
      graph([](double x, double y) { return std::pair(std::hypot(x - 0.4, y - 0.6) - 0.3, 0.); }),
      Vec3::UnitX(), 1e-6);
  ASSERT_EQ(curves.size(), 1);
  EXPECT_EQ(curves[0].front().position, curves[0].back().position);
  double length = 0;
  for (std::size_t i = 1; i < curves[0].size(); ++i) {
    length += (curves[0][i].position - curves[0][i - 1].position).norm();
  }
  EXPECT_NEAR(length, 0.6 * std::numbers::pi, 1e-4);
}

TEST(ZeroLines, are_none_where_nothing_but_rounding_turns) {
  const auto noise = [](double x, double y) {
    return std::pair(1e-16 * std::sin(1e5 * x) * std::cos(1e5 * y), 0.);
  };
  EXPECT_TRUE(zero_lines(graph(noise), Vec3::UnitX(), 1e-3).empty());
}

// Along many rows of every piece of the examples: wherever the normals turn from front to back
// around it, a line passes; and lines are where normals are at right angles to the view.
TEST(ZeroLines, are_all_on_the_pieces_of_the_examples) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  int compared = 0;
  for (const char* name : {"reducer", "skew-pipes", "oblique-nozzle", "oval-duct", "u-bend-cyclide",
                           "cone-to-pipe", "ringed-canal", "way-points", "jet-engine"}) {
    const ResolvedAssembly resolved =
        resolve(read_assembly(test::source_folder() / "examples" / (std::string(name) + ".json")));
    for (const ResolvedPart& part : resolved.parts) {
      const auto* chain = std::get_if<Chain>(&part.shape);
      for (const Sheet& sheet : chain == nullptr ? std::vector<Sheet>() : sheets_of(*chain)) {
        const double tolerance =
            1e-4 * (sheet.at(0, 0).position - sheet.at(0, 0.5).position).norm();
        const Vec3 w = Vec3(normal(random), normal(random), normal(random)).normalized();
        const auto curves = zero_lines(sheet, w, tolerance);
        for (const ZeroLine& curve : curves) {
          for (const ZeroPoint& point : curve) {
            EXPECT_NEAR(point.normal.dot(w), 0, 1e-9) << name << " " << part.name;
          }
        }
        for (int row = 1; row < 30; ++row) {
          constexpr int kSteps = 720;
          const double t = row / 30.;
          const auto slope = [&](double v) { return sheet.at(t, v).normal.dot(w); };
          for (int i = 0; i < kSteps; ++i) {
            double low = double(i) / kSteps, high = double(i + 1) / kSteps;
            if ((slope(low) < 0) != (slope(high) < 0)) {
              for (int k = 0; k < 40; ++k) {
                const double middle = (low + high) / 2;
                ((slope(middle) < 0) == (slope(low) < 0) ? low : high) = middle;
              }
              EXPECT_LT(distance(sheet.at(t, low).position, curves), 2 * tolerance)
                  << name << " " << part.name << " " << t;
              ++compared;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace dupin::drawing
