#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "dupin/io/mesh_header.h"
#include "dupin/kernel/coordinates.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// What tells a format that bytes are of its kind, from the weakest to the strongest; of
/// several formats, the one with the strongest takes the file.
enum class Evidence : std::uint8_t {
  none,
  first_word,  ///< text begins with one of the words that such files begin with
  size,        ///< the bytes are exactly as many as they themselves say
  signature,   ///< the bytes that only such files begin with
};

/// A file format that holds meshes, and all that there is to know about it: one constant per
/// format, beside its reader and writer (kOff in dupin/io/off.h), listed in `mesh_formats`.
struct MeshFormat {
  std::string_view key;        ///< for command lines: "stl-ascii"
  std::string_view name;       ///< for people: "ASCII STL"
  std::string_view extension;  ///< ".stl" where it chooses this format to write, or empty
  /// What the numbers can hold. Text STL is binary32: it must read alike for readers that store
  /// floats.
  Coordinates coordinates = Coordinates::binary64;
  /// Its readers make one point of all corners at one place, for the format has no indices.
  bool merges_points = false;

  TriMesh (*read)(std::string_view bytes, std::string_view file) = nullptr;
  std::string (*write)(const TriMesh& mesh, const MeshHeader& header) = nullptr;
  Evidence (*recognises)(std::string_view bytes) = nullptr;
  /// The unit that a file states, as `mesh_unit`.
  std::string (*unit)(std::string_view bytes, std::string_view file) = nullptr;

  friend bool operator==(const MeshFormat& a, const MeshFormat& b) { return a.key == b.key; }
};

}  // namespace dupin
