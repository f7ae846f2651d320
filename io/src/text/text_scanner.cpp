#include "text/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "dupin/kernel/error.h"
#include "text/byte_order_mark.h"
#include "text/line_counter.h"
#include "text/lower_case.h"

namespace dupin::text {
TextScanner::TextScanner(std::string_view bytes, std::string_view file, char comment)
    : bytes_(bytes), file_(file), position_(byte_order_mark(bytes)), comment_(comment) {}

void TextScanner::skip_all_blanks() {
  while (position_ < bytes_.size() && is_blank(bytes_[position_])) {
    ++position_;
  }
  if (position_ < bytes_.size() && is_comment(bytes_[position_])) {
    while (position_ < bytes_.size() && !is_line_end(bytes_[position_])) {
      ++position_;
    }
  }
}

void TextScanner::skip_all_space() {
  for (;;) {
    skip_blanks();
    if (position_ == bytes_.size() || !is_line_end(bytes_[position_])) {
      return;
    }
    ++position_;
  }
}

bool TextScanner::at_end() {
  skip_space();
  return position_ == bytes_.size();
}

std::string_view TextScanner::peek() {
  skip_blanks();
  // A backslash that continues a line ends the token before it, and is one itself.
  std::size_t end = position_ + (is_at('\\') ? 1 : 0);
  while (!ends_token(end)) {
    ++end;
  }
  return bytes_.substr(position_, end - position_);
}

std::string_view TextScanner::token() {
  const std::string_view next = peek();
  position_ += next.size();
  return next;
}

bool TextScanner::take(std::string_view keyword) {
  skip_blanks();
  const std::string_view next = bytes_.substr(position_, keyword.size());
  const bool same = std::equal(next.begin(), next.end(), keyword.begin(), keyword.end(),
                               [](char found, char wanted) { return lower_case(found) == wanted; });
  if (!same || !ends_token(position_ + keyword.size())) {
    return false;
  }
  position_ += keyword.size();
  return true;
}

std::string_view TextScanner::rest_of_line() {
  while (position_ < bytes_.size() && is_blank(bytes_[position_])) {
    ++position_;
  }
  std::size_t end = position_;
  while (end < bytes_.size() && !is_line_end(bytes_[end])) {
    ++end;
  }
  std::string_view rest = bytes_.substr(position_, end - position_);
  while (!rest.empty() && is_blank(rest.back())) {
    rest.remove_suffix(1);
  }
  // All CRs before an LF are of one line's end.
  const std::size_t behind = std::min(bytes_.find_first_not_of('\r', end), bytes_.size());
  const bool is_before_lf = behind < bytes_.size() && bytes_[behind] == '\n';
  position_ = is_before_lf ? behind + 1 : std::min(end + 1, bytes_.size());
  return rest;
}

void TextScanner::end_other_line(std::string_view expected) {
  if (!at_line_end()) {
    fail(expected);
  }
  (void)rest_of_line();
}

double TextScanner::number(std::string_view expected) {
  skip_blanks();
  const char* const end = bytes_.data() + bytes_.size();
  const char* begin = bytes_.data() + position_;
  if (const auto plain = read_plain_decimal(begin, end); plain.end != nullptr) {
    const auto next = static_cast<std::size_t>(plain.end - bytes_.data());
    if (ends_token(next)) {
      position_ = next;
      return plain.value + 0.0;  // -0 becomes 0
    }
  }
  if (end - begin > 1 && begin[0] == '+' && begin[1] != '-') {
    ++begin;
  }
  double value = 0;
  const auto [last, error] = std::from_chars(begin, end, value);
  const auto next = static_cast<std::size_t>(last - bytes_.data());
  if (error == std::errc::invalid_argument || !ends_token(next)) {
    fail(expected);
  }
  if (error == std::errc::result_out_of_range) {
    fail(std::string(expected) + " in the range of doubles");
  }
  if (!std::isfinite(value)) {
    fail(std::string(expected) + " that is finite");
  }
  position_ = next;
  return value + 0.0;  // -0 becomes 0
}

void TextScanner::skip_number(std::string_view expected) {
  std::string_view rest = peek();
  if (rest.size() > 1 && (rest.front() == '+' || rest.front() == '-')) {
    rest.remove_prefix(1);
  }
  double ignored = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), ignored);
  const bool is_number = error != std::errc::invalid_argument && rest.front() != '-';
  rest.remove_prefix(is_number ? static_cast<std::size_t>(end - rest.data()) : 0);
  // What is left of "1.#INF" and "-nan(ind)", where from_chars does not know them.
  if (!is_number || !(rest.empty() || rest.starts_with("#") || rest == "(ind)")) {
    fail(expected);
  }
  (void)token();
  // "#INF" and the like are not where a comment begins.
  if (rest.empty() && bytes_[position_ - 1] == '.' && is_at('#')) {
    while (!ends_token(++position_)) {
    }
  }
}

