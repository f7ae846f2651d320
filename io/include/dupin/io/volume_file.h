#pragma once

#include <span>
#include <string>
#include <string_view>

#include "dupin/io/mesh_header.h"
#include "dupin/kernel/volume_mesh.h"

namespace dupin {

/// A file format that holds meshes of tetrahedra with the triangles around them: one constant per
/// format, beside its writer, listed in `volume_formats`.
struct VolumeFormat {
  std::string_view key;        ///< for command lines: "msh"
  std::string_view name;       ///< for people: "gmsh volume"
  std::string_view extension;  ///< ".msh"
  /// Coordinates are the very doubles. Throws Error{invalid_argument} for a mesh with a non-finite
  /// point or a bad index.
  std::string (*write)(const VolumeMesh& mesh, const MeshHeader& header) = nullptr;
  /// Reads what `write` has written. Throws Error{parse_failed}.
  VolumeMesh (*read)(std::string_view bytes, std::string_view file) = nullptr;
};

[[nodiscard]] std::span<const VolumeFormat> volume_formats();

/// The format with this key, or with this extension in lower case; null if there is none.
[[nodiscard]] const VolumeFormat* find_volume_format(std::string_view key_or_extension);

/// The bytes of a file, which are read back and compared, number by number. Throws
/// Error{unroundable} where they differ.
[[nodiscard]] std::string verified_volume_bytes(const VolumeMesh& mesh, const VolumeFormat& format,
                                                const MeshHeader& header, std::string_view file);

}  // namespace dupin
