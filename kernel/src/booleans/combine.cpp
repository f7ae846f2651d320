#include "booleans/combine.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "booleans/union_in_steps.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "mesh/exact_mesh.h"

namespace dupin::booleans {
namespace {

void refuse_contacts(const mesh::ExactMesh& result) {
  if (result.contacts.empty()) {
    return;
  }
  const Contact& first = result.contacts.front();
  throw Error(Errc::contact,
              "the result touches itself in " + std::to_string(result.contacts.size()) +
                  (result.contacts.size() == 1 ? " place" : " places") + ", first at " +
                  decimal(first.from),
              first.names.empty() ? "" : first.names.front());
}

std::vector<const mesh::ExactMesh*> meshes_of(std::span<const Solid> operands) {
  std::vector<const mesh::ExactMesh*> meshes;
  meshes.reserve(operands.size());
  for (const Solid& operand : operands) {
    meshes.push_back(&operand.exact());
  }
  return meshes;
}

mesh::ExactMesh with_policies(mesh::ExactMesh result, const BooleanOptions& options) {
  if (options.contacts == ContactPolicy::refuse) {
    refuse_contacts(result);
  }
  return result;
}

}  // namespace

mesh::ExactMesh combine(std::span<const Solid> operands, const arrangement::BooleanRule& rule,
                        const BooleanOptions& options) {
  return with_policies(
      arrangement::arrange(meshes_of(operands), rule, options.progress, options.memory_limit),
      options);
}

mesh::ExactMesh combine_in_union(std::span<const Solid> operands, const BooleanOptions& options) {
  if (std::optional<mesh::ExactMesh> united = unite_close_fan(operands, options)) {
    return with_policies(*std::move(united), options);
  }
  std::optional<mesh::ExactMesh> at_once = arrangement::arrange_unless_crowded(
      meshes_of(operands), arrangement::union_rule(operands.size()), options.progress,
      options.memory_limit);
  return with_policies(at_once ? *std::move(at_once) : unite_in_steps(operands, options), options);
}

}  // namespace dupin::booleans
