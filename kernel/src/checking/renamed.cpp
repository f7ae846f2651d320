#include "dupin/kernel/renamed.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "mesh/exact_mesh.h"

namespace dupin {

Solid renamed(const Solid& solid, const std::map<std::string, std::string>& names) {
  if (std::ranges::none_of(solid.names(),
                           [&](const std::string& own) { return names.contains(own); })) {
    return solid;
  }
  mesh::ExactMesh mesh = solid.exact();
  std::map<std::string, std::uint32_t> label_of;
  std::vector<std::string> merged;
  std::vector<std::uint32_t> labels;
  labels.reserve(mesh.names.size());
  for (const std::string& own : mesh.names) {
    const auto other = names.find(own);
    const std::string& name = other == names.end() ? own : other->second;
    const auto [entry, is_new] = label_of.try_emplace(name, std::uint32_t(merged.size()));
    if (is_new) {
      merged.push_back(name);
    }
    labels.push_back(entry->second);
  }
  for (std::uint32_t& label : mesh.labels) {
    label = labels[label];
  }
  mesh.names = std::move(merged);
  return Solid(std::make_shared<const mesh::ExactMesh>(std::move(mesh)));
}

}  // namespace dupin
