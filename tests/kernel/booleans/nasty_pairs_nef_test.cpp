#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "kernel/nef_oracle.h"
#include "support/nasty_shapes.h"

namespace dupin {
namespace {

// That the volumes of all four operations add up, nasty_pairs_test.cpp says: one of them is enough.
TEST(NastyPairsNef, have_the_same_volume_in_common) {
  std::vector<std::pair<std::string, Solid>> solids;
  for (const test::NastyShape& shape : test::nasty_shapes()) {
    if (!shape.refused) {
      solids.emplace_back(shape.name, Solid::from(shape.mesh));
    }
  }
  std::size_t confirmed = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t k = i + 1; k < solids.size(); ++k) {
      SCOPED_TRACE(solids[i].first + " and " + solids[k].first);
      const std::vector operands{solids[i].second, solids[k].second};
      if (const auto nef = test::by_nef(SetOperation::intersect, operands)) {
        EXPECT_EQ(nef->exact_volume(), intersect(operands).exact_volume());
        ++confirmed;
      }
    }
  }
  EXPECT_GT(confirmed, 200U);
}

}  // namespace
}  // namespace dupin
