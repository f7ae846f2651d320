#include "mesh_to_mesh.h"

#include <CLI/App.hpp>

namespace dupin::cli {

void add_mesh_to_mesh_options(CLI::App& command, const std::string& input_kind,
                              MeshToMesh& arguments,
                              const std::vector<std::string>& other_formats) {
  command.add_option("IN", arguments.input, input_kind + "; - for standard input")
      ->type_name("")
      ->required();
  command.add_option("OUT", arguments.output.path, "mesh file; - for standard output")
      ->type_name("")
      ->required();
  add_output_options(command, arguments.output, other_formats);
  add_rounding_options(command, arguments.rounding);
}

}  // namespace dupin::cli
