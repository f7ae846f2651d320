#include <array>
#include <string>

#include <gtest/gtest.h>

#include "text/little_endian.h"

namespace dupin::text {
namespace {

TEST(LittleEndian, numbers_have_their_lowest_byte_first) {
  std::string bytes = "x";
  store(bytes, std::uint32_t{0x04030201});
  store(bytes, 1.0F);
  store(bytes, std::array<std::uint16_t, 2>{0x0605, 0x0807});
  EXPECT_EQ(bytes, std::string("x\1\2\3\4\0\0\x80\x3f\5\6\7\10", 13));
  EXPECT_EQ(load<std::uint32_t>(bytes, 1), 0x04030201U);
  EXPECT_EQ(load<std::uint16_t>(bytes, 2), 0x0302U) << "at any position";
  EXPECT_EQ(load<float>(bytes, 5), 1.0F);
  EXPECT_EQ((load<std::array<std::uint16_t, 2>>(bytes, 9)[1]), 0x0807);
}

}  // namespace
}  // namespace dupin::text
