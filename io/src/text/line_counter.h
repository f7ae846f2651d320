#pragma once

#include <cstddef>
#include <string_view>

namespace dupin::text {

/// Lines of a text from 1, which end with LF, CR LF or CR. Positions must not get smaller; all
/// together take O(text).
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text) {}

  [[nodiscard]] std::size_t at(std::size_t position) {
    for (; seen_ < position; ++seen_) {
      const char c = text_[seen_];
      const bool is_last = seen_ + 1 == text_.size();
      line_ += c == '\n' || (c == '\r' && (is_last || text_[seen_ + 1] != '\n'));
    }
    return line_;
  }

 private:
  std::string_view text_;
  std::size_t seen_ = 0, line_ = 1;
};

}  // namespace dupin::text
