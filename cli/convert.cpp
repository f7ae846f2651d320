#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <vector>

#include <CLI/App.hpp>

#include "argument_checks.h"
#include "commands.h"
#include "document.h"
#include "dupin/blends/unit.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/placement.h"
#include "input.h"
#include "length.h"
#include "mesh_to_mesh.h"
#include "output.h"
#include "placement_options.h"
#include "report_text.h"
#include "source_text.h"

namespace dupin::cli {
namespace {

/// True when every coordinate is a number of the format already.
bool fits(const TriMesh& mesh, Coordinates coordinates) {
  return std::all_of(mesh.points.begin(), mesh.points.end(),
                     [&](const Vec3& point) { return point == nearest(point, coordinates); });
}

/// Points that are one to readers who tell them by place alone, as those where a solid touches
/// itself.
bool has_points_in_one_place(const TriMesh& mesh) {
  std::vector<Vec3> points = mesh.points;
  std::ranges::sort(points, [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  return std::ranges::adjacent_find(points) != points.end();
}

/// Whether the format gives back every point of the mesh as it is.
bool holds(const MeshFormat& format, const TriMesh& mesh) {
  return fits(mesh, format.coordinates) && !(format.merges_points && has_points_in_one_place(mesh));
}

struct ConvertArguments {
  MeshToMesh files;
  PlacementArguments placement;
  std::string unit;  ///< of the result
  SourceArguments source;
  WallArguments walls;
};

bool names_mesh(const std::string& path) {
  try {
    (void)format_of(path);
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// What says how numbers are rounded.
bool is_of_numbers(const MeshToMesh& files) {
  const RoundingArguments& rounding = files.rounding;
  return !rounding.origin.empty() || !rounding.grid.empty() || !rounding.tolerance.empty();
}

void refuse_of_document(const ConvertArguments& all) {
  const OutputArguments& output = all.files.output;
  if (!all.placement.empty() || !all.unit.empty()) {
    throw UsageError(
        "--translate, --rotate, --scale and --to-unit are for meshes; convert to .json first");
  }
  if (is_of_numbers(all.files) || !output.patches.empty() || !output.verification.empty() ||
      output.no_verify) {
    throw UsageError(
        "--origin, --grid, --rounding-tolerance, --patches, --verify and --no-verify are for "
        "meshes, and convert makes a document of a graph or piping file");
  }
}

/// A graph or piping file as the document that it is made into.
ExitCode write_document(const Input& input, const ConvertArguments& all,
                        const CommonOptions& common) {
  refuse_of_document(all);
  const std::string& path = all.files.output.path;
  if (names_mesh(path) || !all.files.output.format.empty()) {
    throw UsageError(
        "convert makes a document of a graph or piping file, such as OUT.json; build "
        "makes a mesh of it");
  }
  if (are_one_file(all.files.input, path)) {
    throw UsageError("OUT would take the place of what is read: " + path);
  }
  Document document = read_document(input, all.source, all.walls);
  if (!common.tolerance.empty()) {
    document.assembly.tolerance = length_in(document.assembly.unit, common.tolerance, 0);
  }
  write_text(path, document_text(document.assembly));
  BuildReport report;
  report.graph = std::move(document.network);
  report.piping = std::move(document.piping);
  if (output_path(path) != "-" && common.json) {
    std::cout << source_json(report) << '\n';
  } else if (output_path(path) != "-" && !common.quiet) {
    print_source(std::cout, report);
    print_row(std::cout, "parts", std::to_string(document.assembly.parts.size()));
    print_row(std::cout, "written", path);
  }
  return report.source_findings() == 0 ? ExitCode::ok : ExitCode::findings;
}

/// How many microns one of the unit is, a whole number.
double microns(const std::string& unit) {
  return unit == "um" ? 1 : std::round(1000 * millimetres(unit_from(unit)));
}

/// The moves that are asked for, then the numbers in another unit.
Placement placement_of(const ConvertArguments& all, const std::string& stated) {
  Placement where = placement(all.placement, stated);
  if (!all.unit.empty()) {
    where.scale(microns(stated.empty() ? "mm" : stated), microns(all.unit));
  }
  return where;
}

/// What is a solid is put elsewhere in exact coordinates and stays one; the points of other meshes
/// are rounded each by itself.
OutputReport write_placed(const TriMesh& mesh, bool is_solid, const Placement& placement,
                          const Destination& to, const RoundingOptions& rounding,
                          const MeshHeader& header) {
  double radius = 0;
  for (const Vec3& point : mesh.points) {
    radius = std::max(radius, point.allFinite() ? point.stableNorm() : 0);
  }
  const double error = placement.error(radius);
  if (is_solid) {
    OutputReport report = write_solid(placed(Solid::from(mesh), placement), to, rounding, header);
    report.placement = {placement.is_exact() && report.rounding.moved == 0,
                        error + report.rounding.largest_move};
    return report;
  }
  const PlacedMesh elsewhere = placed(mesh, placement);
  OutputReport report = write_plain(elsewhere.mesh, to, header);
  report.placement = {placement.is_exact() && elsewhere.is_exact && report.rounding.moved == 0,
                      error + elsewhere.largest_move + report.rounding.largest_move};
  return report;
}

ExitCode run_convert(const ConvertArguments& all, const CommonOptions& common) {
  const MeshToMesh& arguments = all.files;
  const Input input = read_input(arguments.input);
  if (is_source(input)) {
    return write_document(input, all, common);
  }
  refuse_tolerance("convert", common, "--rounding-tolerance");
  refuse_of_mesh(input.name, all.source, all.walls);
  const Destination to = destination(arguments.output);
  const std::string stated = input.unit();
  const MeshHeader header{all.unit.empty() ? stated : all.unit, {}};
  const RoundingOptions rounding = rounding_options(arguments.rounding, header.unit);
  // What is not rounded need not be proved a solid, unless that is asked for.
  const bool unchanged = !is_of_numbers(arguments) && to.patches.empty() &&
                         arguments.output.verification != name(Verification::compare);
  const TriMesh mesh = read_mesh(input.bytes, input.name);
  const bool is_placed = !all.placement.empty() || (!all.unit.empty() && all.unit != stated);
  const bool stays_solid =
      (is_placed || !unchanged || !holds(to.format, mesh)) && check(mesh).is_solid();
  if (is_of_numbers(arguments) && !stays_solid) {
    throw UsageError("--origin, --grid and --rounding-tolerance are for solids, and " + input.name +
                     " is none: see dupin check");
  }
  if (is_placed) {
    const Placement where = placement_of(all, stated);
    print_written(write_placed(mesh, stays_solid, where, to, rounding, header), to, common);
    return ExitCode::ok;
  }
  print_written(stays_solid ? write_solid(Solid::from(mesh), to, rounding, header)
                            : write_plain(mesh, to, header),
                to, common);
  return ExitCode::ok;
}

}  // namespace

void add_convert(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "convert", "Write a mesh in another format, or a graph or piping file as a document");
  const auto arguments = std::make_shared<ConvertArguments>();
  add_mesh_to_mesh_options(*command, "mesh file, graph or piping file", arguments->files);
  add_placement_options(*command, arguments->placement);
  command
      ->add_option("--to-unit", arguments->unit,
                   "Coordinates in this unit, um, mm, cm, m, in or ft, instead of the mesh's\n"
                   "own, or of millimetres where it states none")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"um", "mm", "cm", "m", "in", "ft"}));
  add_source_options(*command, arguments->source);
  add_wall_options(*command, arguments->walls);
  command->footer(
      "A solid whose coordinates the format cannot hold, or that touches itself where readers of\n"
      "STL would weld it, is changed so that it stays one; any other mesh is written as it is.\n"
      "Moves, turns and changes of size are exact, and rounded once.\n\n"
      "Examples:\n"
      "  dupin convert part.off part.stl\n"
      "  dupin convert line.pcf line.json --bridge 1mm\n"
      "  dupin convert part.3mf part.stl --to-unit in\n"
      "  dupin convert valve.stl placed.stl --rotate 0,0,1,90 --translate 1.5m,0,-20mm\n"
      "  dupin convert - - --format off < part.stl > part.off");
  command->callback([arguments, command, &action] {
    arguments->placement.collect(*command);
    action = [arguments](const CommonOptions& common) { return run_convert(*arguments, common); };
  });
}

}  // namespace dupin::cli
