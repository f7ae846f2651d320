#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "commands.h"
#include "cross_check_option.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/boolean_expression.h"
#include "dupin/kernel/cross_check.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/stage_clock.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "output.h"
#include "progress_line.h"
#include "ranks.h"
#include "rounding_options.h"
#include "tiles/district_output.h"
#include "tiles/operand_pieces.h"
#include "tiles/tile_options.h"
#include "tiles/united_districts.h"

namespace dupin::cli {
namespace {

struct BooleanCommand {
  std::string name, purpose, footer;
  SetOperation operation;
};

/// What to do with the solids, and how to have it checked.
struct Task {
  std::function<Solid(std::span<const Solid>, const BooleanOptions&)> operation;
  std::function<CrossCheck(const Solid&, CrossCheckEngine, std::span<const Solid>, const Progress&)>
      second_opinion;
  bool is_union = false;
};

/// What all set operations take.
struct OperandArguments {
  std::string command;
  std::vector<std::string> operands;
  std::string contacts, cross_check;
  OutputArguments output;
  bool repair = false;
  bool timing = false;
  RoundingArguments rounding;
  TileArguments tiles;
};

struct ExpressionArguments {
  std::string expression;
  OperandArguments common;
};

Solid combined(SetOperation operation, std::span<const Solid> operands,
               const BooleanOptions& options) {
  switch (operation) {
    case SetOperation::unite:
      return unite(operands, options);
    case SetOperation::intersect:
      return intersect(operands, options);
    case SetOperation::subtract:
      return subtract(operands.front(), operands.subspan(1), options);
  }
  return {};
}

/// The meshes in files, whose bytes make room for them.
std::vector<TriMesh> read_meshes(std::vector<Input>& inputs) {
  std::vector<TriMesh> meshes(inputs.size());
  for_each_in_parallel(inputs.size(), [&](std::size_t i) {
    meshes[i] = read_mesh(inputs[i].bytes, inputs[i].name);
    inputs[i].bytes = {};
  });
  return meshes;
}

/// The solids of meshes, which make room for them; mended where that is asked for, and what was
/// done goes to `repairs`.
std::vector<Solid> prove_operands(std::vector<TriMesh> meshes, const std::vector<Input>& inputs,
                                  bool are_repaired, std::vector<FileRepair>& repairs) {
  std::vector<Solid> operands(inputs.size());
  std::vector<RepairReport> reports(inputs.size());
  for_each_in_parallel(inputs.size(), [&](std::size_t i) {
    const TriMesh mesh = std::move(meshes[i]);
    operands[i] = operand_of(mesh, inputs[i].name, are_repaired, reports[i]);
  });
  std::vector<std::string> names;
  names.reserve(inputs.size());
  std::ranges::transform(inputs, std::back_inserter(names), &Input::name);
  repairs = repairs_in(names, reports);
  return operands;
}

/// What the task makes of the operands, in districts if it is a union.
struct Result {
  std::vector<Solid> solids;
  std::vector<Boxes> boxes;  ///< of several
};

Result result_of(const Task& task, std::span<const Solid> operands, const Boxes& boxes,
                 const DistrictMargin& margin, const BooleanOptions& options) {
  if (!task.is_union) {
    return {{task.operation(operands, options)}, {}};
  }
  OperandDistricts districts = operand_districts(boxes, margin);
  return {united_districts(operands, districts, options), std::move(districts.boxes)};
}

OutputReport write_result(const Result& result, Destination to, const CommonOptions& common,
                          const RoundingOptions& rounding, const MeshHeader& header,
                          const ContactChoice& contacts, const Progress& progress) {
  if (result.solids.size() == 1) {
    to.is_measured = common.wants_report();
    return write_solid(result.solids.front(), to, rounding, header, contacts, progress);
  }
  tell(progress, "round");
  return write_districts(result.solids, result.boxes, to, rounding, header, contacts);
}

/// A union, tile by tile.
OutputReport in_tiles(const std::vector<std::string>& files, const OperandArguments& arguments,
                      const Destination& to, const CommonOptions& common, const Ranks& ranks) {
  require_tiled_output(to, arguments.tiles);
  if (!arguments.cross_check.empty() || arguments.timing) {
    throw UsageError("--cross-check and --timing are not for --tiles, --memory and mpirun");
  }
  for (const std::string& file : files) {
    require_read_again(file, "--tiles, --memory and mpirun read operands when their tile is made");
  }
  ProgressLine line(common.quiet || !ranks.is_first());
  const OperandFiles operands = survey(files, line.callback(), ranks);
  const auto options = alike(ranks, [&] {
    return std::pair(rounding_options(arguments.rounding, operands.unit),
                     contact_choice(arguments.contacts, operands.unit));
  });
  return unite_in_tiles({files, to, options.first, options.second, arguments.repair,
                         arguments.tiles, line.callback()},
                        operands, ranks);
}

/// Whether what hangs together is made in pieces, as it is in tiles: the bytes are the same.
bool is_divided(const std::vector<std::string>& files, const OperandArguments& arguments,
                const Destination& to, std::span<const TriMesh> meshes, const Boxes& boxes,
                const DistrictMargin& margin) {
  if (!arguments.cross_check.empty() || arguments.timing || !why_not_tiled(to).empty() ||
      !std::ranges::all_of(files, can_be_read_again)) {
    return false;
  }
  std::vector<std::size_t> triangles;
  std::ranges::transform(meshes, std::back_inserter(triangles),
                         [](const TriMesh& mesh) { return mesh.triangles.size(); });
  return !operand_pieces(operand_districts(boxes, margin),
                         {boxes, triangles, arguments.tiles.most_undivided(), {}})
              .seams.empty();
}

/// Reads the files, does the task with their solids, settles contacts, writes.
OutputReport at_once(const std::vector<std::string>& files, const OperandArguments& arguments,
                     const Destination& to, const CommonOptions& common, const Task& task,
                     const Ranks& ranks) {
  const auto engine = cross_check_engine(arguments.cross_check);
  StageClock clock;
  clock.begin("read");
  std::vector<Input> inputs = read_inputs(files);
  const MeshHeader header{common_unit(inputs), {}};
  const ContactChoice contacts = contact_choice(arguments.contacts, header.unit);
  const RoundingOptions rounding = rounding_options(arguments.rounding, header.unit);
  std::vector<TriMesh> meshes = read_meshes(inputs);
  Boxes boxes(task.is_union ? meshes.size() : 0);
  for_each_in_parallel(boxes.size(), [&](std::size_t i) { boxes[i] = box_of(meshes[i]); });
  if (task.is_union &&
      is_divided(files, arguments, to, meshes, boxes, district_margin(to, rounding, contacts))) {
    meshes = {};
    return in_tiles(files, arguments, to, common, ranks);
  }
  clock.begin("prove");
  std::vector<FileRepair> repairs;
  const std::vector<Solid> operands =
      prove_operands(std::move(meshes), inputs, arguments.repair, repairs);
  OutputReport report;
  {
    ProgressLine line(common.quiet);
    const Progress progress = arguments.timing ? clock.progress(line.callback()) : line.callback();
    clock.begin("load");
    const Result result = result_of(task, operands, boxes, district_margin(to, rounding, contacts),
                                    {contacts.policy(), progress});
    std::optional<CrossCheck> check;
    if (engine) {
      clock.begin("cross-check");
      check = task.second_opinion(
          result.solids.size() == 1 ? result.solids.front() : joined(result.solids, result.boxes),
          *engine, operands, line.callback());
    }
    report = write_result(result, to, common, rounding, header, contacts, progress);
    report.cross_check = std::move(check);
  }
  report.repairs = std::move(repairs);
  if (arguments.timing) {
    report.timing = clock.times();
  }
  return report;
}

ExitCode run_operation(const std::vector<std::string>& files, const OperandArguments& arguments,
                       const CommonOptions& common, const Task& task) {
  refuse_tolerance(arguments.command, common, "--rounding-tolerance");
  const Destination to = destination(arguments.output);
  const Ranks ranks;
  const OutputReport report = is_tiled(arguments.tiles) || ranks.count() > 1
                                  ? in_tiles(files, arguments, to, common, ranks)
                                  : at_once(files, arguments, to, common, task, ranks);
  if (!ranks.is_first()) {
    return ExitCode::ok;
  }
  print_written(report, to, common);
  return report.findings() == 0 ? ExitCode::ok : ExitCode::findings;
}

Expression parsed(const std::string& text) {
  try {
    return Expression::parse(text);
  } catch (const Error& error) {
    throw UsageError(error.message() + ", at column " + error.where());
  }
}

/// Files by the operand's name, each of which `expression` names.
std::map<std::string, std::string> named_files(const Expression& expression,
                                               const std::vector<std::string>& operands) {
  std::map<std::string, std::string> files;
  const auto& names = expression.names();
  for (const std::string& operand : operands) {
    const std::size_t equals = operand.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == operand.size()) {
      throw UsageError("an operand must be NAME=FILE, not '" + operand + "'");
    }
    const std::string name = operand.substr(0, equals);
    if (!files.emplace(name, operand.substr(equals + 1)).second) {
      throw UsageError("the operand '" + name + "' is given twice");
    }
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw UsageError("the operand '" + name + "' is not in the expression");
    }
  }
  const auto missing = std::find_if(names.begin(), names.end(),
                                    [&](const std::string& name) { return !files.contains(name); });
  if (missing != names.end()) {
    throw UsageError("the expression names '" + *missing + "', but there is no " + *missing +
                     "=FILE");
  }
  return files;
}

