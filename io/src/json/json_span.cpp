#include "json/json_span.h"

#include "json/json_document.h"
#include "text/byte_order_mark.h"

namespace dupin::json {
namespace {

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text), at_(dupin::text::byte_order_mark(text)) {
    skip_space();
  }

  [[nodiscard]] std::size_t position() const { return at_; }

  // Past the value that begins here, and the white space after it; returns its end.
  std::size_t skip_value() {
    if (text_[at_] == '"') {
      skip_string();
    } else {
      int depth = 0;
      do {
        const char c = text_[at_];
        if (c == '"') {
          skip_string();
          continue;
        }
        depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
        ++at_;
      } while (at_ < text_.size() && (depth > 0 || !ends_literal()));
    }
    const std::size_t end = at_;
    skip_space();
    return end;
  }

  void enter(const JsonStep& step) {
    next();  // the bracket
    if (const auto* index = std::get_if<std::size_t>(&step)) {
      for (std::size_t i = 0; i < *index; ++i) {
        skip_value();
        next();  // the comma
      }
      return;
    }
    while (key() != std::get<std::string>(step)) {
      next();  // the colon
      skip_value();
      next();  // the comma
    }
    next();
  }

 private:
  void next() {
    ++at_;
    skip_space();
  }

  void skip_space() {
    at_ = text_.find_first_not_of(" \t\r\n", at_);
    at_ = at_ == std::string_view::npos ? text_.size() : at_;
  }

  void skip_string() {
    for (++at_; text_[at_] != '"'; ++at_) {
      at_ += text_[at_] == '\\' ? 1 : 0;
    }
    ++at_;
  }

  // At depth 0 a bracket was closed, or a number, true, false or null is over.
  [[nodiscard]] bool ends_literal() const {
    const char last = text_[at_ - 1];
    return last == '}' || last == ']' ||
           std::string_view(" \t\r\n,]}").find(text_[at_]) != std::string_view::npos;
  }

  std::string key() {
    const std::size_t begin = at_;
    const std::size_t end = skip_value();
    return Json::parse(text_.substr(begin, end - begin)).get<std::string>();
  }

  std::string_view text_;
  std::size_t at_;
};

}  // namespace

TextSpan json_span(std::string_view text, const std::vector<JsonStep>& steps) {
  Scanner scanner(text);
  for (const JsonStep& step : steps) {
    scanner.enter(step);
  }
  const std::size_t begin = scanner.position();
  return {begin, scanner.skip_value()};
}

}  // namespace dupin::json
