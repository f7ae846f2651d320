#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"

namespace dupin::formats {

/// An array of a VTK file in XML: what its element says, and the text in it.
struct VtkArray {
  std::string name, type, format;
  std::string text;
  std::string components = "1";  ///< of each tuple

  /// Whether there is one whole number for each point or cell.
  [[nodiscard]] bool is_of_integers() const;
};

/// How a file has its arrays.
struct VtkEncoding {
  bool is_compressed = false;
  std::size_t header_size = 4;   ///< bytes of the size before each
  bool is_little_endian = true;  ///< what is not text
};

/// The numbers of an array, double or std::int64_t. Throws Error{parse_failed}, without the place.
template <class Number>
[[nodiscard]] std::vector<Number> vtk_numbers(const VtkArray& array, const VtkEncoding& encoding);

/// Appends an array of type double, std::int32_t or std::uint8_t, of little-endian bytes.
template <class Number>
void append_vtk_array(std::string& text, std::string_view attributes, const std::string& bytes);

/// What names begin with, up to their first dots, and which of these each is of.
struct VtkParts {
  explicit VtkParts(const std::vector<std::string>& labels);

  std::vector<std::string> names;
  std::vector<std::int32_t> of_label;
};

/// The names of a mesh's labels and parts, the unit and the note.
void append_vtk_field_data(std::string& text, const TriMesh& mesh, const MeshHeader& header,
                           const VtkParts& parts);

/// Label and part of each triangle of a labelled mesh, and colours if the header has some; then -1,
/// and white, for a number of other cells.
void append_vtk_cell_data(std::string& text, const TriMesh& mesh, const MeshHeader& header,
                          const VtkParts& parts, std::size_t others = 0);

}  // namespace dupin::formats
