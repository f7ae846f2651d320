#include "dupin/kernel/remesh.h"

#include <memory>

#include <CLI/App.hpp>

#include "commands.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "output.h"
#include "quality.h"
#include "rounding_options.h"

namespace dupin::cli {
namespace {

struct RemeshArguments {
  std::string input;
  OutputArguments output;
  QualityArguments quality;
  RoundingArguments rounding;
};

ExitCode run_remesh(const RemeshArguments& arguments, const CommonOptions& common) {
  const Destination to = destination(arguments.output);
  if (common.tolerance.empty()) {
    throw UsageError("remesh needs --tolerance");
  }
  const Input input = read_input(arguments.input);
  const MeshHeader header{input.unit(), {}};
  const double distance = mesh_length(common.tolerance, 0, header.unit);
  const RoundingOptions rounding = rounding_options(arguments.rounding, header.unit);
  Remeshed remeshed =
      remesh(solid_of(input), remesh_options(arguments.quality, distance, header.unit));
  OutputReport report = write_solid(remeshed.solid, to, rounding, header);
  report.remeshing = std::move(remeshed.report);
  print_written(report, to, common);
  return ExitCode::ok;
}

}  // namespace

void add_remesh(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "remesh", "Well-shaped triangles for a solver, within a distance of --tolerance");
  const auto arguments = std::make_shared<RemeshArguments>();
  command->add_option("IN", arguments->input, "solid; - for standard input")
      ->type_name("")
      ->required();
  command->add_option("-o,--output", arguments->output.path, "mesh file; - for standard output")
      ->type_name("OUT")
      ->required();
  add_output_options(*command, arguments->output);
  add_quality_options(*command, arguments->quality);
  add_rounding_options(*command, arguments->rounding);
  command->footer(
      "No point of either surface is further from the other than the tolerance. Sharp edges and\n"
      "borders between labels keep their course. What cannot have the smallest angle is counted,\n"
      "and the worst of it listed.\n\n"
      "Examples:\n"
      "  dupin remesh plant.off -o plant-cfd.stl --tolerance 0.1mm\n"
      "  dupin remesh plant.off -o plant-cfd.off --tolerance 0.1mm --largest-edge 20mm");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_remesh(*arguments, common); };
  });
}

}  // namespace dupin::cli
