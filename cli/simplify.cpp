#include "dupin/kernel/simplify.h"

#include <memory>
#include <optional>

#include <CLI/App.hpp>

#include "commands.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "mesh_to_mesh.h"
#include "output.h"
#include "progress_line.h"

namespace dupin::cli {
namespace {

ExitCode run_simplify(const MeshToMesh& arguments, const CommonOptions& common) {
  const Destination to = destination(arguments.output);
  if (common.tolerance.empty()) {
    throw UsageError("simplify needs --tolerance");
  }
  const Input input = read_input(arguments.input);
  const MeshHeader header{input.unit(), {}};
  const double tolerance = mesh_length(common.tolerance, 0, header.unit);
  const RoundingOptions rounding = rounding_options(arguments.rounding, header.unit);
  std::optional<ProgressLine> line(common.quiet);
  const Progress progress = line->callback();
  tell(progress, "read");
  const Simplified simple = simplify(solid_of(input), tolerance, progress);
  OutputReport report = write_solid(Solid::from(simple.mesh), to, rounding, header, {}, progress);
  line.reset();
  report.simplification = {simple.removed_triangles, simple.deviation};
  print_written(report, to, common);
  return ExitCode::ok;
}

}  // namespace

void add_simplify(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("simplify", "Fewer triangles within a distance of --tolerance");
  const auto arguments = std::make_shared<MeshToMesh>();
  add_mesh_to_mesh_options(*command, "solid", *arguments);
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
