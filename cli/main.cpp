#include <algorithm>
#include <iostream>
#include <new>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "argument_checks.h"
#include "commands.h"
#include "dupin/io/report_json.h"
#include "exit_code.h"
#include "interrupt.h"
#include "output.h"
#include "ranks.h"

namespace dupin::cli {
namespace {

void add_common_options(CLI::App& app, CommonOptions& common) {
  app.add_flag("--json", common.json, "Write the report, or the error, as JSON");
  app.add_flag("-q,--quiet", common.quiet, "Write no report and no progress");
  app.add_option(
         "--tolerance", common.tolerance,
         "Largest distance between a surface and what stands for it: the mesh\n"
         "(build, watch, certify, convert, report, bom --mesh), the NURBS surface (nurbs), lines\n"
         "of a drawing (draw), the mesh with fewer triangles (simplify), a mesh for solvers\n"
         "(remesh). A length such as 0.05, 1mm or 0.5in")
      ->type_name("LENGTH");
  app.set_version_flag("--version", std::string("dupin ") + DUPIN_VERSION);
}

/// What CLI11 says, or something better where it does not name the culprit.
std::string usage_text(const CLI::App& app, const CLI::ParseError& error) {
  const bool no_command = app.get_subcommands().empty();
  const std::vector<std::string> rest = app.remaining();
  if (no_command && !rest.empty() && rest.front().front() != '-') {
    return "'" + rest.front() + "' is no command";
  }
  return error.what();
}

/// One line on standard error, or one JSON object; written at once, as other processes of mpirun
/// write there, too.
int fail(bool json, ExitCode code, std::string_view kind, const Error& error) {
  std::string line = error.what();
  std::replace(line.begin(), line.end(), '\n', ' ');
  if (json) {
    std::cerr << error_json(error, kind, static_cast<int>(code)) + "\n";
  } else {
    std::cerr << "dupin: " + line + "\n";
  }
  return static_cast<int>(code);
}

int fail(bool json, ExitCode code, std::string_view kind, const std::string& message) {
  return fail(json, code, kind, Error(Errc::invalid_argument, message));
}

int output_failure(bool json, const Error& error) {
  return fail(json, ExitCode::output, name(error.code()), error);
}

int usage_failure(bool json, const std::string& message) {
  let_first_speak();
  return fail(json, ExitCode::usage, "usage", message + " (see dupin --help)");
}

/// Each process would do, and print, all of it.
void refuse_mpirun(const std::string& command) {
  if (is_under_mpirun()) {
    throw UsageError("mpirun shares the work of build and union among processes; run " + command +
                     " without it");
  }
}

int perform(const Action& action, const CLI::App& command, const CommonOptions& common) {
  if (common.json) {
    constexpr auto kCode = ExitCode::interrupted;
    say_on_interrupt(
        error_json(Error(Errc::cancelled, "interrupted"), "interrupted", static_cast<int>(kCode)) +
        "\n");
  }
  try {
    if (command.get_name() != "build" && command.get_name() != "union") {
      refuse_mpirun(command.get_name());
    }
    require_sound_arguments(*command.get_parent(), command);
    require_writable_outputs();
    const ExitCode code = action(common);
    writing(flush_stdout);
    return static_cast<int>(code);
  } catch (const UsageError& error) {
    return usage_failure(common.json, error.what());
  } catch (const OutputError& error) {
    return output_failure(common.json, error);
  } catch (const Error& error) {
    return fail(common.json, exit_code(error.code()), name(error.code()), error);
  } catch (const std::bad_alloc&) {
    return fail(common.json, ExitCode::internal, "internal", "out of memory");
  } catch (const std::exception& error) {
    return fail(common.json, ExitCode::internal, "internal",
                std::string("internal error, please report it: ") + error.what());
  }
}

int run(std::span<char*> arguments) {
  CLI::App app("Exact solid modelling of smoothly blended pipe assemblies", "dupin");
  app.require_subcommand(1);
  app.fallthrough();
  app.get_formatter()->column_width(36);
  app.footer(
      "Examples:\n"
      "  dupin build examples/reducer.json -o reducer.stl\n"
      "  dupin union a.off b.stl -o both.off\n"
      "  dupin check both.off --json\n\n"
      "Exit codes: 0 ok, 1 findings, 2 usage, 3 invalid input, 4 refused, 5 output failed, "
      "70 internal, 130 interrupted");
  CommonOptions common;
  Action action;
  add_common_options(app, common);
  add_build(app, action);
  add_booleans(app, action);
  add_check(app, action);
  add_gaps(app, action);
  add_certify(app, action);
  add_verify(app, action);
  add_convert(app, action);
  add_repair(app, action);
  add_simplify(app, action);
  add_remesh(app, action);
  add_nurbs(app, action);
  add_edit(app, action);
  add_info(app, action);
  add_draw(app, action);
  add_report(app, action);
  add_bom(app, action);
  add_completion(app, action);
  add_watch(app, action);
  add_schema(app, action);
  add_manual(app, action);

  try {
    app.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::Success& wanted) {
    std::ostringstream help_or_version;
    const int code = app.exit(wanted, help_or_version);
    try {
      write_text("-", help_or_version.str());
      return code;
    } catch (const OutputError& error) {
      return output_failure(false, error);
    }
  } catch (const CLI::ParseError& error) {
    const bool json = std::any_of(arguments.begin(), arguments.end(), [](const char* argument) {
      return std::string_view(argument) == "--json";
    });
    return usage_failure(json, usage_text(app, error));
  }
  return perform(action, *app.get_subcommands().front(), common);
}

}  // namespace
}  // namespace dupin::cli

int main(int argc, char** argv) {
  try {
    std::ios::sync_with_stdio(false);
    dupin::cli::end_on_signals();
    return dupin::cli::run({argv, static_cast<std::size_t>(argc)});
  } catch (...) {  // even saying why may have failed
    return static_cast<int>(dupin::cli::ExitCode::internal);
  }
}
