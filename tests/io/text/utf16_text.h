#pragma once

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

namespace dupin::test {

inline std::string utf16(std::string_view text, bool is_big, bool has_mark) {
  std::string result = !has_mark ? "" : is_big ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) {
    result += is_big ? std::string{'\0', c} : std::string{c, '\0'};
  }
  return result;
}

/// Whatever its order of bytes, with and without a mark, the text is refused as what it is.
template <class Read>
void expect_utf16_refused(std::string_view text, const std::string& file, const Read& read) {
  for (const bool is_big : {false, true}) {
    for (const bool has_mark : {false, true}) {
      try {
        read(utf16(text, is_big, has_mark), file);
        ADD_FAILURE() << file;
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  file + ": the text is in UTF-16, expected UTF-8; save it as that");
      }
    }
  }
}

}  // namespace dupin::test
