#include "dupin/kernel/boolean.h"

#include <vector>

#include "combine.h"
#include "dupin/kernel/error.h"
#include "exact_mesh.h"
#include "text.h"

namespace dupin {
namespace {

using detail::ExactMesh;

void refuse_contacts(const ExactMesh& result) {
  if (result.contacts.empty()) {
    return;
  }
  const Contact& first = result.contacts.front();
  throw Error(Errc::contact,
              "the result touches itself in " + std::to_string(result.contacts.size()) +
                  (result.contacts.size() == 1 ? " place" : " places") + ", first at " +
                  detail::text(first.from),
              first.names.empty() ? "" : first.names.front());
}

}  // namespace

Solid detail::combine(std::span<const Solid> operands, const BooleanRule& rule,
                      const BooleanOptions& options) {
  std::vector<const ExactMesh*> meshes;
  for (const Solid& operand : operands) {
    meshes.push_back(&operand.exact());
  }
  ExactMesh result = arrange(meshes, rule, options.progress, options.memory_limit);
  if (options.contacts == ContactPolicy::refuse) {
    refuse_contacts(result);
  }
  return Solid(std::make_shared<const ExactMesh>(std::move(result)));
}

Solid unite(std::span<const Solid> operands, const BooleanOptions& options) {
  return detail::combine(operands, detail::union_rule(operands.size()), options);
}

Solid intersect(std::span<const Solid> operands, const BooleanOptions& options) {
  return detail::combine(operands, detail::intersection_rule(operands.size()), options);
}

Solid subtract(const Solid& from, std::span<const Solid> operands, const BooleanOptions& options) {
  std::vector<Solid> all = {from};
  all.insert(all.end(), operands.begin(), operands.end());
  return detail::combine(all, detail::difference_rule(all.size()), options);
}

}  // namespace dupin
