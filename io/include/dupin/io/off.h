#pragma once

#include <string>
#include <string_view>

#include "dupin/io/mesh_format.h"
#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// Reads Geomview's OFF: keyword OFF with any of the prefixes ST, C and N, comments, blank lines,
/// counts on the line of the keyword or after it, any line ends. The corners of a face may run over
/// several lines, its colour ends with the last one's. Colours, normals and texture coordinates are
/// skipped, whatever numbers they are; points keep their order and are not merged; -0 becomes 0.
/// Points without any face are refused.
///
/// A face of more than three corners is cut into triangles by clipping ears, decided by exact
/// predicates in the coordinate plane it is least inclined to: correct for every simple planar
/// polygon, convex or not. A polygon that crosses itself is cut into as many triangles all the
/// same; `check` finds the fault.
///
/// `file` is named in errors. Throws Error{parse_failed} with "file:line", and
/// Error{limit_exceeded} for a face of more than 20 000 corners.
[[nodiscard]] TriMesh read_off(std::string_view bytes, std::string_view file);

/// OFF with the shortest decimals that read back to the same doubles. Labels are not kept: the
/// format has no place for them. Throws Error{invalid_argument} for a non-finite point or a bad
/// index.
[[nodiscard]] std::string off_text(const TriMesh& mesh, const MeshHeader& header = {});

extern const MeshFormat kOff;

}  // namespace dupin
