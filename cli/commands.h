#pragma once

#include <functional>
#include <string>

#include "exit_code.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// Options that every command understands.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  std::string tolerance;  ///< of surfaces, as typed; empty when not given

  [[nodiscard]] bool wants_report() const { return json || !quiet; }
};

/// What the chosen command will do once the whole command line has been read.
using Action = std::function<ExitCode(const CommonOptions&)>;

/// Each adds one command (or family of commands) to `app`; parsing a command line that chooses it
/// sets `action`.
void add_build(CLI::App& app, Action& action);
void add_booleans(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_gaps(CLI::App& app, Action& action);
void add_certify(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
void add_convert(CLI::App& app, Action& action);
void add_simplify(CLI::App& app, Action& action);
void add_remesh(CLI::App& app, Action& action);
void add_repair(CLI::App& app, Action& action);
void add_edit(CLI::App& app, Action& action);
void add_nurbs(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_draw(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_bom(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);
void add_watch(CLI::App& app, Action& action);
void add_schema(CLI::App& app, Action& action);
void add_manual(CLI::App& app, Action& action);

}  // namespace dupin::cli
