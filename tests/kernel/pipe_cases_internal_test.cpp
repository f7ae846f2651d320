#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/solid.h"
#include "kernel/exact_validity.h"
#include "support/pipe_cases.h"
#include "support/shapes.h"

namespace dupin {
namespace {

struct Row {
  const char* name;
  double volume;  // by Nef polyhedra or corefinement, where one of them could
  std::size_t components, contacts;
};

std::vector<Solid> operands(std::string_view name) {
  std::vector<Solid> solids;
  for (const TriMesh& mesh : test::pipe_case(name)) {
    solids.push_back(Solid::from(mesh));
  }
  return solids;
}

class PipeCase : public testing::TestWithParam<Row> {};

TEST_P(PipeCase, unites_to_a_valid_solid_of_the_known_volume) {
  const Row& row = GetParam();
  const Solid united = unite(operands(row.name));
  EXPECT_NEAR(united.volume(), row.volume, 1e-11 * row.volume);
  EXPECT_EQ(united.components(), row.components);
  EXPECT_EQ(united.contacts().size(), row.contacts);
  EXPECT_TRUE(detail::is_closed_manifold(united.exact()));
  EXPECT_EQ(detail::self_intersections(united.exact()), 0U);
}

INSTANTIATE_TEST_SUITE_P(
    Design, PipeCase,
    testing::Values(Row{"tee_10k", 45.3536257847, 1, 0}, Row{"tee_10k_rot", 45.3536257847, 1, 0},
                    Row{"header_10", 33.9090906937, 1, 0}, Row{"blend_1", 3.66059546586, 1, 0},
                    Row{"coax", 21.9558394338, 1, 0}, Row{"coax_rot", 21.9558394338, 1, 0},
                    Row{"coax_butt", 21.9558394338, 1, 0}, Row{"same", 12.5461939622, 1, 0},
                    Row{"tangent_par", 19.6034280659, 2, 3},
                    Row{"tangent_perp", 19.6034280659, 2, 1},
                    Row{"inner_tangent", 14.3105024881, 1, 0}, Row{"flushcap", 16.2109761594, 1, 0},
                    Row{"steinmetz", 32.3538526669, 1, 0},
                    Row{"steinmetz_rot", 32.3538526669, 1, 0}),
    [](const auto& row) { return std::string(row.param.name); });

// A shared ring closed by two different fans, not exactly plane: slits a few ulp thick remain.
TEST(PipeCases, ends_that_differ_by_rounding_leave_a_valid_solid) {
  const std::vector<Solid> parts = operands("blend_1_fan");
  const Solid united = unite(parts);
  EXPECT_NEAR(united.volume(), 3.66059546586, 1e-11);
  EXPECT_TRUE(detail::is_closed_manifold(united.exact()));
  EXPECT_EQ(detail::self_intersections(united.exact()), 0U);
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

TEST(PipeCases, do_not_depend_on_the_number_of_threads) {
  const std::vector<Solid> parts = operands("rack_eq_small");
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return unite(parts);
  };
  const Solid one = with_threads(1);
  EXPECT_TRUE(detail::is_closed_manifold(one.exact()));
  for (const std::size_t threads : {2U, 8U}) {
    const Solid other = with_threads(threads);
    EXPECT_EQ(one.triangles(), other.triangles());
    EXPECT_EQ(one.nearest_points(), other.nearest_points());
    EXPECT_EQ(one.sources(), other.sources());
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
  EXPECT_TRUE(detail::is_closed_manifold(stepwise.exact()));
  EXPECT_EQ(stepwise.components(), 1U);
  EXPECT_EQ(stepwise.exact_volume(), unite(pipes).exact_volume());
}

}  // namespace
}  // namespace dupin
