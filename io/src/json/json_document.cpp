#include "json/json_document.h"

#include <algorithm>
#include <set>
#include <vector>

#include "dupin/kernel/parallel.h"
#include "text/byte_order_mark.h"
#include "text/json_depth.h"
#include "text/text_scanner.h"
#include "text/utf16.h"

namespace dupin::json {
namespace {

std::string place(const std::string& source, const std::string& pointer) {
  return source.empty() ? pointer : source + "#" + pointer;
}

std::string escaped(std::string_view key) {  // RFC 6901
  std::string result;
  for (const char c : key) {
    result += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  }
  return result;
}

std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const auto line = std::count(before.begin(), before.end(), '\n');
  const auto line_start = before.rfind('\n');
  const std::size_t column =
      line_start == std::string_view::npos ? before.size() + 1 : before.size() - line_start;
  return std::to_string(line + 1) + ":" + std::to_string(column);
}

std::string after(std::string_view mark, const std::string& what) {
  const auto start = what.find(mark);
  return start == std::string::npos ? what : what.substr(start + mark.size());
}

constexpr std::size_t kMostKeys = 4096;  // of one object, where keys are looked up one by one

// Follows the parser to find repeated keys, which a JSON value cannot hold. What is malformed ends
// the search: whoever makes the value says so. (The library's own parser with a callback looks at
// all elements of an array again at the end of each.)
class RepeatedKeys : public nlohmann::json_sax<Json> {
 public:
  explicit RepeatedKeys(const std::string& source) : source_(&source) {}

  bool null() override { return begin_value(); }
  bool boolean(bool /*value*/) override { return begin_value(); }
  bool number_integer(std::int64_t /*value*/) override { return begin_value(); }
  bool number_unsigned(std::uint64_t /*value*/) override { return begin_value(); }
  bool number_float(double /*value*/, const std::string& /*text*/) override {
    return begin_value();
  }
  bool string(std::string& /*value*/) override { return begin_value(); }
  bool binary(Json::binary_t& /*value*/) override { return begin_value(); }
  bool start_object(std::size_t /*size*/) override { return begin_level(false); }
  bool start_array(std::size_t /*size*/) override { return begin_level(true); }
  bool end_object() override { return end_level(); }
  bool end_array() override { return end_level(); }
  bool parse_error(std::size_t /*byte*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*reason*/) override {
    return false;
  }

  bool key(std::string& name) override {
    Level& level = levels_.back();
    level.key = name;
    if (!level.keys.insert(name).second) {
      fail("the key occurs twice");
    }
    if (level.keys.size() > kMostKeys) {
      fail("the object has more than " + std::to_string(kMostKeys) + " keys");
    }
    return true;
  }

 private:
  struct Level {
    bool is_array = false;
    std::size_t count = 0;
    std::string key;
    std::set<std::string> keys;
  };

  bool begin_value() {
    if (!levels_.empty()) {
      ++levels_.back().count;
    }
    return true;
  }

  bool begin_level(bool is_array) {
    begin_value();
    levels_.push_back({is_array, 0, {}, {}});
    return true;
  }

  bool end_level() {
    levels_.pop_back();
    return true;
  }

  [[noreturn]] void fail(const std::string& message) const {
    std::string pointer;
    for (const auto& level : levels_) {
      pointer += "/" + (level.is_array ? std::to_string(level.count - 1) : escaped(level.key));
    }
    throw Error(Errc::parse_failed, message, {}, place(*source_, pointer));
  }

  const std::string* source_;
  std::vector<Level> levels_;
};

// Another kind of file, of whose brackets and columns nobody wants to hear.
void require_start(std::string_view text, const std::string& source) {
  constexpr std::string_view kSpaces = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpaces, dupin::text::byte_order_mark(text));
  if (first == std::string_view::npos) {
    return;  // nothing at all, which the parser says
  }
  const std::string_view rest = text.substr(first);
  const bool is_literal =
      rest.starts_with("true") || rest.starts_with("false") || rest.starts_with("null");
  if (!is_literal && std::string_view("{[\"-0123456789").find(rest[0]) == std::string_view::npos) {
    throw Error(Errc::parse_failed,
                "found " + dupin::text::quoted(rest.substr(0, 16)) +
                    " at the start, expected a document, which is JSON and begins with '{'",
                {}, source + ":" + line_and_column(text, first + 1));
  }
}

