#pragma once

#include "dupin/kernel/remesh.h"
#include "remeshing/features.h"
#include "remeshing/working_mesh.h"

namespace dupin::remeshing {

/// The triangles of a mesh with an angle below a bound.
class PoorTriangles {
 public:
  /// Refers to the mesh. `narrow`: sharp edges that are nearer to each other leave no room.
  PoorTriangles(const WorkingMesh& mesh, const Features& features, double angle, double narrow);

  /// What there is of angles and edges.
  [[nodiscard]] RemeshReport report() const;

 private:
  [[nodiscard]] bool is_confined(std::uint32_t face) const;
  [[nodiscard]] bool has_narrow_corner(std::uint32_t face, int corner) const;
  [[nodiscard]] bool is_in_strait(std::uint32_t face) const;

  const WorkingMesh& mesh_;
  const Features& features_;
  double angle_, narrow_;
};

}  // namespace dupin::remeshing
