#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin {

/// Throws Error{invalid_argument} for corners of no point, and for labels that are not one for each
/// triangle or have no name. O(n).
void require_indices(const TriMesh& mesh);
/// The same, and for coordinates that are not finite.
void validate(const TriMesh& mesh);

/// The triangles of a mesh that carry one label. Measured in doubles; lengths are the mesh's.
struct Patch {
  std::string name;  ///< empty where nothing is labelled
  std::size_t triangles = 0;
  double area = 0;
  Vec3 centroid = Vec3::Zero();  ///< of the area
  /// The integral of the outward normals. Its length is `area` for a flat patch, such as an open
  /// end, and 0 for one without a rim.
  Vec3 vector_area = Vec3::Zero();
};

/// One for each label that triangles carry, in the order of the mesh's names. O(n). Throws as
/// `require_indices`.
[[nodiscard]] std::vector<Patch> patches_of(const TriMesh& mesh);

}  // namespace dupin
