#include "pages/page_parts.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace dupin::pages {

std::vector<PagePart> page_parts(const TriMesh& mesh, const std::vector<PagePart>& named) {
  std::vector<PagePart> parts = named;
  std::map<std::string, std::size_t, std::less<>> by_name;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    by_name.emplace(parts[i].name, i);
  }
  const auto owner = [&by_name](std::string_view label) {
    for (;;) {
      if (const auto found = by_name.find(label); found != by_name.end()) {
        return found;
      }
      const std::size_t dot = label.rfind('.');
      if (dot == std::string_view::npos) {
        return by_name.end();
      }
      label = label.substr(0, dot);
    }
  };
  std::vector<bool> is_used(mesh.names.size(), false);
  for (const std::uint32_t label : mesh.labels) {
    is_used.at(label) = true;
  }
  for (std::uint32_t label = 0; label < mesh.names.size(); ++label) {
    const std::string& name = mesh.names[label];
    if (const auto found = owner(name); found != by_name.end()) {
      parts[found->second].labels.push_back(label);
    } else if (is_used[label] || parts.empty()) {
      parts.push_back({name.empty() ? "(no name)" : name, "", "", {}, {label}});
    } else {
      parts.front().labels.push_back(label);  // of nothing, and nobody's
    }
  }
  if (mesh.names.empty()) {
    parts.push_back({"mesh", "", "", {}, {0}});
  }
  return parts;
}

}  // namespace dupin::pages
