#include <memory>
#include <span>
#include <vector>

#include <CLI/App.hpp>

#include "commands.h"
#include "dupin/kernel/boolean.h"
#include "input.h"
#include "length.h"
#include "output.h"
#include "progress_line.h"
#include "rounding_options.h"

namespace dupin::cli {
namespace {

struct BooleanCommand {
  std::string name, purpose, footer;
  Solid (*operation)(std::span<const Solid> operands, const BooleanOptions& options);
};

struct BooleanArguments {
  std::vector<std::string> files;
  std::string output, format;
  ContactPolicy contacts = ContactPolicy::report;
  RoundingArguments rounding;
};

Solid subtract_all(std::span<const Solid> operands, const BooleanOptions& options) {
  return subtract(operands.front(), operands.subspan(1), options);
}

ExitCode run_boolean(const BooleanCommand& command, const BooleanArguments& arguments,
                     const CommonOptions& common) {
  const Destination to = destination(arguments.output, arguments.format);
  const std::vector<Input> inputs = read_inputs(arguments.files);
  const MeshHeader header{common_unit(inputs), {}};
  const RoundingOptions rounding = rounding_options(arguments.rounding, header.unit,
                                                    mesh_length(common.tolerance, 0, header.unit));
  std::vector<Solid> operands;
  operands.reserve(inputs.size());
  for (const Input& input : inputs) {
    operands.push_back(solid_of(input));
  }
  OutputReport report;
  {
    ProgressLine line(common.quiet);
    report = write_solid(command.operation(operands, {arguments.contacts, line.callback()}), to,
                         rounding, header);
  }
  print_written(report, to, common);
  return ExitCode::ok;
}

void add_boolean(CLI::App& app, Action& action, const BooleanCommand& boolean) {
  CLI::App* command = app.add_subcommand(boolean.name, boolean.purpose);
  const auto arguments = std::make_shared<BooleanArguments>();
  command->add_option("IN", arguments->files, "solids; - for standard input")
      ->type_name("")
      ->required()
      ->expected(2, -1);
  command->add_option("-o,--output", arguments->output, "mesh file; - for standard output")
      ->type_name("OUT")
      ->required();
  add_format_option(*command, arguments->format);
  add_contacts_option(*command, arguments->contacts);
  add_rounding_options(*command, arguments->rounding);
  command->footer(boolean.footer);
  command->callback([arguments, boolean, &action] {
    action = [arguments, boolean](const CommonOptions& common) {
      return run_boolean(boolean, *arguments, common);
    };
  });
}

}  // namespace

void add_booleans(CLI::App& app, Action& action) {
  add_boolean(app, action,
              {"union", "Unite solids, exactly",
               "Examples:\n"
               "  dupin union header.off branch.stl -o both.off\n"
               "  dupin union a.off b.off c.off -o - --format stl > all.stl",
               unite});
  add_boolean(app, action,
              {"intersect", "What solids have in common, exactly",
               "Examples:\n  dupin intersect a.off b.off -o common.off", intersect});
  add_boolean(
      app, action,
      {"subtract", "The first solid without all the others, exactly",
       "Examples:\n  dupin subtract block.off drill1.off drill2.off -o part.stl", subtract_all});
}

}  // namespace dupin::cli
