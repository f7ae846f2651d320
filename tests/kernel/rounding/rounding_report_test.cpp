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

// A tetrahedron at the corner of a box, smaller than the numbers tell.
TEST(RoundingReportOfSolids, tells_no_contact_of_what_rounding_has_removed) {
  const Solid solid =
      united({test::box({0, 0, 0}, {1, 1, 1}), test::tetrahedron({1, 1, 1}, 0x1p-30),
              test::box({-1, -1, 0}, {0, 0, 0.1})});
  ASSERT_EQ(solid.contacts().size(), 2);
  EXPECT_EQ(to_mesh(solid).contacts().size(), 2);
  const Rounded rounded = to_mesh(solid, Coordinates::binary32);
  EXPECT_EQ(rounded.report().removed_shells, 1);
  ASSERT_EQ(rounded.contacts().size(), 1);
  EXPECT_EQ(check(rounded).count(Defect::contact), 1);
  EXPECT_EQ(rounded.contacts()[0].kind, Contact::Kind::edge);
  EXPECT_EQ(rounded.contacts()[0].to, Vec3(0, 0, 0.1F));
}

TEST(RoundingReportOfSolids, tells_contacts_in_their_own_place) {
  const Vec3 far(0x1p30, 0x1p30, 0x1p30);
  const Solid solid = united({test::moved(test::box({0, 0, 0}, {1, 1, 1}), far),
                              test::moved(test::box({1, 1, 0}, {2, 2, 1}), far)});
  const Rounded rounded =
      to_mesh(solid, Coordinates::binary32, {.origin = {Origin::Choice::automatic}});
  ASSERT_EQ(rounded.contacts().size(), 1);
  EXPECT_EQ(rounded.contacts()[0].from, far + Vec3(1, 1, 0));
  EXPECT_EQ(rounded.contacts()[0].to, far + Vec3(1, 1, 1));
}

}  // namespace
}  // namespace dupin
