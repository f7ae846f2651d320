#include "dupin/kernel/check.h"

#include <iostream>
#include <memory>

#include <CLI/App.hpp>

#include "commands.h"
#include "input.h"
#include "length.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

ExitCode run_check(const std::string& file, const CommonOptions& common) {
  refuse_tolerance("check", common);
  const Report report = check(read_mesh_input(file));
  if (common.json) {
    std::cout << to_json(report) << '\n';
  } else if (!common.quiet) {
    print_report(std::cout, report);
  }
  return report.is_solid() ? ExitCode::ok : ExitCode::findings;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("check", "Say whether a mesh is a solid, and if not, why");
  const auto file = std::make_shared<std::string>();
  command->add_option("FILE", *file, "mesh file; - for standard input")->type_name("")->required();
  command->footer(
      "Exit code 1 means that the mesh is no solid.\n\n"
      "Examples:\n"
      "  dupin check part.stl\n"
      "  dupin check part.stl --json | jq .counts");
  command->callback([file, &action] {
    action = [file](const CommonOptions& common) { return run_check(*file, common); };
  });
}

}  // namespace dupin::cli
