#pragma once

#include "boxes/box_tree.h"
#include "gaps/mesh_pair.h"

namespace dupin::gaps {

/// Finds the faces of the second mesh of a pair near a face of the first by their boxes. Faces
/// without area are left out. The pair outlives it.
class FaceBoxIndex {
 public:
  explicit FaceBoxIndex(const MeshPair& pair);

  /// Calls visit(face of b) at least for all faces whose distance from face `a` is at most `reach`.
  template <class Visit>
  void visit_near(std::uint32_t a, double reach, Visit&& visit) const {
    if (pair_.flat[a] == 0) {
      tree_.visit(around(a, reach), [&](std::uint32_t item) { visit(pair_.faces_of_a + item); });
    }
  }

 private:
  [[nodiscard]] boxes::Box around(std::uint32_t face, double reach) const;
  [[nodiscard]] std::vector<boxes::Box> boxes_of_b() const;

  const MeshPair& pair_;
  boxes::BoxQuantizer frame_;
  Vec3 low_, high_;  // of all points
  boxes::BoxTree tree_;
};

}  // namespace dupin::gaps
