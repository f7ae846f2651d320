#pragma once

#include <string>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"

namespace dupin::cli {

/// A file's bytes and the name that messages give it; "-" reads standard input.
struct Input {
  std::string bytes;
  std::string name;

  /// True when the bytes look like an assembly document, not a mesh.
  [[nodiscard]] bool is_document() const;
};

/// Throws Error{io_failed}.
[[nodiscard]] Input read_input(const std::string& path);

[[nodiscard]] TriMesh read_mesh_input(const std::string& path);

/// Throws Error naming the file as its part when the mesh is not a solid.
[[nodiscard]] Solid read_solid_input(const std::string& path);

}  // namespace dupin::cli
