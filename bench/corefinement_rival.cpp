#include "corefinement_rival.h"

#include "pairwise.h"

namespace dupin::bench {

void unite_by_corefinement(const std::vector<Solid>& operands) {
  std::vector<detail::ExactMesh> meshes;
  for (const Solid& operand : operands) {
    meshes.push_back(operand.exact());
  }
  (void)detail::combine_pairwise(detail::SetOperation::unite, std::move(meshes), {});
}

}  // namespace dupin::bench
