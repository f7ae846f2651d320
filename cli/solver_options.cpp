#include "solver_options.h"

#include <numbers>
#include <utility>

#include <CLI/App.hpp>

#include "dupin/io/volume_file.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/fill.h"
#include "exchange_options.h"
#include "exit_code.h"
#include "length.h"
#include "number_range.h"

namespace dupin::cli {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kUsualAngle = 25, kUsualSharp = 40;  // in degrees

const VolumeFormat* volume_format(const OutputArguments& arguments) {
  return find_volume_format(arguments.format.empty() ? lower_extension(arguments.path)
                                                     : arguments.format);
}

}  // namespace

void add_solver_options(CLI::App& command, SolverArguments& arguments) {
  command
      .add_option("--size", arguments.size,
                  "Longest edge of a mesh for solvers, or a tenth of the diagonal of the box\n"
                  "around the solid")
      ->type_name("LENGTH");
  command
      .add_option("--angle", arguments.angle,
                  "Smallest angle of its triangles in degrees, as far as sharp edges allow;\n"
                  "25 if not given")
      ->type_name("DEGREES")
      ->check(number_range(0, 30));
  command
      .add_option("--sharp", arguments.sharp,
                  "Edges where the surface turns by more are kept, as borders between labels\n"
                  "are; 40 if not given")
      ->type_name("DEGREES")
      ->check(number_range(1, 179));
}

RemeshOptions solver_options(const SolverArguments& arguments, double distance,
                             const std::string& unit) {
  RemeshOptions options;
  options.distance = mesh_length(arguments.distance, distance, unit);
  options.largest_edge = mesh_length(arguments.size, 0, unit);
  options.smallest_angle = arguments.angle.value_or(kUsualAngle) * kDegree;
  options.feature_angle = arguments.sharp.value_or(kUsualSharp) * kDegree;
  return options;
}

std::vector<std::string> volume_format_names() {
  std::vector<std::string> names;
  for (const VolumeFormat& format : volume_formats()) {
    names.emplace_back(format.key);
  }
  return names;
}

bool is_volume(const OutputArguments& arguments) { return volume_format(arguments) != nullptr; }

void check_volume_output(const OutputArguments& arguments) {
  if (!arguments.patches.empty()) {
    throw UsageError(
        "--patches lists those of a surface; the triangles of a volume mesh carry their names");
  }
}

OutputReport write_volume(const Solid& solid, const RemeshOptions& options,
                          const OutputArguments& arguments, const MeshHeader& header) {
  const VolumeFormat& format = *volume_format(arguments);
  Filled filled = fill(solid, options);
  const std::string path = output_path(arguments.path);
  OutputReport report;
  report.file = path == "-" ? "standard output" : path;
  report.format = format.name;
  tell(options.progress, "write");
  const bool unread = arguments.no_verify;
  const std::string bytes = unread
                                ? format.write(filled.mesh, header)
                                : verified_volume_bytes(filled.mesh, format, header, report.file);
  report.verification = unread ? Verification::none : Verification::compare;
  report.check = check(filled.mesh.surface);
  write_text(path, bytes);
  report.solver_mesh = solver_report(std::move(filled.report), options);
  report.solver_mesh->volume = {filled.mesh.point_count(), filled.mesh.tetrahedra.size(),
                                filled.smallest_dihedral_angle};
  return report;
}

SolverMeshReport solver_report(RemeshReport report, const RemeshOptions& options) {
  return {std::move(report), options.smallest_angle, options.distance};
}

}  // namespace dupin::cli
