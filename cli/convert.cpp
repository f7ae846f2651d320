#include <algorithm>
#include <memory>

#include <CLI/App.hpp>

#include "commands.h"
#include "dupin/kernel/check.h"
#include "input.h"
#include "length.h"
#include "output.h"
#include "rounding_options.h"

namespace dupin::cli {
namespace {

struct ConvertArguments {
  std::string input, output, format;
  RoundingArguments rounding;
};

/// True when every coordinate is a number of the format already.
bool fits(const TriMesh& mesh, Coordinates coordinates) {
  return std::all_of(mesh.points.begin(), mesh.points.end(),
                     [&](const Vec3& point) { return point == nearest(point, coordinates); });
}

ExitCode run_convert(const ConvertArguments& arguments, const CommonOptions& common) {
  const Destination to = destination(arguments.output, arguments.format);
  const RoundingOptions rounding =
      rounding_options(arguments.rounding, Unit::millimetre, mesh_length(common.tolerance, 0));
  const bool unchanged = rounding.grid == 0 && rounding.origin.choice == Origin::Choice::keep;
  const Input input = read_input(arguments.input);
  const TriMesh mesh = read_mesh(input.bytes, input.name);
  const MeshHeader header{mesh_unit(input.bytes, input.name), {}};
  const bool stays_solid =
      !(unchanged && fits(mesh, coordinates(to.format))) && check(mesh).is_solid();
  print_written(stays_solid ? write_solid(Solid::from(mesh), to, rounding, header)
                            : write_plain(mesh, to, header),
                to, common);
  return ExitCode::ok;
}

}  // namespace

void add_convert(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("convert", "Write a mesh in another format");
  const auto arguments = std::make_shared<ConvertArguments>();
  command->add_option("IN", arguments->input, "mesh file; - for standard input")
      ->type_name("")
      ->required();
  command->add_option("OUT", arguments->output, "mesh file; - for standard output")
      ->type_name("")
      ->required();
  add_format_option(*command, arguments->format);
  add_rounding_options(*command, arguments->rounding);
  command->footer(
      "A solid whose coordinates the format cannot hold is rounded so that it stays one; any\n"
      "other mesh is written as it is.\n\n"
      "Examples:\n"
      "  dupin convert part.off part.stl\n"
      "  dupin convert - - --format off < part.stl > part.off");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_convert(*arguments, common); };
  });
}

}  // namespace dupin::cli
