#include "dupin/kernel/printable.h"

#include <algorithm>

#include <boost/locale/utf.hpp>

namespace dupin {
namespace {

// Of the character that the text, which is not empty, begins with; 0 if it is no UTF-8.
std::size_t character_length(std::string_view text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  const char* at = text.data();
  return boost::locale::utf::is_valid_codepoint(Utf8::decode(at, text.data() + text.size()))
             ? static_cast<std::size_t>(at - text.data())
             : 0;
}

}  // namespace

std::size_t control_length(std::string_view text) {
  const auto is = [&](std::size_t at, unsigned from, unsigned to) {
    return at < text.size() && static_cast<unsigned char>(text[at]) >= from &&
           static_cast<unsigned char>(text[at]) <= to;
  };
  if (is(0, 0, 0x1F) || is(0, 0x7F, 0x7F)) {
    return 1;
  }
  if (is(0, 0xC2, 0xC2)) {
    return is(1, 0x80, 0x9F) ? 2 : 0;
  }
  const bool is_general = is(0, 0xE2, 0xE2) && ((is(1, 0x80, 0x80) && is(2, 0xA8, 0xAE)) ||
                                                (is(1, 0x81, 0x81) && is(2, 0xA6, 0xA9)));
  return is_general ? 3 : 0;
}

bool has_controls(std::string_view text) {
  for (; !text.empty(); text.remove_prefix(1)) {
    if (control_length(text) > 0) {
      return true;
    }
  }
  return false;
}

std::string printable(std::string_view text, std::string_view kept) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string result;
  while (!text.empty()) {
    const std::size_t character = character_length(text);
    const bool is_shown = character > 0 && (control_length(text) == 0 ||
                                            kept.find(text.front()) != std::string_view::npos);
    const std::string_view next = text.substr(0, std::max(character, std::size_t{1}));
    if (is_shown) {
      result += next;
    } else {
      for (const char c : next) {
        const auto byte = static_cast<unsigned char>(c);
        result += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
      }
    }
    text.remove_prefix(next.size());
  }
  return result;
}

}  // namespace dupin
