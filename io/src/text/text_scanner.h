#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/vec.h"
#include "text/plain_decimal.h"

namespace dupin::text {

/// Reads text formats token by token and knows the place of every fault. A line ends with LF, CR LF
/// or CR. A UTF-8 byte order mark at the start is skipped.
class TextScanner {
 public:
  /// `comment` starts a comment that runs to the end of its line; 0 for formats without.
  TextScanner(std::string_view bytes, std::string_view file, char comment = '\0');

  /// Moves over spaces, tabs and a comment, not over a line's end.
  void skip_blanks() {
    const std::size_t next = position_ + (is_at(' ') ? 1 : 0);
    if (begins_token(next)) {
      position_ = next;
    } else {
      skip_all_blanks();
    }
  }
  /// Moves over blanks and line ends to the next token.
  void skip_space() {
    const std::size_t next = position_ + (is_at('\n') ? 1 : 0);
    if (begins_token(next)) {
      position_ = next;
    } else {
      skip_all_space();
    }
  }
  /// Nothing but blanks before the line's or file's end.
  [[nodiscard]] bool at_line_end() {
    if (is_at('\n')) {
      return true;
    }
    skip_blanks();
    return position_ == bytes_.size() || is_line_end(bytes_[position_]);
  }
  /// Nothing but blanks and line ends before the file's end.
  [[nodiscard]] bool at_end();

  /// The next token of this line without moving; empty at the line's end.
  [[nodiscard]] std::string_view peek();
  /// Takes the next token of this line; empty at the line's end.
  std::string_view token();
  /// Takes the next token if it is `keyword`, given in lower case, in any case.
  bool take(std::string_view keyword);
  /// Takes the rest of the line without blanks around it, and the line's end: all of it, as names
  /// may begin like comments.
  std::string_view rest_of_line();
  /// Takes the line's end; fails on anything before it.
  void end_line(std::string_view expected) {
    if (is_at('\n')) {
      ++position_;
    } else {
      end_other_line(expected);
    }
  }

  /// The nearest double to the next token; fails unless it is a finite decimal number in range.
  double number(std::string_view expected);
  Vec3 vector(std::string_view expected);
  /// Takes a number that nobody reads, as of a colour: finite or not, of any size, in any spelling
  /// that programs print ("nan", "-nan(ind)", "1.#INF").
  void skip_number(std::string_view expected);
  /// An integer in [lowest, highest].
  std::int64_t integer(std::int64_t lowest, std::int64_t highest, std::string_view expected) {
    skip_blanks();
    const char* const begin = bytes_.data() + position_;
    const DigitRun digits = take_few_digits(begin, bytes_.data() + bytes_.size());
    const auto value = static_cast<std::int64_t>(digits.value);
    const auto next = static_cast<std::size_t>(digits.end - bytes_.data());
    if (next == position_ || value < lowest || value > highest || !ends_token(next)) {
      return other_integer(lowest, highest, expected);
    }
    position_ = next;
    return value;
  }

  /// Takes a line "HEAD a b c" and appends the triangle, if it is written as most files have it:
  /// single blanks, at most seven digits each, LF behind, and indices of `points` points of which
  /// `first` is the first. Otherwise takes nothing.
  bool take_triangle(char head, std::uint32_t first, std::size_t points,
                     std::vector<Triangle>& triangles);

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - position_; }
  void move_to(std::size_t position) { position_ = position; }

  /// "file:line" of a position.
  [[nodiscard]] std::string place(std::size_t position) const;
  /// Throws Error{parse_failed}: "found TOKEN, expected EXPECTED" at the next token.
  [[noreturn]] void fail(std::string_view expected);
  /// Throws Error{parse_failed} with "file:line" of `position`.
  [[noreturn]] void fail_at(std::size_t position, const std::string& message) const;

 private:
  [[nodiscard]] static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  [[nodiscard]] static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
  }
  [[nodiscard]] bool is_comment(char c) const { return comment_ != '\0' && c == comment_; }
  /// A backslash with nothing but blanks before the line's end, which some formats have.
  [[nodiscard]] bool continues_line(std::size_t position) const {
    if (bytes_[position] != '\\') {
      return false;
    }
    do {
      ++position;
    } while (position < bytes_.size() && is_blank(bytes_[position]));
    return position < bytes_.size() && is_line_end(bytes_[position]);
  }
  [[nodiscard]] bool is_at(char c) const {
    return position_ < bytes_.size() && bytes_[position_] == c;
  }
  /// A printable character, as tokens begin with; they may also begin with others.
  [[nodiscard]] bool begins_token(std::size_t position) const {
    return position < bytes_.size() && bytes_[position] > ' ' && !is_comment(bytes_[position]);
  }
  [[nodiscard]] bool ends_token(std::size_t position) const {
    if (position >= bytes_.size()) {
      return true;
    }
    const char c = bytes_[position];
    return is_blank(c) || is_line_end(c) || is_comment(c) || continues_line(position);
  }

  // What the short functions above do for all that files seldom hold.
  void skip_all_blanks();
  void skip_all_space();
  void end_other_line(std::string_view expected);
  std::int64_t other_integer(std::int64_t lowest, std::int64_t highest, std::string_view expected);

  std::string_view bytes_;
  std::string_view file_;
  std::size_t position_ = 0;
  char comment_;
};

/// Bytes of a file for an error message: quoted, at most 40 of them, unprintable ones as \xNN.
[[nodiscard]] std::string quoted(std::string_view bytes);

}  // namespace dupin::text
