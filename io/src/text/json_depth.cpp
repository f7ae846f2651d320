#include "text/json_depth.h"

#include <array>

namespace dupin::text {
namespace {

/// Calls visit(i, character) for what is outside of strings, until it says that it has seen enough.
template <class Visit>
void for_each_outside_strings(std::string_view json, const Visit& visit) {
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      i += c == '\\' ? 1 : 0;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (visit(i, c)) {
      return;
    }
  }
}

}  // namespace

std::optional<std::size_t> first_too_deep(std::string_view json) {
  std::optional<std::size_t> found;
  int depth = 0;
  for_each_outside_strings(json, [&](std::size_t i, char c) {
    depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
    if (depth > kDeepestJson) {
      found = i;
    }
    return found.has_value();
  });
  return found;
}

bool has_more_keys(std::string_view json, std::size_t most) {
  std::array<std::size_t, kDeepestJson + 1> keys{};  // of the objects that are open, by depth
  std::size_t depth = 0;
  bool has_more = false;
  for_each_outside_strings(json, [&](std::size_t /*i*/, char c) {
    if ((c == '{' || c == '[') && depth < kDeepestJson) {
      keys.at(++depth) = 0;
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    } else if (c == ':') {
      has_more = ++keys.at(depth) > most;
    }
    return has_more;
  });
  return has_more;
}

}  // namespace dupin::text
