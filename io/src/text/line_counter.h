#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace dupin::text {

/// Lines of a text from 1, which end with LF, CR LF or CR, or with several CR before an LF, as
/// programs leave them that write text as text twice. Positions must not get smaller; all
/// together take O(text).
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text) {}

  [[nodiscard]] std::size_t at(std::size_t position) {
    for (; seen_ < position; ++seen_) {
      const char c = text_[seen_];
      if (c == '\r' && seen_ >= run_end_) {
        run_end_ = std::min(text_.find_first_not_of('\r', seen_), text_.size());
      }
      const bool is_before_lf = run_end_ < text_.size() && text_[run_end_] == '\n';
      line_ += c == '\n' || (c == '\r' && !is_before_lf);
    }
    return line_;
  }

 private:
  std::string_view text_;
  std::size_t seen_ = 0, line_ = 1;
  std::size_t run_end_ = 0;  // of the CRs that were seen last
};

}  // namespace dupin::text
