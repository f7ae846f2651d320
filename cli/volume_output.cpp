#include "volume_output.h"

#include <filesystem>

#include "dupin/io/volume_mesh.h"
#include "exit_code.h"

namespace dupin::cli {
namespace {

std::string extension(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

}  // namespace

bool names_volume_mesh(const OutputArguments& arguments) {
  const std::string ending = extension(arguments.path);
  return arguments.format.empty() && (ending == ".msh" || ending == ".vtu");
}

OutputReport write_volume(const Solid& solid, const OutputArguments& arguments,
                          const RoundingOptions& rounding, const std::string& volume_name,
                          const Progress& progress) {
  if (!arguments.verification.empty() || arguments.no_verify || !arguments.patches.empty()) {
    throw UsageError("--verify, --no-verify and --patches are for meshes of surfaces, and " +
                     arguments.path + " is to hold one of a volume");
  }
  tell(progress, "round");
  const Rounded rounded = to_mesh(solid, Coordinates::binary64, rounding);
  tell(progress, "fill");
  const VolumeMesh volume = fill_with_tetrahedra(rounded.mesh());
  const bool is_msh = extension(arguments.path) == ".msh";
  OutputReport report;
  report.file = arguments.path;
  report.format = is_msh ? "MSH 2.2" : "VTU";
  report.rounding = rounded.report();
  report.contacts = rounded.contacts();
  report.check = check(rounded);
  report.volume_mesh = check_volume_mesh(volume);
  tell(progress, "write");
  write_text(arguments.path,
             is_msh ? msh_text(volume, volume_name) : vtu_text(volume, volume_name));
  return report;
}

}  // namespace dupin::cli
