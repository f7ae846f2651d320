// Manifold's side of the contest (contest.h). Its numbers are doubles from the start, so its
// rounding is no more than handing out the mesh; its result is not checked by anybody.
#include <vector>

#include "contest.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/parallel.h"
#include "manifold_mesh.h"

namespace dupin {
namespace {

class Manifolds {
 public:
  static std::vector<manifold::MeshGL64> prepare(const std::vector<TriMesh>& meshes) {
    std::vector<manifold::MeshGL64> prepared;
    prepared.reserve(meshes.size());
    for (const TriMesh& mesh : meshes) {
      prepared.push_back(bench::manifold_mesh(mesh));
    }
    return prepared;
  }

  void make(const std::vector<manifold::MeshGL64>& meshes) {
    operands_.resize(meshes.size());
    for_each_in_parallel(meshes.size(),
                         [&](std::size_t i) { operands_[i] = manifold::Manifold(meshes[i]); });
  }
  void unite() {
    united_ = manifold::Manifold::BatchBoolean(operands_, manifold::OpType::Add);
    static_cast<void>(united_.NumTri());  // until then it is only asked for
  }
  void round() { mesh_ = united_.GetMeshGL64(); }

  [[nodiscard]] bench::ContestResult describe() const {
    bench::ContestResult result{mesh_.NumTri(), united_.Volume(), bench::manifold_fault(united_)};
    if (result.fault.empty() && !check(bench::tri_mesh(mesh_)).is_solid()) {
      result.fault = "no solid";
    }
    return result;
  }

 private:
  std::vector<manifold::Manifold> operands_;
  manifold::Manifold united_;
  manifold::MeshGL64 mesh_;
};

}  // namespace
}  // namespace dupin

int main(int count, char** arguments) {
  return dupin::bench::contest_main<dupin::Manifolds>(count, arguments);
}
