#pragma once

#include <string>
#include <vector>

#include "dupin/kernel/placement.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
class Option;
}  // namespace CLI

namespace dupin::cli {

/// --translate, --rotate and --scale as typed.
struct PlacementArguments {
  struct Step {
    std::string option, text;
  };
  std::vector<Step> steps;  ///< in the order of the command line, once `collect` has run

  std::vector<std::string> translations, rotations, scales;
  std::vector<CLI::Option*> options;

  /// To be called when the command line has been read.
  void collect(const CLI::App& command);
  [[nodiscard]] bool empty() const { return steps.empty(); }
};

/// Adds them; each may be given any number of times.
void add_placement_options(CLI::App& command, PlacementArguments& arguments);

/// What they do together, lengths beside coordinates in `unit` (see mesh_length). Throws
/// UsageError.
[[nodiscard]] Placement placement(const PlacementArguments& arguments, const std::string& unit);

}  // namespace dupin::cli
