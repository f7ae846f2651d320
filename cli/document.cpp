#include "document.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>

#include "argument_checks.h"
#include "dupin/io/graph_file.h"
#include "dupin/io/pcf.h"
#include "dupin/io/stl.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"

namespace dupin::cli {
namespace {

BoreMeaning bore_meaning(const std::string& typed) {
  return typed == "outside"   ? BoreMeaning::outside
         : typed == "nominal" ? BoreMeaning::nominal
                              : BoreMeaning::automatic;
}

// Only what it is for may be given.
void refuse_foreign(const SourceArguments& arguments, const std::string& wall, DocumentKind kind) {
  const bool is_of_graph = !arguments.radius.empty() || !arguments.unit.empty();
  if (kind == DocumentKind::piping) {
    if (is_of_graph) {
      throw UsageError("--radius and --unit are for graphs, files named .swc or .graph");
    }
    if (!arguments.schedule.empty() && !wall.empty()) {
      throw UsageError("--schedule and --wall both say how thick walls are; give one of them");
    }
    return;
  }
  if (!arguments.snap.empty() || !arguments.bridge.empty() || !arguments.bore.empty() ||
      !arguments.schedule.empty() || !arguments.fillet.empty() || arguments.strict) {
    throw UsageError(
        "--snap, --bridge, --bore, --schedule, --fillet and --strict are for piping files, named "
        ".pcf");
  }
  if (kind == DocumentKind::assembly && (is_of_graph || arguments.keep_going)) {
    throw UsageError(
        "--radius, --unit and --keep-going are for graphs, files named .swc or .graph, and "
        "--keep-going for piping files, named .pcf");
  }
}

// A side is one of walls.
void refuse_idle_side(const WallArguments& walls, const Assembly& assembly) {
  const bool has_walls =
      assembly.wall.value_or(0) > 0 || std::ranges::any_of(assembly.parts, [](const Part& part) {
        return part.wall.value_or(0) > 0;
      });
  if (!walls.side.empty() && !has_walls) {
    throw UsageError("--wall-side says where walls are, and nothing in " + assembly.source +
                     " has one; give --wall, too, or leave it out");
  }
}

// None for an empty text.
std::optional<double> length_if_given(Unit unit, const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(length_in(unit, text, 0));
}

SourceOptions source_options(const SourceArguments& arguments, const std::string& wall,
                             DocumentKind kind) {
  SourceOptions options;
  options.unit = unit_called(arguments.unit).value_or(Unit::millimetre);
  options.radius = length_if_given(options.unit, arguments.radius);
  options.snap = length_if_given(Unit::millimetre, arguments.snap);
  options.bridge = length_in(Unit::millimetre, arguments.bridge, 0);
  options.bores = bore_meaning(arguments.bore);
  options.schedule = arguments.schedule;
  options.fillet = arguments.fillet == "auto" ? std::optional(0.0)
                                              : length_if_given(Unit::millimetre, arguments.fillet);
  if (kind == DocumentKind::piping) {
    options.wall = length_if_given(Unit::millimetre, wall);
  }
  options.keep_going = arguments.keep_going;
  options.is_strict = arguments.strict;
  return options;
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

}  // namespace

bool is_given(const SourceArguments& arguments) {
  const auto& [radius, unit, snap, bridge, bore, schedule, fillet, keep_going, strict] = arguments;
  return keep_going || strict ||
         !(radius.empty() && unit.empty() && snap.empty() && bridge.empty() && bore.empty() &&
           schedule.empty() && fillet.empty());
}

void refuse_idle_insulation(const WallArguments& walls, const std::string& region) {
  if (!walls.insulation.empty() && region != name(Region::insulation)) {
    throw UsageError(
        "--insulation is for what is about the parts; give --region insulation, too, or leave it "
        "out");
  }
}

void refuse_of_mesh(const std::string& name, const SourceArguments& arguments,
                    const WallArguments& walls) {
  refuse_foreign(arguments, walls.wall, DocumentKind::assembly);
  if (!walls.empty()) {
    throw UsageError(
        "--wall, --wall-side and --insulation are for documents, graphs and piping files, and " +
        name + " is a mesh");
  }
}

std::vector<std::string> meshes_beside(const Assembly& assembly) {
  const std::filesystem::path folder = std::filesystem::path(assembly.source).parent_path();
  std::vector<std::string> meshes;
  for (const Part& part : assembly.parts) {
    for (const std::string& file : meshes_avoided_by(part.shape)) {
      meshes.push_back((folder / file).string());
    }
  }
  return meshes;
}

void require_meshes_not_written(const Assembly& assembly) {
  std::ranges::for_each(meshes_beside(assembly), require_not_written);
}

Assembly read_document(const std::string& path) {
  return read_document(path, SourceArguments{}).assembly;
}

DocumentKind kind_of(const Input& input) {
  const DocumentKind kind = document_kind(input.name);
  if (kind != DocumentKind::assembly || input.name != kStandardInput ||
      has_size_of_binary_stl(input.bytes)) {
    return kind;
  }
  return is_pcf_text(input.bytes)     ? DocumentKind::piping
         : is_graph_text(input.bytes) ? DocumentKind::graph
                                      : DocumentKind::assembly;
}

bool is_source(const Input& input) { return kind_of(input) != DocumentKind::assembly; }

Document read_document(const std::string& path, const SourceArguments& arguments,
                       const WallArguments& walls, const Progress& progress) {
  return read_document(read_input(path), arguments, walls, progress);
}

Document read_document(const Input& input, const SourceArguments& arguments,
                       const WallArguments& walls, const Progress& progress) {
  const DocumentKind kind = kind_of(input);
  refuse_foreign(arguments, walls.wall, kind);
  SourceOptions options = source_options(arguments, walls.wall, kind);
  options.progress = progress;
  tell(progress, "read");
  Document document = document_of(input.bytes, input.name, kind, options);
  require_meshes_not_written(document.assembly);
  const auto apply = [&](Assembly& assembly) {
    if (!walls.wall.empty()) {
      assembly.wall = document_length("--wall", assembly.unit, walls.wall, 0);
    }
    if (!walls.insulation.empty()) {
      assembly.insulation = document_length("--insulation", assembly.unit, walls.insulation, 0);
    }
    for (const WallSide side : {WallSide::inwards, WallSide::outwards, WallSide::centred}) {
      if (walls.side == name(side)) {
        assembly.wall_side = side;
      }
    }
  };
  apply(document.assembly);
  refuse_idle_side(walls, document.assembly);
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

void add_region_option(CLI::App& command, std::string& region) {
  command
      .add_option("--region", region,
                  "outer, metal, fluid or insulation; metal if not given,\nwhere there are walls")
      ->type_name("REGION")
      ->check(CLI::IsMember({"outer", "metal", "fluid", "insulation"}));
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

GapSummary measure_ends(const Input& input, const SourceArguments& arguments,
                        const std::string& connect) {
  if (kind_of(input) == DocumentKind::piping) {
    return piping_gap_summary(input.bytes, input.name, bore_meaning(arguments.bore),
                              length_if_given(Unit::millimetre, connect), arguments.keep_going);
  }
  const Document document = read_document(input, arguments);
  return gap_summary(document, length_if_given(document.assembly.unit, connect));
}

}  // namespace dupin::cli
