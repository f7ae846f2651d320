#pragma once

#include <string>

namespace dupin {

/// What a mesh file may say besides the geometry. Control characters are written as spaces.
struct MeshHeader {
  std::string unit;  ///< of the coordinates: "mm", "cm", "m", "in", "ft", or empty when unknown
  std::string note;  ///< free text of one line, e.g. where the origin lies
};

}  // namespace dupin
