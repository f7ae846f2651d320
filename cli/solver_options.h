#pragma once

#include <optional>
#include <string>

#include "commands.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/solid.h"
#include "dupin/kernel/solver_mesh.h"
#include "output.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// --size, --distance, --angle and --sharp as typed; empty when not given.
struct SolverArguments {
  std::string size, distance;
  std::optional<double> angle, sharp;  // in degrees
};

/// All but --distance.
void add_solver_options(CLI::App& command, SolverArguments& arguments);

/// What they mean beside coordinates in `unit` (see mesh_length), for a mesh within `distance` if
/// --distance is not given. Throws UsageError.
[[nodiscard]] RemeshOptions solver_options(const SolverArguments& arguments, double distance,
                                           const std::string& unit);

/// What --format takes besides the keys of meshes.
[[nodiscard]] std::vector<std::string> volume_format_names();

/// Whether a file that is to be written holds tetrahedra: by --format, or else by its extension.
[[nodiscard]] bool is_volume(const OutputArguments& arguments);

/// Throws UsageError for what only surfaces have: a list of patches.
void check_volume_output(const OutputArguments& arguments);

/// Fills the solid and writes the tetrahedra, in one step and read back before. Tells the stages
/// of `fill`, "write" and "verify". Throws as `fill`, and OutputError.
[[nodiscard]] OutputReport write_volume(const Solid& solid, const RemeshOptions& options,
                                        const OutputArguments& arguments, const MeshHeader& header);

/// The report of a surface that was remeshed.
[[nodiscard]] SolverMeshReport solver_report(RemeshReport report, const RemeshOptions& options);

}  // namespace dupin::cli
