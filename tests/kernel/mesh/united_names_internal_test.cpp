#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/united_names.h"

namespace dupin::mesh {
namespace {

TEST(UnitedNames, are_there_once_in_the_order_of_their_first_places) {
  std::vector<std::string> names{"b", "a", "b", "c", "a"};
  std::vector<std::uint32_t> labels{0, 1, 2, 3, 4, 2};
  unite_names(names, labels);
  EXPECT_EQ(names, (std::vector<std::string>{"b", "a", "c"}));
  EXPECT_EQ(labels, (std::vector<std::uint32_t>{0, 1, 0, 2, 1, 0}));
  unite_names(names, labels);
  EXPECT_EQ(names, (std::vector<std::string>{"b", "a", "c"}));
  EXPECT_EQ(labels, (std::vector<std::uint32_t>{0, 1, 0, 2, 1, 0}));
}

TEST(UnitedNames, may_be_none) {
  std::vector<std::string> names;
  unite_names(names, {});
  EXPECT_TRUE(names.empty());
}

}  // namespace
}  // namespace dupin::mesh
