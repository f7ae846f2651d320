// The arrangements of pipes that are easy to get wrong, rounded.
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
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
    const Report report = check(rounded.mesh);
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(report.components, exact.components());
    EXPECT_EQ(report.genus, exact.genus());
    EXPECT_NEAR(report.volume, exact.volume(),
                2 * report.area * rounded.report.largest_move + 1e-12 * exact.volume());
  }
}

#ifdef DUPIN_LARGE_CASES
// A slit a few ulp thick runs through the whole pipe, and no edit of few triangles closes it. What
// may not happen is that the search has no end, or that a file is written that is no solid.
TEST(RoundedSlit, is_refused_with_its_place) {
  std::vector<Solid> operands;
  for (const TriMesh& mesh : test::pipe_case("blend_1_fan")) {
    operands.push_back(Solid::from(mesh));
  }
  try {
    const Rounded rounded = to_mesh(unite(operands), Coordinates::binary32);
    FAIL() << "the slit was closed: " << rounded.report.removed_triangles;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::unroundable);
    EXPECT_NE(error.where(), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Large, RoundedPipeCase,
                         testing::Values("tee_100k", "tee_100k_rot", "header_100_rot",
                                         "chain_100_rot", "rack_fine_rot"),
                         [](const auto& name) { return name.param; });
#else
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
