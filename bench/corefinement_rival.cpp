#include "corefinement_rival.h"

#include "cross_check/pairwise.h"

namespace dupin::bench {

void unite_by_corefinement(const std::vector<Solid>& operands) {
  std::vector<mesh::ExactMesh> meshes;
  for (const Solid& operand : operands) {
    meshes.push_back(operand.exact());
  }
  (void)cross_check::combine_pairwise(cross_check::SetOperation::unite, std::move(meshes), {});
}

}  // namespace dupin::bench
