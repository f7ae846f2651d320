#include "document.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>

#include "argument_checks.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/graph_file.h"
#include "dupin/io/pcf.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"

namespace dupin::cli {
namespace {

// Ends of a piping file that are measured as a pair, in millimetres.
constexpr double kConnectPiping = 1;

BoreMeaning bore_meaning(const std::string& typed) {
  return typed == "outside"   ? BoreMeaning::outside
         : typed == "nominal" ? BoreMeaning::nominal
                              : BoreMeaning::automatic;
}

Document read_piping(const Input& input, const SourceArguments& arguments, const std::string& wall,
                     const Progress& progress) {
  if (!arguments.radius.empty() || !arguments.unit.empty()) {
    throw UsageError("--radius and --unit are for graphs, files named .swc or .graph");
  }
  PipingOptions options;
  options.snap = length_in(Unit::millimetre, arguments.snap, options.snap);
  options.bridge = length_in(Unit::millimetre, arguments.bridge, 0);
  options.keep_going = arguments.keep_going;
  options.progress = progress;
  if (!arguments.fillet.empty()) {
    options.fillet =
        arguments.fillet == "auto" ? 0 : length_in(Unit::millimetre, arguments.fillet, 0);
  }
  if (!wall.empty()) {
    options.wall = length_in(Unit::millimetre, wall, 0);
  }
  PcfReport report;
  report.snap = options.snap;
  report.bridge = options.bridge;
  report.is_strict = arguments.strict;
  report.file = parse_pcf(input.bytes, input.name, bore_meaning(arguments.bore));
  if (!arguments.schedule.empty()) {
    if (!wall.empty()) {
      throw UsageError("--schedule and --wall both say how thick walls are; give one of them");
    }
    give_walls(report.file, arguments.schedule);
  }
  PipingLine line = std::exchange(report.file.line, {});
  report.network = assembly_of(line, options);
  Assembly assembly = std::exchange(report.network.assembly, {});
  Document document{std::move(assembly)};
  document.piping = std::move(report);
  document.line = std::move(line);
  document.piping_options = std::move(options);
  return document;
}

void add_piping_options(CLI::App& command, SourceArguments& arguments) {
  command
      .add_option("--snap", arguments.snap,
                  "Ends of a piping file up to this far apart are one point; 0.05 mm if\n"
                  "not given")
      ->type_name("LENGTH");
  command
      .add_option("--bridge", arguments.bridge,
                  "Ends of a piping file up to this far apart are joined by a part of their\n"
                  "own; none if not given")
      ->type_name("LENGTH");
  add_bore_option(command, arguments.bore);
  command
      .add_option("--schedule", arguments.schedule,
                  "Walls of a piping file's components that say none, by ASME B36.10M:\n"
                  "40, STD, ...")
      ->type_name("NAME");
  command
      .add_option("--fillet", arguments.fillet,
                  "Radius of the ball of fillets at a piping file's tees; auto: a quarter\n"
                  "of the branch's radius, or the most that fits")
      ->type_name("LENGTH|auto");
  command.add_flag("--strict", arguments.strict,
                   "Lines of a piping file that are not understood count (exit code 1)");
}

// As the document names them.
std::vector<std::string> meshes_avoided_by(const PartShape& shape) {
  const auto* const avoidance = std::visit(
      [](const auto& kind) -> const Avoidance* {
        if constexpr (requires { kind.avoid; }) {
          return kind.avoid ? &*kind.avoid : nullptr;
        } else {
          return nullptr;
        }
      },
      shape);
  std::vector<std::string> files;
  if (avoidance != nullptr) {
    for (const auto& obstacle : avoidance->obstacles) {
      if (const auto* const mesh = std::get_if<MeshObstacle>(&obstacle)) {
        files.push_back(mesh->file);
      }
    }
  }
  return files;
}

// Without the wall, but of a piping file.
Document document_of(const Input& input, const SourceArguments& arguments, const std::string& wall,
                     const Progress& progress) {
  tell(progress, "read");
  if (is_piping(input)) {
    return read_piping(input, arguments, wall, progress);
  }
  if (!arguments.snap.empty() || !arguments.bridge.empty() || !arguments.bore.empty() ||
      !arguments.schedule.empty() || !arguments.fillet.empty() || arguments.strict) {
    throw UsageError(
        "--snap, --bridge, --bore, --schedule, --fillet and --strict are for piping files, named "
        ".pcf");
  }
  if (!is_graph(input)) {
    if (!arguments.radius.empty() || !arguments.unit.empty() || arguments.keep_going) {
      throw UsageError(
          "--radius, --unit and --keep-going are for graphs, files named .swc or .graph, and "
          "--keep-going for piping files, named .pcf");
    }
    AssemblyDocument parsed = parse_document(input.bytes, input.name);
    Document document{std::move(parsed.assembly)};
    document.colours = std::move(parsed.colours);
    return document;
  }
  PipeGraphOptions options;
  options.keep_going = arguments.keep_going;
  options.unit = unit_called(arguments.unit).value_or(Unit::millimetre);
  if (!arguments.radius.empty()) {
    options.radius = length_in(options.unit, arguments.radius, 0);
  }
  std::vector<SourceNote> notes;
  PipeGraph graph =
      parse_graph_file(input.bytes, input.name, arguments.keep_going ? &notes : nullptr);
  graph.notes = std::move(notes);
  PipeNetwork network = assembly_of(graph, options);
  return {std::exchange(network.assembly, {}), std::move(network), std::move(graph),
          std::move(options)};
}

}  // namespace

void require_meshes_not_written(const Assembly& assembly) {
  const std::filesystem::path folder = std::filesystem::path(assembly.source).parent_path();
  for (const Part& part : assembly.parts) {
    for (const std::string& file : meshes_avoided_by(part.shape)) {
      require_not_written((folder / file).string());
    }
  }
}

Assembly read_document(const std::string& path) {
  return read_document(path, SourceArguments{}).assembly;
}

bool is_graph(const Input& input) {
  const bool has_name = input.name != kStandardInput;
  return is_graph_file(input.name) || (!has_name && is_graph_text(input.bytes));
}

bool is_piping(const Input& input) {
  return is_pcf_file(input.name) || (input.name == kStandardInput && is_pcf_text(input.bytes));
}

bool is_source(const Input& input) { return is_graph(input) || is_piping(input); }

Built build_document(Document& document, const BuildOptions& options) {
  if (document.network) {
    PipeNetwork network = std::move(*document.network);
    network.assembly = std::exchange(document.assembly, {});
    Built built = build(document.graph, document.graph_options, network, options);
    document.assembly = std::exchange(network.assembly, {});
    document.network = std::move(network);
    return built;
  }
  if (!document.piping) {
    return build(document.assembly, options);
  }
  PipingNetwork& network = document.piping->network;
  network.assembly = std::exchange(document.assembly, {});
  Built built = build(document.line, document.piping_options, network, options);
  document.assembly = std::exchange(network.assembly, {});
  return built;
}

void take(BuildReport& report, Built&& built, Document& document, double connect) {
  const Assembly& assembly = document.assembly;
  report.graph = document.network;
  report.piping = std::move(document.piping);
  report.gaps = {assembly.source, assembly.unit, connect, std::move(built.ports),
                 std::move(built.gaps)};
  report.output.cross_check = std::move(built.cross_check);
  report.parts = std::move(built.parts);
  report.runs = built.runs;
  report.pieces = built.pieces;
  report.grid = built.grid;
  report.region = built.region;
  report.volumes = built.volumes;
  report.insulation = built.insulation;
}

Document read_document(const std::string& path, const SourceArguments& arguments,
                       const WallArguments& walls, const Progress& progress) {
  return read_document(read_input(path), arguments, walls, progress);
}

Document read_document(const Input& input, const SourceArguments& arguments,
                       const WallArguments& walls, const Progress& progress) {
  Document document = document_of(input, arguments, walls.wall, progress);
  require_meshes_not_written(document.assembly);
  const auto apply = [&](Assembly& assembly) {
    if (!walls.wall.empty()) {
      assembly.wall = length_in(assembly.unit, walls.wall, 0);
    }
    if (!walls.insulation.empty()) {
      assembly.insulation = length_in(assembly.unit, walls.insulation, 0);
    }
    for (const WallSide side : {WallSide::inwards, WallSide::outwards, WallSide::centred}) {
      if (walls.side == name(side)) {
        assembly.wall_side = side;
      }
    }
  };
  apply(document.assembly);
  if (document.piping) {  // for networks that are made anew
    document.piping_options.wall_side = document.assembly.wall_side;
    document.piping_options.insulation = document.assembly.insulation;
  }
  return document;
}

void add_bore_option(CLI::App& command, std::string& bore) {
  command
      .add_option("--bore", bore,
                  "Whether a piping file's bores are outside diameters or nominal; found\n"
                  "out for each if not given")
      ->type_name("MEANING")
      ->check(CLI::IsMember({"outside", "nominal"}));
}

void add_wall_options(CLI::App& command, WallArguments& walls) {
  command.add_option("--wall", walls.wall, "Thickness of the walls, instead of the document's")
      ->type_name("LENGTH");
  command
      .add_option("--wall-side", walls.side,
                  "Where walls are, seen from the document's radii: inwards, if not given,\n"
                  "outwards, or centred")
      ->type_name("SIDE")
      ->check(CLI::IsMember({"inwards", "outwards", "centred"}));
  command
      .add_option("--insulation", walls.insulation,
                  "Thickness of the insulation outside, instead of the document's")
      ->type_name("LENGTH");
}

void add_region_option(CLI::App& command, std::string& region, bool has_insulation) {
  std::vector<std::string> names{"outer", "metal", "fluid"};
  if (has_insulation) {
    names.emplace_back("insulation");
  }
  command
      .add_option("--region", region,
                  std::string("outer, metal") +
                      (has_insulation ? ", fluid or insulation" : " or fluid") +
                      "; metal if not given,\nwhere there are walls")
      ->type_name("REGION")
      ->check(CLI::IsMember(names));
}

std::optional<Region> region_named(const std::string& name) {
  for (const Region region : {Region::outer, Region::metal, Region::fluid, Region::insulation}) {
    if (name == dupin::name(region)) {
      return region;
    }
  }
  return std::nullopt;
}

void add_graph_options(CLI::App& command, SourceArguments& arguments) {
  command
      .add_option("--radius", arguments.radius,
                  "Of a graph's nodes that have none, or none that is positive")
      ->type_name("LENGTH");
  command.add_flag("--keep-going", arguments.keep_going,
                   "Leave out what is refused of a graph or piping file, and say so (exit\n"
                   "code 1)");
  command.add_option("--unit", arguments.unit, "Of a graph's numbers; mm if not given")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "cm", "m", "in", "ft"}));
}

