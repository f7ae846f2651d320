#include "cross_check_option.h"

#include <CLI/App.hpp>

#include "exit_code.h"

namespace dupin::cli {

void add_cross_check_option(CLI::App& command, std::string& engine) {
  command
      .add_option("--cross-check", engine,
                  "Do the set operation again by another engine, nef (general, slow) or\n"
                  "corefinement, and compare exactly; exit code 1 if they disagree")
      ->type_name("ENGINE");
}

std::optional<CrossCheckEngine> cross_check_engine(const std::string& text) {
  if (text.empty()) {
    return std::nullopt;
  }
  for (const CrossCheckEngine engine : {CrossCheckEngine::nef, CrossCheckEngine::corefinement}) {
    if (text == name(engine)) {
      if (!has_cross_check()) {
        throw UsageError("--cross-check: this build has no other engines (DUPIN_CROSS_CHECK)");
      }
      return engine;
    }
  }
  throw UsageError("--cross-check takes nef or corefinement, not '" + text + "'");
}

}  // namespace dupin::cli
