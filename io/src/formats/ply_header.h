#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/io/mesh_header.h"

namespace dupin::formats {

enum class PlyEncoding { ascii, little_endian, big_endian };

/// The number types of PLY.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
[[nodiscard]] std::size_t size_of(PlyType type);
[[nodiscard]] constexpr bool is_integer(PlyType type) { return type < PlyType::float32; }
[[nodiscard]] constexpr bool is_4_byte_integer(PlyType type) {
  return type == PlyType::int32 || type == PlyType::uint32;
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  ///< of the value or of the list's entries
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::size_t place = 0;  ///< of its line in the header, for errors
  std::vector<PlyProperty> properties;

  /// Bytes that one of them takes at least.
  [[nodiscard]] std::size_t smallest_size(PlyEncoding encoding) const;
};

/// What stands before the numbers of a PLY file.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> label_names;  ///< of comments "label NAME", in order
  std::size_t size = 0;                  ///< bytes up to the first number
};

/// Of vertices of ours: the number of the point that one is.
constexpr std::string_view kPlyPointProperty = "dupin_point";

/// What a file of ours has.
struct PlyContents {
  std::uint64_t vertices = 0, triangles = 0;
  bool has_normals = false, has_copies = false, has_labels = false, has_colours = false;
};

/// What stands before the numbers of a file of ours. Throws Error{limit_exceeded} for 2^31 vertices
/// and more.
[[nodiscard]] std::string ply_header_text(const PlyContents& contents,
                                          const std::vector<std::string>& label_names,
                                          const MeshHeader& header, PlyEncoding encoding);

/// Throws Error{parse_failed} with "file:line".
[[nodiscard]] PlyHeader read_ply_header(std::string_view bytes, std::string_view file);

}  // namespace dupin::formats