void add_source_options(CLI::App& command, SourceArguments& arguments) {
  add_graph_options(command, arguments);
  add_piping_options(command, arguments);
}

void add_connect_option(CLI::App& command, std::string& connect) {
  command
      .add_option("--connect", connect,
                  "Ends up to this far apart belong together; the document's\n"
                  "tolerance if not given")
      ->type_name("LENGTH");
}

void add_triangles_option(CLI::App& command, std::size_t& most_triangles) {
  command
      .add_option("--triangles", most_triangles,
                  "The most that the parts' meshes may have, by an estimate made before\n"
                  "they are: 4 million if not given")
      ->type_name("NUMBER")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000'000}));
}

GapSummary measure_piping(const Input& input, const std::string& bore, const std::string& connect) {
  GapSummary summary;
  summary.file = input.name;
  summary.connect = length_in(Unit::millimetre, connect, kConnectPiping);
  summary.ports = ports(parse_pcf(input.bytes, input.name, bore_meaning(bore)).line);
  summary.pairs = pair_ends(summary.ports, summary.connect);
  return summary;
}

GapSummary measure_document(const Assembly& assembly, const std::string& connect) {
  GapSummary summary;
  summary.file = assembly.source;
  summary.unit = assembly.unit;
  summary.connect = length_in(assembly.unit, connect, assembly.tolerance);
  summary.ports = ports(resolve(assembly));
  summary.pairs = pair_ends(summary.ports, summary.connect);
  return summary;
}

}  // namespace dupin::cli
