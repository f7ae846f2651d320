#pragma once

#include <string>

#include "rounding_options.h"

namespace dupin::cli {

/// What a command that makes one mesh file of another is told.
struct MeshToMesh {
  std::string input, output, format;
  RoundingArguments rounding;
};

/// Adds IN, OUT, --format and the options of rounding.
void add_mesh_to_mesh_options(CLI::App& command, const std::string& input_kind,
                              MeshToMesh& arguments);

}  // namespace dupin::cli
