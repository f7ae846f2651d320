#pragma once

#include <string>

#include "dupin/io/mesh_header.h"
#include "dupin/kernel/rounding.h"

namespace dupin {

/// What a mesh generator is told of a solid that was written to `file`:
/// `{"file", "unit", "origin", "area", "patches": [...], "components": [...]}`, of patches
/// `{"name", "triangles", "area", "centroid", "vector_area", "normal"}`, of components
/// `{"inside", "clearance"}`. Coordinates are the file's, from which `origin` was subtracted;
/// patches are by name as in the mesh, `normal` is the direction of the vector area, null where
/// that is zero, and so is an inside that was not found. docs/cli.md says more.
[[nodiscard]] std::string patches_json(const Rounded& solid, const std::string& file,
                                       const MeshHeader& header);

}  // namespace dupin
