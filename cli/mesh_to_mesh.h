#pragma once

#include <string>
#include <vector>

#include "output.h"
#include "rounding_options.h"

namespace dupin::cli {

/// What a command that makes one mesh file of another is told.
struct MeshToMesh {
  std::string input;
  OutputArguments output;
  RoundingArguments rounding;
};

/// Adds IN, OUT and the options of output (see add_output_options) and of rounding.
void add_mesh_to_mesh_options(CLI::App& command, const std::string& input_kind,
                              MeshToMesh& arguments,
                              const std::vector<std::string>& other_formats = {});

}  // namespace dupin::cli
