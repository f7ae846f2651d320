#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"

namespace dupin {

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

/// One for each label that triangles carry, in the order of the mesh's names. O(n).
[[nodiscard]] std::vector<Patch> patches_of(const TriMesh& mesh);

/// The solid with other names for its labels, by their own; labels of one name become one. O(n).
[[nodiscard]] Solid renamed(const Solid& solid, const std::map<std::string, std::string>& names);

}  // namespace dupin
