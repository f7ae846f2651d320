#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "support/degeneracies.h"

namespace dupin {
namespace {

void expect(const char* what, const Solid& solid, const test::ExpectedSolid& expected) {
  SCOPED_TRACE(what);
  EXPECT_EQ(solid.exact_volume(), mpq_class(expected.volume));
  EXPECT_EQ(solid.components(), expected.components);
  EXPECT_EQ(solid.genus(), expected.genus);
  EXPECT_EQ(solid.contacts().size(), expected.contacts);
}

TEST(Degeneracy, of_every_kind_gives_the_expected_solids) {
  for (const test::Degeneracy& row : test::degeneracies()) {
    SCOPED_TRACE(row.name);
    const Solid united = unite(row.operands);
    expect("union", united, row.united);
    EXPECT_EQ(united.point_count(), row.points);
    EXPECT_EQ(united.triangle_count(), row.triangles);
    expect("intersection", intersect(row.operands), row.common);
    expect("difference", subtract(row.operands[0], std::span(row.operands).subspan(1)),
           row.difference);
  }
}

}  // namespace
}  // namespace dupin
