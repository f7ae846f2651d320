#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/rounding.h"
#include "support/pipe_unions.h"
#include "support/shapes.h"
#include "support/tiled_boxes.h"

namespace dupin {
namespace {

using test::UnionKind;

struct Batch {
  const char* name;
  std::span<const UnionKind> kinds;
  std::vector<std::uint32_t> segments;
  std::uint32_t seeds;  // per kind and number of segments
};

std::ostream& operator<<(std::ostream& out, const Batch& batch) { return out << batch.name; }

/// What the rounded mesh promises, checked on its very numbers.
void expect_sound(const Solid& exact, Coordinates target) {
  const Rounded rounded = to_mesh(exact, target);
  const Report report = check(rounded.mesh());
  EXPECT_TRUE(report.is_solid());
  EXPECT_EQ(report.count(Defect::contact), 0) << "no two points are the same";
  EXPECT_EQ(report.components, exact.components());
  EXPECT_EQ(report.genus, exact.genus());
  // The boundary has moved by at most this; twice for the growth of the area on the way.
  EXPECT_NEAR(report.volume, exact.volume(),
              2 * report.area * rounded.report().largest_move + 1e-12 * exact.volume());
  if (target == Coordinates::binary32) {
    for (const Vec3& p : rounded.mesh().points) {
      ASSERT_EQ(p, p.cast<float>().cast<double>());
    }
  }
}

class RoundedUnions : public testing::TestWithParam<Batch> {};

TEST_P(RoundedUnions, are_solids_in_doubles_and_floats) {
  const Batch& batch = GetParam();
  for (const UnionKind kind : batch.kinds) {
    for (const std::uint32_t segments : batch.segments) {
      for (std::uint32_t seed = 0; seed < batch.seeds; ++seed) {
        std::ostringstream trace;
        trace << test::name(kind) << ", " << segments << " segments, seed " << seed;
        SCOPED_TRACE(trace.str());
        const Solid exact = unite(test::pipes(kind, segments, seed));
        expect_sound(exact, Coordinates::binary64);
        expect_sound(exact, Coordinates::binary32);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(some, RoundedUnions,
                         testing::Values(Batch{"design", test::kDesignKinds, {64}, 1},
                                         Batch{"plant", test::kPlantKinds, {64, 192}, 1}),
                         [](const auto& test) { return test.param.name; });

/// Of what touches itself along a step of floats on an axis: two blunt ends, a step apart, of five
/// faces each, and two wedges between them, whose common edge the step is.
class Pinched {
 public:
  explicit Pinched(std::uint32_t seed) : axis_(seed % 3), random_(seed) {
    end(-1, 0);
    end(1, kStep);
    const double first = in(0, 6), second = first + in(.3, 2.4) + in(.3, 1.2);
    wedge(first, first + .3);
    wedge(second, second + in(.3, 2.2));
  }
  [[nodiscard]] Solid solid() const { return unite(parts_); }

  static constexpr double kStep = 0x1p-4;

 private:
  double in(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  /// In floats, far away.
  [[nodiscard]] Vec3 placed(const Vec3& place) const {
    Vec3 result;
    for (std::uint32_t k = 0; k < 3; ++k) {
      result[(k + axis_) % 3] = std::round((place[k] + 1e6) / kStep) * kStep;
    }
    return result;
  }
  void add(TriMesh mesh) {
    if (check(mesh).volume < 0) {
      for (Triangle& triangle : mesh.triangles) {
        std::swap(triangle[0], triangle[1]);
      }
    }
    parts_.push_back(Solid::from(mesh));
  }
  void end(double toward, double apex) {
    const double start = in(0, 6);
    std::vector<Vec3> ring;
    for (int i = 0; i < 5; ++i) {
      const double angle = start + 2 * std::numbers::pi * i / 5;
      ring.push_back(
          placed(Vec3(8 * std::cos(angle), 8 * std::sin(angle), apex + toward * in(.1, 9))));
    }
    for (std::size_t i = 0; i < 5; ++i) {
      add({{ring[i], ring[(i + 1) % 5], placed(Vec3(0, 0, apex)), placed(Vec3(0, 0, 12 * toward))},
           {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}});
    }
  }
  void wedge(double from, double to) {
    TriMesh mesh{
        {},
        {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
    for (const double z : {-4, 4}) {
      mesh.points.push_back(placed(Vec3(0, 0, z)));
      for (const double angle : {from, to}) {
        mesh.points.push_back(placed(Vec3(6 * std::cos(angle), 6 * std::sin(angle), z)));
      }
    }
    add(std::move(mesh));
  }

  std::uint32_t axis_;
  std::mt19937 random_;
  std::vector<Solid> parts_;
};

TEST(PinchedUnions, that_touch_themselves_along_a_step_do_so_in_a_point) {
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    const Solid exact = Pinched(seed).solid();
    ASSERT_FALSE(exact.contacts().empty());
    const Rounded rounded = to_mesh(exact, Coordinates::binary32);
    const Report report = check(rounded.mesh());
    EXPECT_TRUE(report.is_solid());
    EXPECT_LT(rounded.report().largest_move, 16 * Pinched::kStep);
    EXPECT_NEAR(report.volume, exact.volume(), report.area * Pinched::kStep);
  }
}

// Nearly flat surfaces of several operands: an edge that is flipped past a notch would leave a fin
// there without thickness, far outside of all.
TEST(RoundedUnionsOfTurnedBoxes, stay_where_they_are) {
  std::mt19937 random(0);
  for (int scene = 0; scene < 150; ++scene) {
    std::vector<Solid> solids;
    Boxes boxes;
    for (int i = 0; i < 2 + scene % 3; ++i) {
      const TriMesh mesh = test::turned_tiled_box(random);
      Eigen::AlignedBox3d box;
      for (const Vec3& point : mesh.points) {
        box.extend(point);
      }
      boxes.push_back(box);
      solids.push_back(Solid::from(mesh));
    }
    const Solid exact = unite(solids);
    for (const Coordinates target : {Coordinates::binary64, Coordinates::binary32}) {
      const Rounded rounded = to_mesh(exact, target);
      const double move = 1.001 * rounded.report().largest_move + 1e-15;
      Boxes wide = boxes;
      for (Eigen::AlignedBox3d& box : wide) {
        box = Eigen::AlignedBox3d(box.min().array() - move, box.max().array() + move);
      }
      EXPECT_TRUE(lies_in(rounded, wide)) << scene << ", " << move;
      EXPECT_TRUE(check(rounded.mesh()).is_solid());
    }
  }
}

// Ends that lie in one plane no longer, by some 1e-16, once they are turned. Among doubles there is
// nothing to fill between them: what fills it had more needles than there were.
TEST(RoundedUnions, of_turned_flush_parts_have_no_more_triangles_than_exact_ones) {
  const Eigen::AngleAxisd turn(0.8, Vec3(1, std::sqrt(2), std::sqrt(3)).normalized());
  std::vector<Solid> stack;
  for (int i = 0; i < 16; ++i) {
    TriMesh part = test::tube(1, i, i + 1, 48);
    const Eigen::AngleAxisd about(0.37 * i, Vec3::UnitZ());
    for (Vec3& point : part.points) {
      point = turn * (about * point) + Vec3(3.3, 2.1, 1.7);
    }
    stack.push_back(Solid::from(part));
  }
  const Solid exact = unite(stack);
  const Rounded rounded = to_mesh(exact);
  EXPECT_GT(exact.triangle_count(), 8000U) << "they cross each other all over";
  EXPECT_LE(rounded.mesh().triangles.size(), exact.triangle_count());
  EXPECT_LT(rounded.report().largest_move, 1e-13);
  const Report report = check(rounded.mesh());
  EXPECT_TRUE(report.is_solid());
  EXPECT_EQ(report.components, 1U);
  EXPECT_NEAR(report.volume, exact.volume(), 1e-12);
}

}  // namespace
}  // namespace dupin