Vec3 TextScanner::vector(std::string_view expected) {
  const double x = number(expected);
  const double y = number(expected);
  const double z = number(expected);
  return {x, y, z};
}

std::int64_t TextScanner::other_integer(std::int64_t lowest, std::int64_t highest,
                                        std::string_view expected) {
  const char* const end = bytes_.data() + bytes_.size();
  std::int64_t value = 0;
  const auto [last, error] = std::from_chars(bytes_.data() + position_, end, value);
  const auto next = static_cast<std::size_t>(last - bytes_.data());
  if (error == std::errc::invalid_argument || !ends_token(next)) {
    fail(expected);
  }
  if (error != std::errc() || value < lowest || value > highest) {
    fail(std::string(expected) + " from " + std::to_string(lowest) + " to " +
         std::to_string(highest));
  }
  position_ = next;
  return value;
}

bool TextScanner::take_triangle(char head, std::uint32_t first, std::size_t points,
                                std::vector<Triangle>& triangles) {
  if (!is_at(head)) {
    return false;
  }
  const char* const end = bytes_.data() + bytes_.size();
  const char* next = bytes_.data() + position_ + 1;
  Triangle triangle;
  for (std::uint32_t& corner : triangle) {
    if (next == end || *next != ' ') {
      return false;
    }
    const DigitRun digits = take_few_digits(next + 1, end);
    corner = static_cast<std::uint32_t>(digits.value) - first;  // below the first: a large number
    if (digits.end == next + 1 || corner >= points) {
      return false;
    }
    next = digits.end;
    if (head == 'f' && end - next > 2 && next[0] == '/' && next[1] == '/') {
      const DigitRun normal = take_few_digits(next + 2, end);
      if (normal.end == next + 2) {
        return false;
      }
      next = normal.end;
    }
  }
  if (next == end || *next != '\n') {
    return false;
  }
  triangles.push_back({triangle[0], triangle[1], triangle[2]});
  position_ = static_cast<std::size_t>(next + 1 - bytes_.data());
  return true;
}

void TextScanner::fail(std::string_view expected) {
  const std::string_view next = peek();
  std::string found = quoted(next);
  if (next.empty()) {
    found = position_ == bytes_.size() ? "the end of the file" : "the end of the line";
  }
  fail_at(position_, "found " + found + ", expected " + std::string(expected));
}

std::string TextScanner::place(std::size_t position) const {
  return std::string(file_) + ":" + std::to_string(LineCounter(bytes_).at(position));
}

void TextScanner::fail_at(std::size_t position, const std::string& message) const {
  throw Error(Errc::parse_failed, message, {}, place(position));
}

std::string quoted(std::string_view bytes) {
  constexpr std::size_t kLongest = 40;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "'";
  for (const char c : bytes.substr(0, kLongest)) {
    if (c >= ' ' && c <= '~') {
      text += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      text += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return text + (bytes.size() > kLongest ? "...'" : "'");
}

}  // namespace dupin::text
