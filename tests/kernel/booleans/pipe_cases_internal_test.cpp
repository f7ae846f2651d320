#include <algorithm>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "dupin/kernel/boolean.h"
#include "kernel/booleans/pipe_case_checks_internal.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::expect_valid;
using test::expect_valid_when_rounded;
using test::operands;
using test::Row;

class PipeCase : public testing::TestWithParam<test::Row> {};

TEST_P(PipeCase, unites_to_a_valid_solid_of_the_known_volume) {
  test::expect_known_union(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Design, PipeCase,
    testing::Values(Row{"tee_n32", 45.0852117268, 1, 0}, Row{"tee_n128", 45.3536257847, 1, 0},
                    Row{"blend_1", 3.66059546586, 1, 0}, Row{"blend_1_rot", 3.66059546586, 1, 0},
                    Row{"coax", 21.9558394338, 1, 0}, Row{"coax_rot", 21.9558394338, 1, 0},
                    Row{"coax_phase", 21.958674724, 1, 0},
                    Row{"coax_turned_rot", 21.9586431355, 1, 0},
                    Row{"coax_butt", 21.9558394338, 1, 0}, Row{"same", 12.5461939622, 1, 0},
                    Row{"tangent_par", 19.6034280659, 2, 3},
                    Row{"tangent_perp", 19.6034280659, 2, 1},
                    Row{"inner_tangent", 14.3105024881, 1, 0}, Row{"flushcap", 16.2109761594, 1, 0},
                    Row{"steinmetz", 32.3538526669, 1, 0}),
    [](const auto& row) { return std::string(row.param.name); });

// Turned by an irrational angle, rounding decides what is left of a tangency; the volume does not
// depend on it.
TEST(PipeCases, tangents_that_were_turned_unite_to_valid_solids) {
  for (const char* name : {"tangent_par_rot", "tangent_perp_rot", "inner_tangent_rot"}) {
    SCOPED_TRACE(name);
    const std::vector<Solid> parts = operands(name);
    const Solid united = unite(parts);
    EXPECT_EQ(united.exact_volume() + intersect(parts).exact_volume(),
              parts[0].exact_volume() + parts[1].exact_volume());
    EXPECT_NEAR(united.volume(),
                std::string_view(name) == "inner_tangent_rot" ? 14.3105024881 : 19.6034280659,
                1e-10);
    expect_valid(united);
    expect_valid_when_rounded(united);
  }
}

// A shared ring closed by two different fans, not exactly plane: slits a few ulp thick remain.
TEST(PipeCases, ends_that_differ_by_rounding_leave_a_valid_solid) {
  const std::vector<Solid> parts = operands("blend_1_fan");
  const Solid united = unite(parts);
  EXPECT_NEAR(united.volume(), 3.66059546586, 1e-11);
  EXPECT_TRUE(test::is_closed_manifold(united.exact()));
  EXPECT_EQ(test::self_intersections(united.exact()), 0U);
  mpq_class sum = 0;
  for (const Solid& part : parts) {
    sum += part.exact_volume();
  }
  mpq_class overlaps = 0;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    overlaps += intersect(std::vector{parts[i], parts[i + 1]}).exact_volume();
  }
  EXPECT_EQ(united.exact_volume(), sum - overlaps);
}

// Many crossings; many untouched triangles; many welded points.
TEST(PipeCases, do_not_depend_on_the_number_of_threads) {
  for (const char* name : {"rack_eq_small", "tee_10k_rot", "chain_10"}) {
    SCOPED_TRACE(name);
    const std::vector<Solid> parts = operands(name);
    const auto with_threads = [&](std::size_t threads) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      return unite(parts);
    };
    const Solid one = with_threads(1);
    EXPECT_TRUE(test::is_closed_manifold(one.exact()));
    for (const std::size_t threads : {2U, 8U}) {
      const Solid other = with_threads(threads);
      EXPECT_EQ(one.triangles(), other.triangles());
      EXPECT_EQ(one.nearest_points(), other.nearest_points());
      EXPECT_EQ(one.sources(), other.sources());
    }
  }
}

// Coordinates, triangles, order of both: all but the numbering of the operands in the sources.
TEST(PipeCases, do_not_depend_on_the_order_of_operands) {
  for (const char* name : {"rack_eq_small", "blend_1_fan", "coax_rot", "tangent_par"}) {
    SCOPED_TRACE(name);
    std::vector<Solid> parts = operands(name);
    const Solid first = unite(parts);
    for (int i = 0; i < 3; ++i) {
      std::rotate(parts.begin(), parts.begin() + 1, parts.end());
      std::swap(parts.front(), parts[parts.size() / 2]);
      const Solid other = unite(parts);
      EXPECT_EQ(first.triangles(), other.triangles());
      EXPECT_EQ(first.nearest_points(), other.nearest_points());
      EXPECT_EQ(first.contacts().size(), other.contacts().size());
    }
  }
}

// Twenty pipes through one point, one after the other, in directions that have nothing in common.
TEST(PipeCases, unions_of_unions_stay_exact_and_small_to_depth_twenty) {
  std::vector<Solid> pipes;
  for (int i = 0; i < 20; ++i) {
    TriMesh mesh = test::tube(1, -3, 3, 6);
    const Eigen::AngleAxisd turn(0.37 * i + 0.1, Vec3(1, 0.3 * i, 0.7).normalized());
    for (Vec3& point : mesh.points) {
      point = turn * point;
    }
    pipes.push_back(Solid::from(mesh));
  }
  Solid stepwise = pipes[0];
  for (std::size_t i = 1; i < pipes.size(); ++i) {
    stepwise = unite(std::vector{stepwise, pipes[i]});
  }
  EXPECT_TRUE(test::is_closed_manifold(stepwise.exact()));
  EXPECT_EQ(stepwise.components(), 1U);
  EXPECT_EQ(stepwise.exact_volume(), unite(pipes).exact_volume());
}

}  // namespace
}  // namespace dupin
