#include "dupin/kernel/fill.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "meshing/angle_improvement.h"
#include "meshing/solver_mesh_maker.h"

namespace dupin {
namespace {

/// A triangle beginning with its lowest corner, turned as it was.
Triangle from_lowest(Triangle triangle) {
  std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
  return triangle;
}

/// Throws unless all tetrahedra are positive, and their faces cancel but for the surface. As that
/// is the boundary of a solid, each place in it is then in as many tetrahedra as the surface winds
/// around it: one.
void prove_tiling(const VolumeMesh& mesh) {
  std::vector<Triangle> faces, turned;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    if (!meshing::is_positive(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]),
                              mesh.point(t[3]))) {
      throw Error(Errc::internal, "internal error, please report it: a tetrahedron is turned over");
    }
    for (const Triangle& face : meshing::faces_of(t)) {
      faces.push_back(from_lowest(face));
      turned.push_back(from_lowest({face[0], face[2], face[1]}));
    }
  }
  for (const Triangle& face : mesh.surface.triangles) {
    turned.push_back(from_lowest(face));
  }
  for (const Triangle& face : mesh.surface.triangles) {
    faces.push_back(from_lowest({face[0], face[2], face[1]}));
  }
  std::ranges::sort(faces);
  std::ranges::sort(turned);
  if (faces != turned) {
    throw Error(Errc::internal, "internal error, please report it: tetrahedra do not fit together");
  }
}

}  // namespace

Filled fill(const Solid& solid, const RemeshOptions& options) {
  const UsualArithmetic usual;
  meshing::SolverMesh made = meshing::make_solver_mesh(solid, options, true);
  if (made.surface.empty()) {
    return {};
  }
  Filled filled{std::move(made.mesh), std::move(made.report), std::numbers::pi};
  const VolumeMesh& mesh = filled.mesh;
  prove_tiling(mesh);
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    filled.smallest_dihedral_angle =
        std::min(filled.smallest_dihedral_angle,
                 meshing::smallest_dihedral_angle(
                     {mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d)}));
  }
  return filled;
}

}  // namespace dupin
