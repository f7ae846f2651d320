#include <algorithm>
#include <memory>

#include <CLI/App.hpp>

#include "commands.h"
#include "dupin/kernel/check.h"
#include "input.h"
#include "length.h"
#include "mesh_to_mesh.h"
#include "output.h"

namespace dupin::cli {
namespace {

/// True when every coordinate is a number of the format already.
bool fits(const TriMesh& mesh, Coordinates coordinates) {
  return std::all_of(mesh.points.begin(), mesh.points.end(),
                     [&](const Vec3& point) { return point == nearest(point, coordinates); });
}

ExitCode run_convert(const MeshToMesh& arguments, const CommonOptions& common) {
  refuse_tolerance("convert", common, "--rounding-tolerance");
  const Destination to = destination(arguments.output);
  const Input input = read_input(arguments.input);
  const MeshHeader header{input.unit(), {}};
  const RoundingOptions rounding = rounding_options(arguments.rounding, header.unit);
  const bool unchanged = rounding.grid == 0 && rounding.origin.choice == Origin::Choice::keep;
  const TriMesh mesh = read_mesh(input.bytes, input.name);
  const bool stays_solid =
      !(unchanged && fits(mesh, to.format.coordinates)) && check(mesh).is_solid();
  print_written(stays_solid ? write_solid(Solid::from(mesh), to, rounding, header)
                            : write_plain(mesh, to, header),
                to, common);
  return ExitCode::ok;
}

}  // namespace

void add_convert(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("convert", "Write a mesh in another format");
  const auto arguments = std::make_shared<MeshToMesh>();
  add_mesh_to_mesh_options(*command, "mesh file", *arguments);
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
