#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_stream.h"
#include "dupin/io/processes.h"
#include "dupin/kernel/rounding.h"

namespace dupin {

/// VTK XML of unstructured grids in several files and one that lists them, which is written only:
/// not among mesh_formats().
extern const MeshFormat kPvtu;

/// Whether a file of this name is one that the file `pvtu` may list: NAME_0.vtu of NAME.pvtu.
[[nodiscard]] bool is_listed_name(std::string_view name, const std::filesystem::path& pvtu);

/// Whether solids can be written one after the other: binary STL, binary PLY and kPvtu.
[[nodiscard]] bool is_streamed(const MeshFormat& format);

/// A piece that gives back the very numbers and neighbours that rounding has proved, or
/// Error{unroundable} is thrown, as by write_verified(), naming `file`.
[[nodiscard]] MeshPiece mesh_piece(const Rounded& solid, const MeshFormat& format,
                                   std::string_view file);

/// The piece of this mesh without these of its triangles, ascending, the only ones with labels of
/// these names: ends at which it goes on in others.
[[nodiscard]] MeshPiece without(MeshPiece piece, const TriMesh& mesh, const MeshFormat& format,
                                std::span<const std::uint32_t> triangles,
                                std::span<const std::string> names);

/// `format` is streamed. Of kPvtu, `NAME.pvtu` lists `NAME_0.vtu` and so on, which have the
/// triangles with the cell data of vtu_text(), labels being numbered alike in all, and of a border
/// of two pieces its points once in each file; if a file cannot take its place, none is left.
/// Several processes that write it make it all at once; files of kPvtu are written by the process
/// that has their pieces.
[[nodiscard]] std::unique_ptr<MeshStream> mesh_stream(const std::filesystem::path& path,
                                                      const MeshFormat& format,
                                                      const Processes* processes = nullptr);

}  // namespace dupin
