#include "dupin/kernel/renamed.h"

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "support/shapes.h"

namespace dupin {
namespace {

TEST(Renamed, labels_that_get_one_name_become_one) {
  const Solid both =
      unite(std::vector{Solid::from(test::labelled(test::box({0, 0, 0}, {1, 1, 1}), "a")),
                        Solid::from(test::labelled(test::box({0.5, 0, 0}, {2, 1, 1}), "b"))});
  const Solid renamed = dupin::renamed(both, {{"a", "x"}, {"b", "x"}, {"c", "y"}});
  EXPECT_EQ(renamed.names(), std::vector<std::string>{"x"});
  EXPECT_EQ(renamed.exact_volume(), both.exact_volume());
  EXPECT_EQ(renamed.labels(), std::vector<std::uint32_t>(both.triangle_count(), 0));
  const Solid one = dupin::renamed(both, {{"b", "c"}});
  EXPECT_EQ(one.names(), (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ(one.labels(), both.labels());
}

}  // namespace
}  // namespace dupin
