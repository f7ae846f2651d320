#pragma once

#include <string>

#include "dupin/io/mesh_file.h"

namespace dupin::test {

/// As messages list them: ".off, .stl".
inline std::string known_extensions() {
  std::string known;
  for (const MeshFormat& format : mesh_formats()) {
    if (!format.extension.empty()) {
      known += (known.empty() ? "" : ", ") + std::string(format.extension);
    }
  }
  return known;
}

}  // namespace dupin::test
