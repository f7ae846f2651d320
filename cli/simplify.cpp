#include "dupin/kernel/simplify.h"

#include <memory>

#include <CLI/App.hpp>

#include "commands.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "output.h"
#include "rounding_options.h"

namespace dupin::cli {
namespace {

struct SimplifyArguments {
  std::string input, output, format;
  RoundingArguments rounding;
};

ExitCode run_simplify(const SimplifyArguments& arguments, const CommonOptions& common) {
  const Destination to = destination(arguments.output, arguments.format);
  if (common.tolerance.empty()) {
    throw UsageError("simplify needs --tolerance");
  }
  const double tolerance = mesh_length(common.tolerance, 0);
  const RoundingOptions rounding = rounding_options(arguments.rounding, Unit::millimetre, 0);
  const Simplified simple = simplify(read_solid_input(arguments.input), tolerance);
  OutputReport report = write_solid(Solid::from(simple.mesh), to, rounding, {});
  report.simplification = {simple.removed_triangles, simple.deviation};
  print_written(report, to, common);
  return ExitCode::ok;
}

}  // namespace

void add_simplify(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("simplify", "Fewer triangles within a distance of --tolerance");
  const auto arguments = std::make_shared<SimplifyArguments>();
  command->add_option("IN", arguments->input, "solid; - for standard input")
      ->type_name("")
      ->required();
  command->add_option("OUT", arguments->output, "mesh file; - for standard output")
      ->type_name("")
      ->required();
  add_format_option(*command, arguments->format);
  add_rounding_options(*command, arguments->rounding);
  command->footer(
      "No point of either surface is further from the other than the tolerance; borders between\n"
      "labels keep their course.\n\n"
      "Examples:\n"
      "  dupin simplify plant.off light.stl --tolerance 0.5mm");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_simplify(*arguments, common); };
  });
}

}  // namespace dupin::cli