ExitCode run_expression(const ExpressionArguments& arguments, const CommonOptions& common) {
  const Expression expression = parsed(arguments.expression);
  const auto file_of = named_files(expression, arguments.common.operands);
  std::vector<std::string> files;
  files.reserve(expression.names().size());
  for (const std::string& name : expression.names()) {
    files.push_back(file_of.at(name));
  }
  const auto named = [&](std::span<const Solid> solids) {
    std::map<std::string, Solid> operands;
    for (std::size_t i = 0; i < solids.size(); ++i) {
      operands.emplace(expression.names()[i], solids[i]);
    }
    return operands;
  };
  const Task task{[&](std::span<const Solid> solids, const BooleanOptions& options) {
                    return evaluate(expression, named(solids), options);
                  },
                  [&](const Solid& result, CrossCheckEngine engine, std::span<const Solid> solids,
                      const Progress& progress) {
                    return second_opinion(result, engine, expression, named(solids), progress);
                  }};
  return run_operation(files, arguments.common, common, task);
}

void add_operand_options(CLI::App& command, OperandArguments& arguments) {
  command.add_option("-o,--output", arguments.output.path, "mesh file; - for standard output")
      ->type_name("OUT")
      ->required();
  add_output_options(command, arguments.output);
  add_contacts_option(command, arguments.contacts);
  command.add_flag("--repair", arguments.repair,
                   "Mend operands that are no solids, where that is safe, and say how: merge\n"
                   "identical points, drop degenerate and duplicate faces, turn faces round,\n"
                   "unite what overlaps; holes are never filled");
  add_cross_check_option(command, arguments.cross_check);
  command.add_flag("--timing", arguments.timing,
                   "Say how many seconds each stage took: in the report with --json,\n"
                   "else on standard error");
  add_rounding_options(command, arguments.rounding);
  arguments.command = command.get_name();
}

