#pragma once

#include "dupin/kernel/solid.h"
#include "dupin/kernel/solver_mesh.h"

namespace dupin {

struct Remeshed {
  Solid solid;  ///< labelled as the one given
  RemeshReport report;
};

/// A mesh of well-shaped triangles for the same solid: what generators of volume meshes take.
/// Points are new, but for the ends of sharp edges and of borders between labels; these are kept as
/// curves that edges run along. The triangles are those between inside and outside of a Delaunay
/// tetrahedrisation that is refined until they are small, near and well-shaped enough (CGAL's
/// Mesh_3); points are then moved along the surface where angles beside sharp edges are poor.
/// Distances are proved at the end, both ways, and that the surface does not meet itself is proved
/// anew, as by `Solid::from`. The same input gives the same mesh, and one thread makes it: some
/// 10 000 triangles a second.
/// Throws Error{invalid_argument} for options outside their range, Error{contact} for a solid that
/// touches itself, Error{limit_exceeded} where lengths and distances ask for too many points,
/// Error{unroundable} as `to_mesh`, or, never giving a worse mesh, where the distance cannot be
/// kept, and Error{cancelled}.
[[nodiscard]] Remeshed remesh(const Solid& solid, const RemeshOptions& options);

}  // namespace dupin
