#include <span>

#include <gtest/gtest.h>

#include "kernel/nef_oracle.h"
#include "support/degeneracies.h"

namespace dupin {
namespace {

// The table's expectations, not our results.
TEST(DegeneracyNef, polyhedra_confirm_the_table_where_they_can) {
  constexpr std::size_t kFew = 8;  // operands that Nef polyhedra unite in a moment
  std::size_t confirmed = 0;
  for (const test::Degeneracy& row : test::degeneracies()) {
    if (row.operands.size() > kFew) {
      continue;
    }
    const std::pair<SetOperation, const test::ExpectedSolid*> table[] = {
        {SetOperation::unite, &row.united},
        {SetOperation::intersect, &row.common},
        {SetOperation::subtract, &row.difference}};
    for (const auto& [operation, expected] : table) {
      SCOPED_TRACE(row.name + ", operation " + std::to_string(static_cast<int>(operation)));
      const auto nef = test::by_nef(operation, std::span(row.operands).first(2));
      ASSERT_EQ(nef.has_value(), expected->contacts == 0);
      if (nef) {
        EXPECT_EQ(nef->exact_volume(), mpq_class(expected->volume));
        EXPECT_EQ(nef->components(), expected->components);
        EXPECT_EQ(nef->genus(), expected->genus);
        ++confirmed;
      }
    }
  }
  EXPECT_GT(confirmed, 50U);
}

}  // namespace
}  // namespace dupin
