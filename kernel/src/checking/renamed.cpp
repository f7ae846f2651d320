#include "dupin/kernel/renamed.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "mesh/exact_mesh.h"
#include "mesh/united_names.h"

namespace dupin {

Solid renamed(const Solid& solid, const std::map<std::string, std::string>& names) {
  if (std::ranges::none_of(solid.names(),
                           [&](const std::string& own) { return names.contains(own); })) {
    return solid;
  }
  mesh::ExactMesh mesh = solid.exact();
  for (std::string& own : mesh.names) {
    if (const auto other = names.find(own); other != names.end()) {
      own = other->second;
    }
  }
  mesh::unite_names(mesh.names, mesh.labels);
  return Solid(std::make_shared<const mesh::ExactMesh>(std::move(mesh)));
}

}  // namespace dupin
