#pragma once

#include <optional>
#include <string>

#include "dupin/kernel/cross_check.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// Adds --cross-check nef|corefinement.
void add_cross_check_option(CLI::App& command, std::string& engine);

/// What was typed; nothing for an option that was not given. Throws UsageError, also if this build
/// has no other engines.
[[nodiscard]] std::optional<CrossCheckEngine> cross_check_engine(const std::string& text);

}  // namespace dupin::cli
