#pragma once

#include <array>
#include <cstdint>

#include "dupin/kernel/mesh.h"
#include "remeshing/reference_surface.h"
#include "remeshing/size_field.h"
#include "remeshing/working_mesh.h"

namespace dupin::remeshing {

/// What steps of remeshing work on.
struct Workshop {
  WorkingMesh& mesh;
  const Features& features;
  const ReferenceSurface& reference;
  const SizeField& field;
  SizeLimits limits;
  double least_sine = 0;  ///< of the smallest angle that is asked for
};

/// The sine of the smallest angle of a triangle; 0 if it is degenerate.
[[nodiscard]] double smallest_sine(const std::array<Vec3, 3>& triangle);
[[nodiscard]] double smallest_sine(const WorkingMesh& mesh, std::uint32_t face);
/// Of all faces at a point.
[[nodiscard]] double smallest_sine_around(const WorkingMesh& mesh, std::uint32_t point);

/// An edit that has not been made yet, to be looked at.
class EditCheck {
 public:
  EditCheck(const Workshop& shop, const Edit& edit) : shop_(shop), edit_(edit) {}

  [[nodiscard]] double smallest_sine() const;
  /// The largest ratio of a new edge's length to the wanted one, and that of the edges before.
  [[nodiscard]] double longest_edge_ratio() const;
  [[nodiscard]] double longest_edge_ratio_before() const;
  /// Whether the new faces face the way that the old ones did, region by region.
  [[nodiscard]] bool keeps_sides() const;
  /// Whether points of the new faces are near the surface; a look, not a proof.
  [[nodiscard]] bool stays_near() const;

 private:
  [[nodiscard]] Vec3 place(std::uint32_t v) const;
  [[nodiscard]] std::array<Vec3, 3> places(const Face& face) const;

  const Workshop& shop_;
  const Edit& edit_;
};

}  // namespace dupin::remeshing
