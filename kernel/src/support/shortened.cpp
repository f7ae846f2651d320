#include "support/shortened.h"

#include <algorithm>

namespace dupin::support {
namespace {

constexpr std::string_view kEllipsis = "\u2026";
constexpr auto kNone = std::string_view::npos;

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t'; }

// Where a quoted text ends that begins at `from`: at its mark with nothing but punctuation or a
// blank behind, which an apostrophe has not.
std::size_t closing(std::string_view message, std::size_t from) {
  const char mark = message[from];
  for (std::size_t at = message.find(mark, from + 1); at != kNone;
       at = message.find(mark, at + 1)) {
    const char next = at + 1 < message.size() ? message[at + 1] : ' ';
    if (is_blank(next) || std::string_view(".,:;)").find(next) != kNone) {
      return at;
    }
  }
  return kNone;
}

bool opens(std::string_view message, std::size_t at) {
  return (message[at] == '\'' || message[at] == '"') &&
         (at == 0 || is_blank(message[at - 1]) || message[at - 1] == '(');
}

}  // namespace

std::string shortened(std::string_view text) {
  // What has been shortened stays as it is.
  if (text.size() <= kShownBytes + kEllipsis.size()) {
    return std::string(text);
  }
  std::size_t end = kShownBytes;
  while (end > 0 && continues_character(text[end])) {
    --end;
  }
  return std::string(text.substr(0, end)).append(kEllipsis);
}

std::string with_short_quotes(std::string_view message) {
  std::string text;
  std::size_t at = 0;
  while (at < message.size()) {
    const std::size_t last = opens(message, at) ? closing(message, at) : kNone;
    if (last != kNone) {
      text += message[at] + shortened(message.substr(at + 1, last - at - 1)) + message[last];
      at = last + 1;
    } else if (is_blank(message[at])) {
      text += message[at++];
    } else {
      const auto end = std::find_if(message.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                                    message.end(), is_blank);
      const std::string_view word(message.begin() + static_cast<std::ptrdiff_t>(at), end);
      text += word.find('/') == kNone ? shortened(word) : std::string(word);
      at += word.size();
    }
  }
  return text;
}

std::string with_short_keys(std::string_view place) {
  const std::size_t pointer = place.find("#/");
  if (pointer == kNone) {
    return std::string(place);
  }
  std::string text(place.substr(0, pointer + 1));
  for (std::size_t at = pointer + 1; at < place.size();) {
    const std::size_t next = std::min(place.find('/', at + 1), place.size());
    text += shortened(place.substr(at, next - at));
    at = next;
  }
  return text;
}

}  // namespace dupin::support
