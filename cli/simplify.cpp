#include "dupin/kernel/simplify.h"

#include <algorithm>
#include <memory>
#include <optional>

#include <CLI/App.hpp>

#include "commands.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "mesh_to_mesh.h"
#include "output.h"
#include "progress_line.h"

namespace dupin::cli {
namespace {

/// What is wrong there, if anything, is not so in what was read.
Solid simplified_solid(const TriMesh& mesh) {
  try {
    return Solid::from(mesh);
  } catch (const Error&) {
    const Report report = check(mesh);
    const auto fault = std::ranges::find_if(
        report.findings, [](const Finding& finding) { return is_fatal(finding.defect); });
    if (fault == report.findings.end()) {
      throw;
    }
    throw Error(Errc::unroundable, "with fewer triangles it would be no solid: of these, " +
                                       describe(*fault, mesh) + "; a smaller --tolerance may do");
  }
}

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
  OutputReport report =
      write_solid(simplified_solid(simple.mesh), to, rounding, header, {}, progress);
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
      "No point of either surface is further from the other than the tolerance, but for the\n"
      "rounding to the numbers of the file, which the report tells; borders between\n"
      "labels keep their course.\n\n"
      "Examples:\n"
      "  dupin simplify plant.off light.stl --tolerance 0.5mm");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_simplify(*arguments, common); };
  });
}

}  // namespace dupin::cli
