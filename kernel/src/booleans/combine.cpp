#include "booleans/combine.h"

#include <string>
#include <vector>

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

}  // namespace

mesh::ExactMesh combine(std::span<const Solid> operands, const arrangement::BooleanRule& rule,
                        const BooleanOptions& options) {
  std::vector<const mesh::ExactMesh*> meshes;
  meshes.reserve(operands.size());
  for (const Solid& operand : operands) {
    meshes.push_back(&operand.exact());
  }
  mesh::ExactMesh result =
      arrangement::arrange(meshes, rule, options.progress, options.memory_limit);
  if (options.contacts == ContactPolicy::refuse) {
    refuse_contacts(result);
  }
  return result;
}

}  // namespace dupin::booleans
