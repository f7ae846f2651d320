#include "json/expression.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "dupin/kernel/decimal.h"
#include "json/nominal_size.h"

namespace dupin::json {
namespace {

constexpr int kDeepest = 32;  // parentheses and signs

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

constexpr std::string_view kSpaces = " \t\n\r";

/// Reads one expression, which ends at the end of the text or at `closing`.
class Parser {
 public:
  Parser(const JsonNode& node, std::string_view text, std::size_t at, Unit unit,
         const Lookup& lookup)
      : node_(node), full_(text), text_(text), at_(at), unit_(unit), lookup_(lookup) {}

  Json whole(std::size_t end) {
    text_ = text_.substr(0, end);
    skip_space();
    if (at_ < text_.size() && is_letter(text_[at_])) {
      const std::size_t begin = at_;
      const std::string_view name = take_name();
      skip_space();
      if (at_ == text_.size()) {
        return looked_up(name, begin);
      }
      at_ = begin;
    }
    const double value = sum();
    if (at_ < text_.size()) {
      fail("an operator + - * / is missing", at_);
    }
    return number_value(value);
  }

 private:
  [[noreturn]] void fail(const std::string& message, std::size_t at) const {
    node_.fail("in \"" + std::string(full_) + "\", column " + std::to_string(at + 1) + ": " +
               message);
  }

  Json looked_up(std::string_view name, std::size_t at) const {
    try {
      return lookup_(name);
    } catch (const LookupFault& fault) {
      fail(fault.message, at);
    }
  }

  double finite(double value, std::size_t at) const {
    if (!std::isfinite(value)) {
      fail("the result is too large", at);
    }
    return value;
  }

  double sum() {
    double value = product();
    while (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) {
      const std::size_t sign = at_++;
      const double next = product();
      value = finite(text_[sign] == '+' ? value + next : value - next, sign);
    }
    return value;
  }

  double product() {
    double value = factor();
    while (at_ < text_.size() && (text_[at_] == '*' || text_[at_] == '/')) {
      const std::size_t sign = at_++;
      const double next = factor();
      if (text_[sign] == '/' && next == 0) {
        fail("division by zero", sign);
      }
      value = finite(text_[sign] == '*' ? value * next : value / next, sign);
    }
    return value;
  }

  double factor() {
    skip_space();
    const std::size_t begin = at_;
    if (at_ == text_.size()) {
      fail("a number, a name or ( is missing", at_);
    }
    double value = 0;
    const char c = text_[at_];
    const bool is_deeper = c == '-' || c == '+' || c == '(';
    if (is_deeper && ++depth_ > kDeepest) {
      fail("parentheses and signs are nested more than " + std::to_string(kDeepest) + " deep", at_);
    }
    if (c == '-' || c == '+') {
      ++at_;
      value = c == '-' ? -factor() : factor();
    } else if (c == '(') {
      ++at_;
      value = sum();
      if (at_ == text_.size() || text_[at_] != ')') {
        fail("the parenthesis of column " + std::to_string(begin + 1) + " is not closed", at_);
      }
      ++at_;
    } else if (is_letter(c)) {
      value = named();
    } else if (is_digit(c) || c == '.') {
      value = number();
    } else {
      fail("a number, a name or ( is missing", at_);
    }
    depth_ -= is_deeper ? 1 : 0;
    skip_space();
    return value;
  }

  double named() {
    const std::size_t begin = at_;
    const std::string_view name = take_name();
    const Json value = looked_up(name, begin);
    if (value.is_number()) {
      return value.get<double>();
    }
    if (value.is_string()) {
      if (const auto diameter = outside_diameter(value.get<std::string>(), unit_)) {
        return *diameter;
      }
    }
    fail("'" + std::string(name) + "' is neither a number nor a nominal size", begin);
  }

  double number() {
    const std::size_t begin = at_;
    double value = 0;
    const auto [rest, failure] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (failure != std::errc() || !std::isfinite(value)) {
      fail(failure == std::errc::result_out_of_range ? "the number is out of range"
                                                     : "a number is malformed",
           begin);
    }
    at_ = static_cast<std::size_t>(rest - text_.data());
    skip_space();
    if (at_ == text_.size() || !is_letter(text_[at_])) {
      return value;
    }
    const std::size_t behind = at_;
    const std::string_view name = take_name();
    const auto own = unit_called(name);
    if (!own) {
      fail("'" + std::string(name) + "' is no unit; mm, cm, m, in or ft may follow a number",
           behind);
    }
    return finite(value * millimetres(*own) / millimetres(unit_), begin);
  }

  std::string_view take_name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) {
      ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }

  void skip_space() { at_ = std::min(text_.find_first_not_of(kSpaces, at_), text_.size()); }

  const JsonNode& node_;
  std::string_view full_, text_;  ///< as typed, and up to its end
  std::size_t at_;
  Unit unit_;
  const Lookup& lookup_;
  int depth_ = 0;
};

std::string short_text(const JsonNode& node) {
  std::string text = node.text();
  if (text.size() > kLongestExpression) {
    node.fail("an expression has at most " + std::to_string(kLongestExpression) + " bytes, not " +
              std::to_string(text.size()));
  }
  return text;
}

}  // namespace

bool is_value_name(std::string_view name) {
  return !name.empty() && !is_digit(name.front()) &&
         std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c); }) &&
         !unit_called(name);
}

bool is_expression(std::string_view text) { return text.starts_with('='); }

Json number_value(double value) {
  const bool is_whole = value >= 0 && !std::signbit(value) && value == std::floor(value) &&
                        value <= std::numeric_limits<std::uint32_t>::max();
  return is_whole ? Json(static_cast<std::uint64_t>(value)) : Json(value);
}

Json evaluated(const JsonNode& node, Unit unit, const Lookup& lookup) {
  const std::string text = short_text(node);
  return Parser(node, text, 1, unit, lookup).whole(text.size());
}

std::string with_braces_replaced(const JsonNode& node, Unit unit, const Lookup& lookup) {
  std::string text = node.text(), result;
  if (text.find('{') == std::string::npos) {
    return text;
  }
  (void)short_text(node);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = std::min(text.find('{', at), text.size());
    result.append(text, at, open - at);
    if (open == text.size()) {
      break;
    }
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) {
      node.fail("in \"" + text + "\", column " + std::to_string(open + 1) +
                ": the brace is not closed");
    }
    const Json value = Parser(node, text, open + 1, unit, lookup).whole(close);
    if (value.is_array()) {
      node.fail("in \"" + text + "\", column " + std::to_string(open + 1) +
                ": a list has no place in a text");
    }
    result += value.is_string() ? value.get<std::string>() : decimal(value.get<double>());
    if (result.size() > kLongestExpression) {
      node.fail("the text becomes longer than " + std::to_string(kLongestExpression) + " bytes");
    }
    at = close + 1;
  }
  return result;
}

std::optional<double> quantity(std::string_view text, Unit unit) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc()) {
    return std::nullopt;
  }
  std::string_view name(rest, static_cast<std::size_t>(end - rest));
  name.remove_prefix(std::min(name.find_first_not_of(kSpaces), name.size()));
  const auto own = unit_called(name);
  const double length = own ? value * millimetres(*own) / millimetres(unit) : 0;
  return own && std::isfinite(length) ? std::optional(length) : std::nullopt;
}

}  // namespace dupin::json
