#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// True when there are exactly as many bytes as the count in byte 80 demands of a binary STL.
[[nodiscard]] bool has_size_of_binary_stl(std::string_view bytes);

/// Tells the two kinds of STL apart, whatever the first word: binary if the size fits, or if the
/// bytes do not begin like text.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);

/// Reads STL as text: any number of `solid NAME` blocks, whose names become labels (a single block
/// without a name gives an unlabelled mesh; among several, an unnamed one is called "solid N").
/// Coordinates are the doubles nearest to the decimals. Corners with equal coordinates become one
/// point, in order of first appearance; -0 becomes 0. Normals are skipped.
///
/// Throws Error{parse_failed} with "file:line".
[[nodiscard]] TriMesh read_stl_ascii(std::string_view bytes, std::string_view file);

/// Reads STL as bytes; merges points as `read_stl_ascii`. A header that holds "solid NAME" labels
/// the mesh. Throws Error{parse_failed} with "file:byte N".
[[nodiscard]] TriMesh read_stl_binary(std::string_view bytes, std::string_view file);

/// STL text, one block per label in the order of the names; it has no place for units. Every
/// coordinate is rounded to the nearest binary32 number and printed with the shortest decimal that
/// is this number both as binary32 and as binary64, so that readers of either kind find the same
/// mesh.
///
/// Throws Error{invalid_argument} for a non-finite point or a bad index, Error{unroundable} for a
/// point beyond binary32.
[[nodiscard]] std::string stl_ascii_text(const TriMesh& mesh);

/// Binary STL. The 80 bytes of header hold unit and note and, if the mesh has just one label, its
/// name, as far as there is room; several labels are not kept. Throws like `stl_ascii_text`.
[[nodiscard]] std::string stl_binary_bytes(const TriMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kStlAscii, kStlBinary;

}  // namespace dupin
