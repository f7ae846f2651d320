#pragma once

#include <string>

#include "dupin/kernel/remesh.h"

namespace CLI {
class App;
}

namespace dupin::cli {

/// How triangles for a solver should be, as typed.
struct QualityArguments {
  std::string largest_edge, smallest_edge;
  double smallest_angle = 25, feature_angle = 40;  ///< in degrees
};

/// Adds --largest-edge, --smallest-edge, --smallest-angle and --feature-angle.
void add_quality_options(CLI::App& command, QualityArguments& arguments);

/// `distance` is in the unit given. Throws UsageError.
[[nodiscard]] RemeshOptions remesh_options(const QualityArguments& arguments, double distance,
                                           const std::string& unit);

}  // namespace dupin::cli
