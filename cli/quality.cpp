#include "quality.h"

#include <numbers>

#include <CLI/App.hpp>

#include "length.h"

namespace dupin::cli {

void add_quality_options(CLI::App& command, QualityArguments& arguments) {
  command
      .add_option("--largest-edge", arguments.largest_edge,
                  "Longest edges sought by remeshing; usually a tenth of the diagonal of the\n"
                  "box around the solid")
      ->type_name("LENGTH");
  command
      .add_option("--smallest-edge", arguments.smallest_edge,
                  "Where refinement by remeshing ends; usually the tolerance")
      ->type_name("LENGTH");
  command
      .add_option("--smallest-angle", arguments.smallest_angle,
                  "Of remeshed triangles, wherever sharp edges allow; usually 25")
      ->type_name("DEGREES")
      ->check(CLI::Range(0.0, 30.0));
  command
      .add_option("--feature-angle", arguments.feature_angle,
                  "Edges that turn by more are kept by remeshing; usually 40")
      ->type_name("DEGREES")
      ->check(CLI::Range(1.0, 179.0));
}

RemeshOptions remesh_options(const QualityArguments& arguments, double distance,
                             const std::string& unit) {
  constexpr double kDegree = std::numbers::pi / 180;
  RemeshOptions options;
  options.distance = distance;
  options.largest_edge = mesh_length(arguments.largest_edge, 0, unit);
  options.smallest_edge = mesh_length(arguments.smallest_edge, 0, unit);
  options.smallest_angle = arguments.smallest_angle * kDegree;
  options.feature_angle = arguments.feature_angle * kDegree;
  return options;
}

}  // namespace dupin::cli
