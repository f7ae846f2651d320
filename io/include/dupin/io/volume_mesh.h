#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// Tetrahedra that fill a solid, and the triangles around it.
struct VolumeMesh {
  std::vector<Vec3> points;  ///< those of the surface first, unchanged
  /// Positively oriented: seen from the last corner's opposite side, the first three run clockwise.
  std::vector<std::array<std::uint32_t, 4>> tetrahedra;
  TriMesh surface;  ///< without points of its own: indices are into `points`
};

/// How the tetrahedra came out.
struct VolumeMeshReport {
  std::size_t points = 0, tetrahedra = 0, triangles = 0;
  double volume = 0;
  double smallest_dihedral_angle = 0;  ///< in radians
  std::size_t flat_tetrahedra = 0;     ///< with a dihedral angle below 5 degrees
};

/// Whether this build knows a generator, and the machine has it: the library of gmsh, which is
/// loaded when it is first asked for.
[[nodiscard]] bool has_volume_mesher();

/// Tetrahedra between the triangles of a solid's mesh, which stay as they are; their size follows
/// from that of the triangles around. Made by gmsh [Geuzaine and Remacle, Gmsh: a 3-D finite
/// element mesh generator with built-in pre- and post-processing facilities, 2009], in one thread,
/// and taken only if `check_volume_mesh` finds nothing. One call at a time does its work. Throws
/// Error{invalid_argument} where there is no generator, and Error{boolean_failed} with gmsh's words
/// where it gives up.
[[nodiscard]] VolumeMesh fill_with_tetrahedra(const TriMesh& surface);

/// Establishes, by signs of exact volumes, that no tetrahedron is flat or inside out, that each of
/// their faces is shared by two from opposite sides or is a triangle of the surface, and that all
/// these are used once: so the tetrahedra fill what the surface bounds, once. Throws
/// Error{boolean_failed}.
VolumeMeshReport check_volume_mesh(const VolumeMesh& mesh);

/// MSH 2.2, as gmsh, OpenFOAM (gmshToFoam) and others read it: one physical surface for each patch,
/// by its name, and one physical volume.
[[nodiscard]] std::string msh_text(const VolumeMesh& mesh, std::string_view volume_name);

/// VTK's XML of an unstructured grid: tetrahedra and triangles, with the cell array `patch`, 0 for
/// tetrahedra and i + 1 for the patch with the i-th of the field array `patch_names`.
[[nodiscard]] std::string vtu_text(const VolumeMesh& mesh, std::string_view volume_name);

}  // namespace dupin
