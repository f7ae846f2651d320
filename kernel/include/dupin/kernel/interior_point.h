#pragma once

#include <optional>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// A place for a mesh generator to begin at.
struct InteriorPoint {
  Vec3 place = Vec3::Zero();
  double clearance = 0;  ///< its distance from the surface, rounded
};

/// For each component of the solid, by its lowest triangle, a point in its interior: decided by
/// exact tests on its own coordinates and the mesh's. Of sixteen that lie halfway between opposite
/// places of the surface it is the one with the largest clearance; none for a component so thin
/// that no point of doubles is found in it. O(n) for each of its shells.
[[nodiscard]] std::vector<std::optional<InteriorPoint>> interior_points(const Rounded& solid);

/// How often closed surfaces of finite coordinates wind about the point, exactly: 0 outside. Of a
/// point on a face it says either what is in front of it or what is behind. O(n). Throws as
/// `validate`, and Error{invalid_argument} for a point that is not finite.
[[nodiscard]] int winding_number(const TriMesh& mesh, const Vec3& point);

}  // namespace dupin
