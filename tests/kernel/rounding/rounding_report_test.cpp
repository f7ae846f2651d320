#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "kernel/same_report.h"
#include "support/pipe_cases.h"
#include "support/shapes.h"

namespace dupin {
namespace {

Solid united(const std::vector<TriMesh>& meshes) {
  std::vector<Solid> solids;
  for (const TriMesh& mesh : meshes) {
    solids.push_back(Solid::from(mesh));
  }
  return unite(solids);
}

void expect_as_checked(const Solid& solid) {
  for (const Coordinates coordinates : {Coordinates::binary64, Coordinates::binary32}) {
    const Rounded rounded = to_mesh(solid, coordinates);
    test::expect_same_report(check(rounded), check(rounded.mesh()));
  }
}

TEST(RoundingReportOfSolids, is_what_check_says) {
  for (const char* name : {"star_6_rot", "coaxial_5_rot", "rack_eq_small", "header_10", "row_20"}) {
    SCOPED_TRACE(name);
    expect_as_checked(united(test::pipe_case(name)));
  }
}

TEST(RoundingReportOfSolids, tells_contacts) {
  const Solid solid = united({test::box({0, 0, 0}, {1, 1, 1}), test::box({1, 1, 0}, {2, 2, 1})});
  ASSERT_EQ(solid.contacts().size(), 1);
  EXPECT_EQ(check(to_mesh(solid)).count(Defect::contact), 1);
  expect_as_checked(solid);
}

}  // namespace
}  // namespace dupin
