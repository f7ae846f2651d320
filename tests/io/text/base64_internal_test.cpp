#include <gtest/gtest.h>

#include "text/base64.h"

namespace dupin::text {
namespace {

// RFC 4648, section 10.
TEST(Base64, is_that_of_the_standard) {
  const std::pair<std::string, std::string> samples[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"},
                                                         {"\xff\xfe", "//4="}};
  for (const auto& [bytes, text] : samples) {
    EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(from_base64(text), bytes);
  }
}

TEST(Base64, all_bytes_come_back) {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) {
    bytes += static_cast<char>(i * 37);
    EXPECT_EQ(from_base64(base64(bytes)), bytes);
  }
}

TEST(Base64, nothing_else_is_read) {
  for (const char* const text :
       {"Z", "Zg=", "Zg", "Zh==", "Zm9=", "====", "Z===", "Zg==Zg==", "Z g=", "Zm9\n"}) {
    EXPECT_EQ(from_base64(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace dupin::text
