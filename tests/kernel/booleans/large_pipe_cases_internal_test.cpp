#include <cmath>
#include <numbers>

#include "kernel/booleans/pipe_case_checks_internal.h"

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
    testing::Values(Row{"tee_n512", 45.3704349115, 1, 0}, Row{"tee_n2048", 45.3714856204, 1, 0},
                    Row{"tee_10k", 45.3536257847, 1, 0}, Row{"tee_10k_rot", 45.3536257847, 1, 0},
                    Row{"tee_100k", 45.3704349115, 1, 0}, Row{"tee_100k_rot", 45.3704349115, 1, 0},
                    Row{"header_10", 33.9090906937, 1, 0},
                    Row{"header_10_rot", 33.9090906937, 1, 0},
                    Row{"steinmetz_rot", 32.3538526669, 1, 0}),
    [](const auto& row) { return std::string(row.param.name); });

// Racks of 20 by 20 pipes of length 40 have these volumes by corefinement; all crossings are alike,
// so racks of 4 by 4 pipes of length 8 follow.
TEST(PipeCases, racks_unite_to_the_volume_that_larger_ones_foretell) {
  const double area = 32 * 0.4 * 0.4 * std::sin(2 * std::numbers::pi / 64);
  const struct {
    const char* name;
    double large;
  } table[] = {{"rack_small", 766.619264157},
               {"rack_small_rot", 766.619264157},
               {"rack_eq_small", 666.751802906},
               {"rack_eq_small_rot", 666.751802906}};
  for (const auto& [name, large] : table) {
    SCOPED_TRACE(name);
    const double crossing = (40 * 40 * area - large) / 400;
    const Solid united = unite(operands(name));
    EXPECT_NEAR(united.volume(), 8 * 8 * area - 16 * crossing, 1e-9);
    EXPECT_EQ(united.components(), 1U);
    EXPECT_EQ(united.genus(), 9) << "one hole between each four crossings";
    expect_valid(united);
    expect_valid_when_rounded(united);
  }
}

// Shared rings closed by two different fans leave slits a few ulp thick, and contacts at their
// ends.
TEST(PipeCases, chains_unite_to_the_volume_of_their_parts) {
  for (const char* name : {"chain_10", "chain_10_rot", "chain_10_fan"}) {
    SCOPED_TRACE(name);
    const std::vector<Solid> parts = operands(name);
    mpq_class sum = 0;
    for (const Solid& part : parts) {
      sum += part.exact_volume();
    }
    const Solid united = unite(parts);
    EXPECT_NEAR(united.volume(), sum.get_d(), 1e-12 * sum.get_d());
    EXPECT_EQ(united.components(), 1U);
    expect_valid(united);
    if (united.contacts().empty()) {
      expect_valid_when_rounded(united);
    }
  }
}

}  // namespace
}  // namespace dupin
