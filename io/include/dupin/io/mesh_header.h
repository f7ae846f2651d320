#pragma once

#include <map>
#include <string>

#include "dupin/kernel/crease.h"

namespace dupin {

/// What a mesh file may say besides the geometry. Control characters are written as spaces.
struct MeshHeader {
  std::string unit;  ///< of the coordinates: "mm", "cm", "m", "in", "ft", or empty when unknown
  std::string note;  ///< free text of one line, e.g. where the origin lies
  std::string name = {};  ///< of the solid, where the format has objects; may be empty
  /// "#rrggbb" of labels; a name also stands for those that begin with it and a dot. Formats that
  /// have colours take them, and choose those of other labels.
  std::map<std::string, std::string> colours = {};
  /// Of the smooth surface, one for each corner of each triangle of the mesh, for viewers; none: no
  /// normals. Formats that hold normals (MeshFormat::has_normals) take them.
  CornerNormals normals = {};
};

}  // namespace dupin
