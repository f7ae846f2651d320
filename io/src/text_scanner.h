#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "dupin/kernel/vec.h"

namespace dupin {

/// Reads text formats token by token and knows the place of every fault. A line ends with LF, CR LF
/// or CR. A UTF-8 byte order mark at the start is skipped.
class TextScanner {
 public:
  /// `comment` starts a comment that runs to the end of its line; 0 for formats without.
  TextScanner(std::string_view bytes, std::string_view file, char comment = '\0');

  /// Moves over spaces, tabs and a comment, not over a line's end.
  void skip_blanks();
  /// Moves over blanks and line ends to the next token.
  void skip_space();
  [[nodiscard]] bool at_line_end();  ///< nothing but blanks before the line's or file's end
  [[nodiscard]] bool at_end();       ///< nothing but blanks and line ends before the file's end

  /// The next token of this line without moving; empty at the line's end.
  [[nodiscard]] std::string_view peek();
  /// Takes the next token of this line; empty at the line's end.
  std::string_view token();
  /// Takes the next token if it is `keyword`, given in lower case, in any case.
  bool take(std::string_view keyword);
  /// Takes the rest of the line without blanks around it, and the line's end.
  std::string_view rest_of_line();
  /// Takes the line's end; fails on anything before it.
  void end_line(std::string_view expected);

  /// The nearest double to the next token; fails unless it is a finite decimal number in range.
  double number(std::string_view expected);
  Vec3 vector(std::string_view expected);
  /// An integer in [lowest, highest].
  std::int64_t integer(std::int64_t lowest, std::int64_t highest, std::string_view expected);

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - position_; }
  void move_to(std::size_t position) { position_ = position; }

  /// Throws Error{parse_failed}: "found TOKEN, expected EXPECTED" at the next token.
  [[noreturn]] void fail(std::string_view expected);
  /// Throws Error{parse_failed} with "file:line" of `position`.
  [[noreturn]] void fail_at(std::size_t position, const std::string& message) const;

 private:
  [[nodiscard]] bool ends_token(std::size_t position) const;

  std::string_view bytes_;
  std::string_view file_;
  std::size_t position_ = 0;
  char comment_;
};

/// Bytes of a file for an error message: quoted, at most 40 of them, unprintable ones as \xNN.
[[nodiscard]] std::string quoted(std::string_view bytes);

}  // namespace dupin
