#pragma once

#include <string>
#include <vector>

#include "commands.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/solid.h"
#include "output.h"

namespace dupin::cli {

/// The extensions of volume meshes, which are no mesh formats: `.msh` and `.vtu`.
[[nodiscard]] bool names_volume_mesh(const OutputArguments& arguments);

/// Fills the solid with tetrahedra and writes them. The triangles of its surface stay. Tells the
/// stages "round", "fill" and "write". Throws UsageError for options that are about surfaces alone,
/// what `to_mesh` and `fill_with_tetrahedra` throw, and OutputError.
[[nodiscard]] OutputReport write_volume(const Solid& solid, const OutputArguments& arguments,
                                        const RoundingOptions& rounding,
                                        const std::string& volume_name, const Progress& progress);

}  // namespace dupin::cli
