#include "dupin/kernel/repair.h"

#include <memory>
#include <optional>

#include <CLI/App.hpp>

#include "commands.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "output.h"
#include "progress_line.h"
#include "rounding_options.h"

namespace dupin::cli {
namespace {

struct RepairArguments {
  std::string input, contacts;
  OutputArguments output;
  RoundingArguments rounding;
};

ExitCode run_repair(const RepairArguments& arguments, const CommonOptions& common) {
  refuse_tolerance("repair", common, "--rounding-tolerance");
  const Destination to = destination(arguments.output);
  const Input input = read_input(arguments.input);
  const MeshHeader header{input.unit(), {}};
  const ContactChoice contacts = contact_choice(arguments.contacts, header.unit);
  const RoundingOptions rounding = rounding_options(arguments.rounding, header.unit);
  std::optional<ProgressLine> line(common.quiet);
  const Progress progress = line->callback();
  tell(progress, "repair");
  const Repaired repaired = repaired_solid_of(input, progress);
  OutputReport report = write_solid(repaired.solid, to, rounding, header, contacts, progress);
  line.reset();
  report.repairs = {{input.name, repaired.report}};
  print_written(report, to, common);
  return ExitCode::ok;
}

}  // namespace

void add_repair(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "repair", "A solid of a mesh that is none, where nothing has to be guessed");
  const auto arguments = std::make_shared<RepairArguments>();
  command->add_option("IN", arguments->input, "mesh file; - for standard input")
      ->type_name("")
      ->required();
  command->add_option("-o,--output", arguments->output.path, "mesh file; - for standard output")
      ->type_name("OUT")
      ->required();
  add_output_options(*command, arguments->output);
  add_contacts_option(*command, arguments->contacts);
  add_rounding_options(*command, arguments->rounding);
  command->footer(
      "Merges identical points, drops faces without area and copies of faces, turns faces round,\n"
      "unites what overlaps, and says how much of each. It moves no point but to round it, and\n"
      "fills no hole: a surface that is open is refused with the place.\n\n"
      "Examples:\n"
      "  dupin repair export.stl -o part.stl\n"
      "  dupin repair - -o - --format off < export.stl > part.off");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_repair(*arguments, common); };
  });
}

}  // namespace dupin::cli
