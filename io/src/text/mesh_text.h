#pragma once

// Text: what the mesh formats share when they read and write characters and bytes.
//
// Reading goes token by token over bytes that are all in memory (text_scanner.h), knows the place
// of every fault as "file:line", and takes decimals to the nearest double (plain_decimal.h, after
// Lemire, "Number parsing at a gigabyte per second", 2021). Writing is deterministic: the shortest
// decimals that read back (dupin/kernel/decimal.h), -0 as 0, names as valid UTF-8 (Unicode 15,
// table 3-7). Polygons are cut by exact predicates (polygon.h), equal corners become one point
// (point_merger.h). Nothing here knows a format.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/io/mesh_header.h"
#include "dupin/kernel/coordinates.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/mesh.h"

namespace dupin::text {

/// Appends "x y z", of the shortest decimals.
template <typename Vector>
void append_point(std::string& text, const Vector& point) {
  append_decimal(text, point.x());
  text += ' ';
  append_decimal(text, point.y());
  text += ' ';
  append_decimal(text, point.z());
}

/// The points as the format will hold them, -0 as 0: unchanged for binary64, each coordinate
/// rounded to nearest for binary32.
///
/// Throws Error{invalid_argument} for a mesh that no file can hold: a point that is not finite, an
/// index or label out of range, labels not one per triangle; Error{unroundable} for a point beyond
/// the format's range.
[[nodiscard]] std::vector<Vec3> writable_points(const TriMesh& mesh, Coordinates coordinates);

/// The same of a mesh whose points have triangles, or that has none. Throws Error{invalid_argument}
/// for others, which no reader takes for a surface.
[[nodiscard]] std::vector<Vec3> surface_points(const TriMesh& mesh, Coordinates coordinates);

/// `text` fit for a line of a file and for JSON: valid UTF-8 (other bytes become U+FFFD), control
/// characters become spaces, no blanks around it.
[[nodiscard]] std::string clean_line(std::string_view text);

/// The names as `line` writes them, in formats whose readers know labels by their names: of
/// different names that would be written alike, all but one have a number behind them, "a'b (2)".
/// That one is written as it is, or else the first.
[[nodiscard]] std::vector<std::string> written_names(
    const std::vector<std::string>& names, std::string (*line)(std::string_view) = clean_line);

/// Comment lines that name the writer, the unit and the note, each behind `prefix`.
[[nodiscard]] std::string header_lines(const MeshHeader& header, std::string_view prefix);

/// The unit that such a line states, the whole of it, among the first of a file; empty if none
/// does, or if there is no such unit.
[[nodiscard]] std::string noted_unit(std::string_view bytes, std::string_view prefix);
/// Of formats whose comments begin with "# "; as MeshFormat::unit.
[[nodiscard]] std::string unit_behind_hash(std::string_view bytes, std::string_view file);

/// Triangles by label, in order of the names, each in order of the mesh; one group of all for an
/// unlabelled mesh.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> triangles_by_label(const TriMesh& mesh);

/// Collects labels while a mesh is read; equal names share one label.
class LabelBuilder {
 public:
  /// The label of this name, made if new.
  std::uint32_t label(std::string_view name);
  /// Hands the names to the mesh, whose labels are complete.
  void name_labels(TriMesh& mesh) && { mesh.names = std::move(names_); }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t, std::less<>> labels_;
};

}  // namespace dupin::text
