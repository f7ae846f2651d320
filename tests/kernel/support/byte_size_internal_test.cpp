#include <gtest/gtest.h>

#include "support/byte_size.h"

namespace dupin::support {
namespace {

TEST(ByteSize, is_in_the_unit_that_suits_it_and_rounded_up) {
  EXPECT_EQ(byte_size(1), "1 kB");
  EXPECT_EQ(byte_size(850'629), "860 kB");
  EXPECT_EQ(byte_size(999'999), "1 MB");
  EXPECT_EQ(byte_size(4e9), "4 GB");
  EXPECT_EQ(byte_size(1.21e13), "13 TB");
}

}  // namespace
}  // namespace dupin::support
