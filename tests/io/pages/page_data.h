#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace dupin::test {

/// The data that a report page holds.
inline nlohmann::json page_data(const std::string& html) {
  constexpr std::string_view kOpen = "<script id=\"data\" type=\"application/json\">";
  const std::size_t begin = html.find(kOpen) + kOpen.size();
  return nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

inline std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) {
    ++count;
  }
  return count;
}

}  // namespace dupin::test
