#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "formats/glb_document.h"
#include "formats/placed_mesh.h"

namespace dupin::formats {

/// A mesh where a node shows it.
struct MeshInstance {
  std::size_t mesh = 0;  ///< of the document's
  std::string name;      ///< of the node, or of the mesh; may be empty
  Transform transform;   ///< to the scene's coordinates
};

/// Whether our writer made the document: one root node, which alone turns and scales.
[[nodiscard]] bool is_ours(const GlbDocument& document);

/// All meshes that the document's scene shows, node by node in the order of the file. Without a
/// scene, those of all nodes that are no other's child; without nodes, every mesh, as it is. The
/// turn and scale of the root node that our writer makes are left out.
///
/// Throws Error{parse_failed} with the place where nodes are no forest, a transformation is none,
/// or no mesh is shown: but for what our writer makes of a mesh without triangles.
[[nodiscard]] std::vector<MeshInstance> shown_meshes(const GlbDocument& document);

}  // namespace dupin::formats
