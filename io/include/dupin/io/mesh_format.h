#pragma once

// Formats: triangle meshes as files. A format is one value of MeshFormat, declared beside its
// reader and writer; mesh_file.cpp lists them, and nothing else knows the list (docs/extending.md).
//
// The specifications: OFF of Geomview; STL of 3D Systems, StereoLithography Interface, 1989, text
// and binary; PLY of Turk, 1994; Wavefront OBJ, its polygons; 3MF core 1.3; glTF 2.0 (ISO/IEC
// 12113), binary. Coordinates are doubles, the nearest to what a file says, or binary32 where a
// format holds no more; -0 becomes 0; a label is a name that faces share, by whatever the format
// has for it: a group, a block, a material. Readers refuse what is malformed with its line or byte.

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
  first_word,      ///< text begins with one of the words that such files begin with
  text_signature,  ///< text begins as only such files do, and headers of free text may
  size,            ///< the bytes are exactly as many as they themselves say
  signature,       ///< the bytes that only such files begin with
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
  /// It writes MeshHeader::normals.
  bool has_normals = false;

  TriMesh (*read)(std::string_view bytes, std::string_view file) = nullptr;
  std::string (*write)(const TriMesh& mesh, const MeshHeader& header) = nullptr;
  Evidence (*recognises)(std::string_view bytes) = nullptr;
  /// The unit that a file states, as `mesh_unit`.
  std::string (*unit)(std::string_view bytes, std::string_view file) = nullptr;

  friend bool operator==(const MeshFormat& a, const MeshFormat& b) { return a.key == b.key; }
};

}  // namespace dupin