ExitCode run_boolean(SetOperation operation, const OperandArguments& arguments,
                     const CommonOptions& common) {
  const Task task{[=](std::span<const Solid> operands, const BooleanOptions& options) {
                    return combined(operation, operands, options);
                  },
                  [=](const Solid& result, CrossCheckEngine engine, std::span<const Solid> operands,
                      const Progress& progress) {
                    return second_opinion(result, engine, operation, operands, progress);
                  },
                  operation == SetOperation::unite};
  return run_operation(arguments.operands, arguments, common, task);
}

void add_boolean(CLI::App& app, Action& action, const BooleanCommand& boolean) {
  CLI::App* command = app.add_subcommand(boolean.name, boolean.purpose);
  const auto arguments = std::make_shared<OperandArguments>();
  command->add_option("IN", arguments->operands, "solids; - for standard input")
      ->type_name("")
      ->required()
      ->expected(2, -1);
  add_operand_options(*command, *arguments);
  if (boolean.operation == SetOperation::unite) {
    add_tile_options(*command, arguments->tiles, tiles_of("operands"));
    command->add_option("--piece", arguments->tiles.piece)->group("");  // for tests, in no help
  }
  command->footer(boolean.footer);
  command->callback([arguments, boolean, &action] {
    action = [arguments, boolean](const CommonOptions& common) {
      return run_boolean(boolean.operation, *arguments, common);
    };
  });
}

void add_expression(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("boolean", "A set expression of solids, in one exact arrangement");
  const auto arguments = std::make_shared<ExpressionArguments>();
  command
      ->add_option("EXPRESSION", arguments->expression,
                   "a + b unites, a - b subtracts, a & b intersects (and binds tighter)")
      ->type_name("")
      ->required();
  command->add_option("NAME=FILE", arguments->common.operands, "the solid that a name stands for")
      ->type_name("")
      ->required()
      ->expected(1, -1);
  add_operand_options(*command, arguments->common);
  command->footer(
      "A name is a run of letters, digits, _ and ., or anything in double quotes.\n\n"
      "Examples:\n"
      "  dupin boolean \"(a + b) - c & d\" a=f.off b=g.stl c=h.off d=i.off -o out.stl");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) {
      return run_expression(*arguments, common);
    };
  });
}

}  // namespace

void add_booleans(CLI::App& app, Action& action) {
  add_boolean(app, action,
              {"union", "Unite solids, exactly",
               "Examples:\n"
               "  dupin union header.off branch.stl -o both.off\n"
               "  dupin union a.off b.off c.off -o - --format stl > all.stl\n"
               "  dupin union line*.stl -o plant.stl --memory 4GB",
               SetOperation::unite});
  add_boolean(app, action,
              {"intersect", "What solids have in common, exactly",
               "Examples:\n  dupin intersect a.off b.off -o common.off", SetOperation::intersect});
  add_boolean(app, action,
              {"subtract", "The first solid without all the others, exactly",
               "Examples:\n  dupin subtract block.off drill1.off drill2.off -o part.stl",
               SetOperation::subtract});
  add_expression(app, action);
}

}  // namespace dupin::cli
