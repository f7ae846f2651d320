#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin {

enum class Defect {
  non_finite_point,
  point_out_of_range,  ///< finite, but not is_in_range() (dupin/kernel/coordinates.h)
  bad_index,
  degenerate_face,  ///< repeated index or zero area, exactly
  duplicate_face,   ///< faces whose corners have the same three places, in any order
  boundary_edge,
  non_manifold_edge,
  non_manifold_vertex,
  inconsistent_orientation,  ///< an edge that both its faces run along in the same direction
  self_intersection,
  contact,               ///< coincident vertices or edges of an otherwise closed surface
  inside_out_component,  ///< a shell whose orientation disagrees with its nesting depth
  isolated_point,        ///< not a fault of the solid, but of the file
};

[[nodiscard]] std::string_view name(Defect defect);
/// True for what keeps a mesh from being a solid (contacts and isolated points do not).
[[nodiscard]] bool is_fatal(Defect defect);

struct Finding {
  Defect defect = Defect::boundary_edge;
  std::vector<std::uint32_t> faces;   ///< indices into triangles, ascending
  std::vector<std::uint32_t> points;  ///< indices into points
  Vec3 place = Vec3::Zero();          ///< a point at or near the fault
};

struct ShellReport {
  std::uint32_t first_face = 0;
  std::size_t triangles = 0;
  double volume = 0;  ///< signed; meaningless unless the report is closed()
  int depth = 0;      ///< number of shells around it; 0 unless all are closed and free of faults
  std::int64_t euler_number = 0;  ///< a point at which its faces form two fans counts twice
  friend bool operator==(const ShellReport&, const ShellReport&) = default;
};

/// One sentence without a full stop, with indices, labels and coordinates, for people.
[[nodiscard]] std::string describe(const Finding& finding, const TriMesh& mesh);

/// What `check` found out. Counts are complete; `findings` holds at most CheckOptions::limit per
/// defect.
struct Report {
  std::size_t points = 0, triangles = 0;
  std::vector<Finding> findings;    ///< by defect, then by face
  std::vector<std::size_t> counts;  ///< indexed by Defect
  std::vector<ShellReport> shells;  ///< in order of first face
  std::size_t components = 0;       ///< shells of even depth
  std::int64_t euler_number = 0;
  std::int64_t genus = 0;  ///< meaningless unless closed(), as is the volume
  double volume = 0, area = 0;

  [[nodiscard]] std::size_t count(Defect defect) const {
    return counts.at(static_cast<std::size_t>(defect));
  }
  [[nodiscard]] bool closed() const;    ///< no boundary, non-manifold, or orientation finding
  [[nodiscard]] bool is_solid() const;  ///< no fatal finding
};

struct CheckOptions {
  std::size_t limit = 100;         ///< findings kept per defect
  bool self_intersections = true;  ///< search for them: the costly part
};

/// Every fault of the mesh, by exact predicates on the very coordinates given. Never throws on bad
/// meshes.
[[nodiscard]] Report check(const TriMesh& mesh, const CheckOptions& options = {});

}  // namespace dupin
