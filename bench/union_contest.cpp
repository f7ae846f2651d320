// Our side of the contest (contest.h): exact solids, their union, and the one rounding.
#include <optional>
#include <vector>

#include "contest.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/rounding.h"

namespace dupin {
namespace {

class Ours {
 public:
  static const std::vector<TriMesh>& prepare(const std::vector<TriMesh>& meshes) { return meshes; }

  void make(const std::vector<TriMesh>& meshes) {
    operands_.resize(meshes.size());
    for_each_in_parallel(meshes.size(),
                         [&](std::size_t i) { operands_[i] = Solid::from(meshes[i]); });
  }
  void unite() {
    clock_.begin("load");
    united_ = dupin::unite(operands_, {.progress = clock_.progress()});
    clock_.end();
  }
  void round() { rounded_ = to_mesh(united_); }

  [[nodiscard]] bench::ContestResult describe() const {
    return {rounded_->mesh().triangles.size(), united_.volume(), {}, clock_.times()};
  }

 private:
  StageClock clock_;
  std::vector<Solid> operands_;
  Solid united_;
  std::optional<Rounded> rounded_;
};

}  // namespace
}  // namespace dupin

int main(int count, char** arguments) {
  return dupin::bench::contest_main<dupin::Ours>(count, arguments);
}
