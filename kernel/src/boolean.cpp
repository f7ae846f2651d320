#include "dupin/kernel/boolean.h"

#include <map>
#include <utility>

#include "dupin/kernel/error.h"
#include "exact_mesh.h"
#include "pairwise.h"
#include "set_operation.h"
#include "text.h"

namespace dupin {
namespace {

using detail::ExactMesh;

// Copies of the operands with one table of names, and themselves as the sources.
std::vector<ExactMesh> prepared(std::span<const Solid> operands) {
  std::vector<std::string> names;
  std::map<std::string, std::uint32_t> label_of_name;
  const auto label = [&](const std::string& name) {
    const auto [entry, added] = label_of_name.try_emplace(name, names.size());
    if (added) {
      names.push_back(name);
    }
    return entry->second;
  };
  bool any_labels = false;
  for (const Solid& operand : operands) {
    any_labels = any_labels || !operand.labels().empty();
  }
  std::vector<ExactMesh> meshes;
  for (std::uint32_t i = 0; i < operands.size(); ++i) {
    ExactMesh& mesh = meshes.emplace_back(operands[i].exact());
    if (any_labels) {
      std::vector<std::uint32_t> new_labels;
      for (const std::string& name : mesh.names) {
        new_labels.push_back(label(name));
      }
      if (mesh.labels.empty()) {
        mesh.labels.assign(mesh.triangles.size(), label(""));
      } else {
        for (std::uint32_t& old : mesh.labels) {
          old = new_labels[old];
        }
      }
    }
    for (std::uint32_t face = 0; face < mesh.sources.size(); ++face) {
      mesh.sources[face] = {i, face};
    }
  }
  for (ExactMesh& mesh : meshes) {
    mesh.names = names;
  }
  return meshes;
}

Solid combine(detail::SetOperation operation, std::span<const Solid> operands,
              const BooleanOptions& options) {
  ExactMesh result = detail::combine_pairwise(operation, prepared(operands), options.progress);
  if (options.contacts == ContactPolicy::refuse && !result.contacts.empty()) {
    const Contact& first = result.contacts.front();
    throw Error(Errc::contact,
                "the result touches itself in " + std::to_string(result.contacts.size()) +
                    (result.contacts.size() == 1 ? " place" : " places") + ", first at " +
                    detail::text(first.from),
                first.names.empty() ? "" : first.names.front());
  }
  return Solid(std::make_shared<const ExactMesh>(std::move(result)));
}

}  // namespace

Solid unite(std::span<const Solid> operands, const BooleanOptions& options) {
  return combine(detail::SetOperation::unite, operands, options);
}

Solid intersect(std::span<const Solid> operands, const BooleanOptions& options) {
  return combine(detail::SetOperation::intersect, operands, options);
}

Solid subtract(const Solid& from, std::span<const Solid> operands, const BooleanOptions& options) {
  std::vector<Solid> all = {from};
  all.insert(all.end(), operands.begin(), operands.end());
  return combine(detail::SetOperation::subtract, all, options);
}

}  // namespace dupin
