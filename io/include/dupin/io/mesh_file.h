#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/rounding.h"

namespace dupin {

/// All formats that are read and written.
[[nodiscard]] std::span<const MeshFormat> mesh_formats();

/// The format with this key, such as "stl"; null if there is none.
[[nodiscard]] const MeshFormat* find_mesh_format(std::string_view key);

/// The format to write for a file name, by its extension in any case (.stl and .ply are
/// binary). Throws
/// Error{invalid_argument} naming the known extensions.
[[nodiscard]] const MeshFormat& format_of(const std::filesystem::path& path);

/// The format of a file by its content: that with the strongest evidence, of several the first;
/// without any, that which the extension of `file` names; null if none does.
[[nodiscard]] const MeshFormat* format_of_content(std::string_view bytes, std::string_view file);

/// Reads a mesh whose format is told by its content. Throws Error{io_failed | parse_failed |
/// limit_exceeded}.
[[nodiscard]] TriMesh read_mesh(const std::filesystem::path& path);

/// Reads a mesh from bytes; `file` is the name that errors give. The content decides on the format,
/// then the extension of `file`; where the format is known, call its `read`.
[[nodiscard]] TriMesh read_mesh(std::string_view bytes, std::string_view file);

/// The unit that a mesh file states, as in MeshHeader: 3MF's attribute, or what our own writers
/// note in comments and headers; empty if none. Throws Error{parse_failed} for a broken 3MF or
/// glTF.
[[nodiscard]] std::string mesh_unit(std::string_view bytes, std::string_view file);

/// The bytes of a mesh file; the same mesh always gives the same bytes. Coordinates are rounded to
/// the nearest number the format holds (see `to_mesh` for a rounding that keeps a solid a solid).
/// Throws Error{invalid_argument} for a non-finite point or a bad index, Error{unroundable} for a
/// point beyond the format's range.
[[nodiscard]] std::string mesh_bytes(const TriMesh& mesh, const MeshFormat& format,
                                     const MeshHeader& header = {});

/// Writes `mesh_bytes` aside and renames. Throws also Error{io_failed}.
void write_mesh(const std::filesystem::path& path, const TriMesh& mesh, const MeshFormat& format,
                const MeshHeader& header = {});
/// The same, in the format that the path's extension names.
void write_mesh(const std::filesystem::path& path, const TriMesh& mesh);

/// Like `write_mesh`, but before the file takes its place it is read back from disk, must give the
/// same triangles, and must be a solid by `check` on the numbers read. Returns that check's report;
/// throws Error{unroundable} with the first findings, leaving the old file, otherwise. Tells the
/// stages "write" and "verify", and throws Error{cancelled}.
Report write_verified(const std::filesystem::path& path, const TriMesh& mesh,
                      const MeshFormat& format, const MeshHeader& header = {},
                      const Progress& progress = {});
/// The same, in the format that the path's extension names.
Report write_verified(const std::filesystem::path& path, const TriMesh& mesh);

/// The same promise for a mesh that rounding has proved, at the cost of reading it back: the file
/// must give the very same numbers and neighbours, for which the proof then holds. Throws
/// Error{unroundable} naming the first triangle that differs, as the format holds coarser numbers
/// than the solid was rounded to, and Error{contact} where readers weld what only touches.
void write_verified(const std::filesystem::path& path, const Rounded& rounded,
                    const MeshFormat& format, const MeshHeader& header = {},
                    const Progress& progress = {});

/// `mesh_bytes` that give back the very numbers and neighbours that rounding has proved; throws as
/// `write_verified` does, naming `file`. Tells the same stages.
[[nodiscard]] std::string verified_bytes(std::string_view file, const Rounded& rounded,
                                         const MeshFormat& format, const MeshHeader& header = {},
                                         const Progress& progress = {});

}  // namespace dupin
