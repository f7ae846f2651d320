// The arrangements of pipes that are easy to get wrong, rounded.
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "support/pipe_cases.h"

namespace dupin {
namespace {

class RoundedPipeCase : public testing::TestWithParam<std::string> {};

TEST_P(RoundedPipeCase, is_a_solid_in_doubles_and_floats) {
  std::vector<Solid> operands;
  for (const TriMesh& mesh : test::pipe_case(GetParam())) {
    operands.push_back(Solid::from(mesh));
  }
  const Solid exact = unite(operands);
  for (const Coordinates target : {Coordinates::binary64, Coordinates::binary32}) {
    SCOPED_TRACE(target == Coordinates::binary64 ? "binary64" : "binary32");
    const Rounded rounded = to_mesh(exact, target);
    const Report report = check(rounded.mesh());
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(report.components, exact.components());
    EXPECT_EQ(report.genus, exact.genus());
    EXPECT_NEAR(report.volume, exact.volume(),
                2 * report.area * rounded.report().largest_move + 1e-12 * exact.volume());
  }
}

// Neighbours end in the same ring of points, flat only to within rounding, and close it by
// different triangles: slits a few units in the last place thick run through the whole pipe.
class RoundedSlitCase : public testing::TestWithParam<std::string> {};

TEST_P(RoundedSlitCase, is_one_pipe_in_doubles_and_floats) {
  std::vector<Solid> operands;
  for (const TriMesh& mesh : test::pipe_case(GetParam())) {
    operands.push_back(Solid::from(mesh));
  }
  const Solid exact = unite(operands);
  ASSERT_FALSE(exact.contacts().empty());
  for (const Coordinates target : {Coordinates::binary64, Coordinates::binary32}) {
    SCOPED_TRACE(target == Coordinates::binary64 ? "binary64" : "binary32");
    const Rounded rounded = to_mesh(exact, target);
    EXPECT_GT(rounded.report().filled_places.size(), 0U);
    EXPECT_LE(rounded.report().slit_width, 0x1p-40);
    EXPECT_TRUE(rounded.contacts().empty());
    const Report report = check(rounded.mesh());
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(report.count(Defect::contact), 0);
    EXPECT_EQ(report.shells.size(), 1);
    EXPECT_EQ(report.genus, 0);
    EXPECT_NEAR(report.volume, exact.volume(),
                2 * report.area * rounded.report().largest_move + 1e-12 * exact.volume());
  }
}

#ifdef DUPIN_LARGE_CASES
INSTANTIATE_TEST_SUITE_P(Large, RoundedSlitCase,
                         testing::Values("chain_100_fan", "chain_100_fan_rot"),
                         [](const auto& name) { return name.param; });
INSTANTIATE_TEST_SUITE_P(Large, RoundedPipeCase,
                         testing::Values("tee_100k", "tee_100k_rot", "header_100_rot",
                                         "chain_100_rot", "rack_fine_rot"),
                         [](const auto& name) { return name.param; });
#else
INSTANTIATE_TEST_SUITE_P(Small, RoundedSlitCase,
                         testing::Values("blend_1_fan", "blend_1_fan_rot", "chain_10_fan",
                                         "chain_10_fan_rot"),
                         [](const auto& name) { return name.param; });
INSTANTIATE_TEST_SUITE_P(Small, RoundedPipeCase,
                         testing::Values("tee_10k", "tee_10k_rot", "header_10", "header_10_rot",
                                         "rack_small", "rack_eq_small", "blend_1", "blend_1_rot",
                                         "coax", "coax_rot", "coax_butt", "coax_butt_rot", "same",
                                         "same_rot", "tangent_par", "tangent_perp", "inner_tangent",
                                         "inner_tangent_rot", "flushcap", "flushcap_rot",
                                         "steinmetz", "steinmetz_rot"),
                         [](const auto& name) { return name.param; });
#endif

}  // namespace
}  // namespace dupin
