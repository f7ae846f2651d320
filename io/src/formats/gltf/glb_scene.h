#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "formats/gltf/glb_document.h"
#include "formats/placed_mesh.h"

namespace dupin::formats {

/// A mesh where a node shows it.
struct MeshInstance {
  std::size_t mesh = 0;  ///< of the document's
  std::string name;      ///< of the node, or of the mesh; may be empty
  Transform transform;   ///< to the scene's coordinates
};

/// Throws Error{parse_failed} if a node or mesh shows other shapes added to its own.
void require_no_weights(const GlbDocument& document, const GlbDocument::Json& json,
                        const std::string& place);

/// Whether our writer is said to have made the document, whatever others did to it since.
[[nodiscard]] bool names_our_writer(const GlbDocument& document);

/// Whether the nodes are those that our writer makes: one root, which alone turns, and scales by
/// the unit that `asset.extras` has, so that the meshes' own coordinates are in that unit.
[[nodiscard]] bool is_ours(const GlbDocument& document);
/// That unit; empty if none.
[[nodiscard]] std::string noted_unit(const GlbDocument& document);

/// All meshes that the document's scene shows, node by node in the order of the file. Without a
/// scene, those of all nodes that are no other's child; without nodes, every mesh, as it is. The
/// turn and scale of the root node are left out of what is ours.
///
/// Throws Error{parse_failed} with the place where nodes are no forest, a transformation is none,
/// what is shown is not the mesh itself (skins, instances of an extension), or no mesh is shown:
/// but for what our writer makes of a mesh without triangles.
[[nodiscard]] std::vector<MeshInstance> shown_meshes(const GlbDocument& document);

}  // namespace dupin::formats
