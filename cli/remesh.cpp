#include "dupin/kernel/remesh.h"

#include <memory>
#include <optional>
#include <utility>

#include <CLI/App.hpp>

#include "commands.h"
#include "exit_code.h"
#include "idle_options.h"
#include "input.h"
#include "length.h"
#include "mesh_to_mesh.h"
#include "output.h"
#include "progress_line.h"
#include "solver_options.h"

namespace dupin::cli {
namespace {

struct RemeshArguments {
  MeshToMesh files;
  SolverArguments solver;
};

/// Runs what needs a solid without contacts, and tells by what command they go.
template <class Function>
OutputReport without_contacts(const std::string& input, const Function& function) {
  try {
    return function();
  } catch (const Error& error) {
    if (error.code() != Errc::contact) {
      throw;
    }
    throw Error(error.code(),
                error.message() + ": dupin repair " + input +
                    " -o OUT --contacts separate=LENGTH, or bridge=LENGTH",
                error.part(), error.where());
  }
}

ExitCode run_remesh(const RemeshArguments& arguments, const CommonOptions& common) {
  const OutputArguments& output = arguments.files.output;
  const bool fills = is_volume(output);
  Destination to{output_path(output.path)};
  if (fills) {
    check_volume_output(output);
    refuse_idle_of_volume(arguments.files.rounding, output);
  } else {
    to = destination(output);
  }
  if (common.tolerance.empty()) {
    throw UsageError("remesh needs --tolerance, the largest distance from the solid");
  }
  const Input input = read_input(arguments.files.input);
  const MeshHeader header{input.unit(), {}};
  const double distance = mesh_length(common.tolerance, 0, header.unit);
  RemeshOptions options = solver_options(arguments.solver, distance, header.unit);
  const RoundingOptions rounding = rounding_options(arguments.files.rounding, header.unit);
  const Solid solid = solid_of(input);
  std::optional<ProgressLine> line(common.quiet);
  options.progress = line->callback();
  const OutputReport report = without_contacts(arguments.files.input, [&] {
    if (fills) {
      return write_volume(solid, options, output, header);
    }
    Remeshed made = remesh(solid, options);
    OutputReport written = write_solid(made.solid, to, rounding, header, {}, options.progress);
    written.solver_mesh = solver_report(std::move(made.report), options);
    return written;
  });
  line.reset();
  print_written(report, to, common);
  return ExitCode::ok;
}

}  // namespace

void add_remesh(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "remesh", "Well-shaped triangles, or tetrahedra, within a distance of --tolerance");
  const auto arguments = std::make_shared<RemeshArguments>();
  add_mesh_to_mesh_options(*command, "solid", arguments->files, volume_format_names());
  add_solver_options(*command, arguments->solver);
  command->footer(
      "What solvers take: sharp edges and borders between labels are kept, no point of either\n"
      "surface is further from the other than the tolerance. OUT is a surface in any format of\n"
      "meshes, or, as .msh (gmsh 2.2) or .vtu (VTK), tetrahedra, with the labels as physical\n"
      "groups or cell data.\n\n"
      "Examples:\n"
      "  dupin remesh plant.off walls.stl --tolerance 0.5mm --size 20mm\n"
      "  dupin remesh fluid.off fluid.msh --tolerance 0.5mm --size 20mm");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_remesh(*arguments, common); };
  });
}

}  // namespace dupin::cli
