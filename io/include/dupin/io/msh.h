#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/io/volume_file.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/volume_mesh.h"

namespace dupin {

/// Reads the surface of a gmsh mesh, MSH 2.2 in text: triangles and quadrangles of the first order,
/// cut as `read_off` does. Their physical surface names the label, by `$PhysicalNames` or else by
/// its number; files without physical surfaces have no labels. Points, lines and other sections are
/// left out, and tetrahedra with the nodes inside them, where there are triangles as well; other
/// elements are refused, and so are other versions, with how to save this one. Nodes are not
/// merged, and keep their order where there are no tetrahedra.
///
/// `file` is named in errors. Throws Error{parse_failed} with "file:line".
[[nodiscard]] TriMesh read_msh(std::string_view bytes, std::string_view file);

/// MSH 2.2 in text, with the shortest decimals that read back to the same doubles; each label is a
/// physical surface and an elementary one of its own. Names cannot hold `"`, which is written as
/// `'`; of names that are alike then, all but one have a number behind them, "a'b (2)". Unit and
/// note are in a section `$Comments`. Throws Error{invalid_argument} for a non-finite point or a
/// bad index.
[[nodiscard]] std::string msh_text(const TriMesh& mesh, const MeshHeader& header = {});

/// Reads tetrahedra of the first order, and the surface with them.
[[nodiscard]] VolumeMesh read_msh_volume(std::string_view bytes, std::string_view file);

/// The tetrahedra are one physical volume, with the header's name, or "volume"; the surface as
/// above.
[[nodiscard]] std::string msh_volume_text(const VolumeMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kMshSurface;
extern const VolumeFormat kMshVolume;

}  // namespace dupin
