#include "text/utf16.h"

#include <cstddef>

#include "dupin/kernel/error.h"

namespace dupin::text {
namespace {

// Of a text that is not in Latin letters only, the first words still are.
constexpr std::size_t kHead = 32, kLeast = 4;

}  // namespace

bool is_utf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    return true;
  }
  const std::string_view head = bytes.substr(0, kHead);
  if (head.size() < kLeast || (head[0] == '\0') == (head[1] == '\0')) {
    return false;
  }
  const std::size_t zero = head[0] == '\0' ? 0 : 1;
  for (std::size_t i = 0; i < head.size(); ++i) {
    if ((head[i] == '\0') != (i % 2 == zero)) {
      return false;
    }
  }
  return true;
}

void refuse_utf16(std::string_view bytes, const std::string& file) {
  if (is_utf16(bytes)) {
    throw Error(Errc::parse_failed, "the text is in UTF-16, expected UTF-8; save it as that", {},
                file);
  }
}

}  // namespace dupin::text