// The parser takes one for the text's end, whatever is behind it.
void require_no_nul(std::string_view text, const std::string& source) {
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) {
    throw Error(Errc::parse_failed, "found a NUL byte behind the document, expected its end", {},
                source + ":" + line_and_column(text, nul + 1));
  }
}

Json parsed(std::string_view text, const std::string& source) {
  try {
    return Json::parse(text.begin(), text.end());
  } catch (const Json::parse_error& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: reason"
    throw Error(Errc::parse_failed, after(": ", error.what()), {},
                source + ":" + line_and_column(text, error.byte));
  } catch (const Json::out_of_range& error) {
    // A number beyond all doubles: "[json.exception.out_of_range.406] number overflow parsing
    // '1e999'"
    const std::string token = after("parsing '", error.what());
    const auto first = text.find(std::string_view(token).substr(0, token.size() - 1));
    throw Error(Errc::parse_failed, after("] ", error.what()), {},
                source + ":" + line_and_column(text, first + 1));
  }
}

}  // namespace

Json parse_json(std::string_view text, const std::string& source) {
  dupin::text::refuse_utf16(text, source);
  require_start(text, source);
  if (const auto bracket = dupin::text::first_too_deep(text)) {
    throw Error(
        Errc::parse_failed,
        "brackets are nested more than " + std::to_string(dupin::text::kDeepestJson) + " deep", {},
        source + ":" + line_and_column(text, *bracket + 1));
  }
  const auto require_keys = [&] {
    RepeatedKeys repeated(source);
    (void)Json::sax_parse(text.begin(), text.end(), &repeated);
  };
  if (dupin::text::has_more_keys(text, kMostKeys)) {
    require_keys();  // first: a value of so many, one looked up after the other, takes long
  }
  Json result;
  for_each_in_parallel(2, [&](std::size_t task) {
    const UsualArithmetic usual;
    if (task == 0) {
      require_keys();
    } else {
      result = parsed(text, source);
    }
  });
  require_no_nul(text, source);
  return result;
}

void JsonNode::fail(const std::string& message) const {
  throw Error(Errc::parse_failed, message, {}, place(*source_, pointer_));
}

bool JsonNode::has(std::string_view key) const {
  return value_->is_object() && value_->contains(std::string(key));
}

JsonNode JsonNode::at(std::string_view key) const {
  require_object();
  if (!has(key)) {
    fail("the key '" + std::string(key) + "' is missing");
  }
  return {value_->at(std::string(key)), *source_, pointer_ + "/" + escaped(key), unit_};
}

JsonNode JsonNode::at(std::size_t index) const {
  return {value_->at(index), *source_, pointer_ + "/" + std::to_string(index), unit_};
}

JsonNode JsonNode::with(const Json& value, std::string_view key) const {
  return {value, *source_, pointer_ + "/" + escaped(key), unit_};
}

void JsonNode::require_object() const {
  if (!value_->is_object()) {
    fail(std::string("must be an object, not ") + value_->type_name());
  }
}

std::size_t JsonNode::require_array() const {
  if (!value_->is_array()) {
    fail(std::string("must be an array, not ") + value_->type_name());
  }
  return value_->size();
}

double JsonNode::number() const {
  if (!value_->is_number()) {
    fail(std::string("must be a number, not ") + value_->type_name());
  }
  return value_->get<double>();
}

std::string JsonNode::text() const {
  if (!value_->is_string()) {
    fail(std::string("must be a string, not ") + value_->type_name());
  }
  return value_->get<std::string>();
}

}  // namespace dupin::json
