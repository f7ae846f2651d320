#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"
#include "dupin/kernel/solver_mesh.h"
#include "mesh/surface_distance.h"
#include "meshing/angle_improvement.h"
#include "meshing/features.h"

namespace dupin::meshing {

/// What a mesh for solvers is made of. Refers to the solid.
class GivenSolid {
 public:
  GivenSolid(const Solid& solid, const RemeshOptions& options);
  GivenSolid(const GivenSolid&) = delete;
  GivenSolid& operator=(const GivenSolid&) = delete;

  [[nodiscard]] const RemeshOptions& options() const { return options_; }
  [[nodiscard]] const TriMesh& mesh() const { return mesh_; }
  [[nodiscard]] const Features& features() const { return features_; }
  [[nodiscard]] const mesh::ReferenceSurface& surface() const { return surface_; }
  [[nodiscard]] std::uint32_t region_count() const { return region_count_; }
  [[nodiscard]] double largest_edge() const { return largest_edge_; }
  /// Of its box.
  [[nodiscard]] double diagonal() const { return diagonal_; }
  [[nodiscard]] double area() const;
  /// More than what rounding makes distances too small by.
  [[nodiscard]] double slack() const { return slack_; }

  /// Whether a solid has as many shells and handles.
  [[nodiscard]] bool hangs_together_as(const Solid& other) const;

  /// Gives the triangles of a mesh the labels of their regions.
  void label(TriMesh& mesh, const std::vector<std::uint32_t>& regions) const;

  /// Of a mesh with a region at each triangle, all but the deviation.
  [[nodiscard]] RemeshReport report_of(const TriMesh& mesh,
                                       const std::vector<std::uint32_t>& regions) const;

  /// What moves of points keep to.
  [[nodiscard]] MoveLimits move_limits() const;

  /// Along curves; with more of them, there would be none for what is between.
  [[nodiscard]] std::size_t most_points_on_curves() const;

  /// What is said of a triangle that is too far off, of edges that are too long, of sides of the
  /// solid that a mesh does not tell apart, and of a generator that makes nothing.
  [[nodiscard]] std::string too_far(const std::array<Vec3, 3>& triangle) const;
  [[nodiscard]] std::string too_long() const;
  /// Of sides that cross each other in the mesh.
  [[nodiscard]] std::string too_thin(const Vec3& place, double thickness) const;
  [[nodiscard]] static std::string no_mesh(const std::optional<Vec3>& place = {});

 private:
  const Solid& solid_;
  TriMesh mesh_;
  RemeshOptions options_;  // no lengths are larger than the solid
  double diagonal_, largest_edge_;
  Features features_;
  mesh::ReferenceSurface surface_;
  std::uint32_t region_count_ = 0;
  double slack_ = 0;
};

}  // namespace dupin::meshing
