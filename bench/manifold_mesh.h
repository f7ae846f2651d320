#pragma once

#include <string>

#include <manifold/manifold.h>

#include "dupin/kernel/mesh.h"

namespace dupin::bench {

[[nodiscard]] manifold::MeshGL64 manifold_mesh(const TriMesh& mesh);
[[nodiscard]] TriMesh tri_mesh(const manifold::MeshGL64& mesh);

/// What Manifold says of a solid; empty if nothing is wrong.
[[nodiscard]] std::string manifold_fault(const manifold::Manifold& solid);

}  // namespace dupin::bench
