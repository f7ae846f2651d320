#include "dupin/blends/build.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "batch.h"
#include "build_arguments.h"
#include "commands.h"
#include "cross_check_option.h"
#include "document.h"
#include "dupin/blends/drawing.h"
#include "dupin/blends/tessellation.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/remesh.h"
#include "exchange_options.h"
#include "gap_text.h"
#include "idle_options.h"
#include "length.h"
#include "output.h"
#include "progress_line.h"
#include "report_page_file.h"
#include "report_text.h"
#include "rounding_options.h"
#include "solver_options.h"
#include "source_text.h"
#include "tiles/district_output.h"
#include "tiles/tile_options.h"
#include "tiles/tiled_build.h"

namespace dupin::cli {
namespace {

/// Fewer parts of a piping file or graph are not looked at for what may be divided: what is,
/// has more.
constexpr std::size_t kManyParts = 32;

/// "3 (2 pipe, 1 cyclic_blend)".
std::string parts_text(const std::vector<PartReport>& parts) {
  std::map<std::string, std::size_t> kinds;
  for (const PartReport& part : parts) {
    ++kinds[part.kind];
  }
  std::string text = std::to_string(parts.size());
  std::string_view separator = " (";
  for (const auto& [kind, count] : kinds) {
    text += std::string(separator) + std::to_string(count) + " " + kind;
    separator = ", ";
  }
  return text + (parts.empty() ? "" : ")");
}

/// The part that comes closest to folding.
std::string margin_text(const std::vector<PartReport>& parts) {
  const PartReport* tightest = nullptr;
  for (const PartReport& part : parts) {
    if (part.margin_lower && (!tightest || *part.margin_lower < *tightest->margin_lower)) {
      tightest = &part;
    }
  }
  return tightest ? decimal_at_least(*tightest->margin_lower) + " (" + tightest->name + ")"
                  : "none";
}

/// The part whose bore is proved to keep away least.
std::string least_wall_text(const std::vector<PartReport>& parts, const std::string& unit) {
  const PartReport* thinnest = nullptr;
  std::size_t unproved = 0;
  for (const PartReport& part : parts) {
    if (part.least_wall && (!thinnest || *part.least_wall < *thinnest->least_wall)) {
      thinnest = &part;
    }
    unproved += part.is_hollow && !part.least_wall ? 1 : 0;
  }
  return (thinnest
              ? decimal_at_least(*thinnest->least_wall) + " " + unit + " (" + thinnest->name + ")"
              : "none proved") +
         (thinnest && unproved > 0 ? ", not proved of " + counted(unproved, "part") : "");
}

void print_build(std::ostream& out, const BuildReport& report) {
  double error = 0;
  std::optional<double> tangency;
  for (const PartReport& part : report.parts) {
    error = std::max(error, part.error_bound);
    tangency = std::max({tangency, part.start_tangency, part.end_tangency});
  }
  const std::string unit(symbol(report.gaps.unit));
  print_row(out, "parts", parts_text(report.parts));
  print_source(out, report);
  if (report.exchange) {
    print_exchange(out, *report.exchange, unit);
  } else {
    print_output(out, report.output, unit);
  }
  for (const PartReport& part : report.parts) {
    if (!part.construction.empty()) {
      print_row(out, "construction", part.construction + " (" + part.name + ")");
    }
    for (const std::string& reason : part.rejected) {
      print_row(out, "not", reason + " (" + part.name + ")");
    }
    for (const std::string& warning : part.warnings) {
      print_row(out, "warning", warning + " (" + part.name + ")");
    }
  }
  if (report.volumes) {
    print_row(out, "region", std::string(name(report.region)));
    print_row(out, "volumes",
              "outer " + number(report.volumes->outer) + ", metal " +
                  number(report.volumes->metal) + ", fluid " + number(report.volumes->fluid) + " " +
                  unit + "3");
  }
  if (report.insulation) {
    print_row(out, "region", "insulation of " + number(*report.insulation) + " " + unit + "3");
  }
  if (report.region == Region::metal || report.region == Region::fluid) {
    print_row(out, "least wall", least_wall_text(report.parts, unit));
  }
  print_row(out, "smallest margin", margin_text(report.parts));
  print_row(out, "mesh error", at_most(error, unit));
  if (tangency) {
    print_row(out, "tangent", "within " + decimal_at_most(*tangency) + " rad");
  }
  print_gaps(out, report.gaps);
}

BuildOptions build_options(const Assembly& assembly, const BuildArguments& arguments,
                           const CommonOptions& common) {
  BuildOptions options;
  if (!common.tolerance.empty()) {
    options.tolerance = document_length("--tolerance", assembly.unit, common.tolerance, 0);
  }
  if (arguments.segments > 0) {
    options.segments = arguments.segments;
  }
  options.most_triangles = arguments.most_triangles;
  options.connect = length_in(assembly.unit, arguments.connect, assembly.tolerance);
  options.contacts =
      contact_choice(arguments.contacts, std::string(symbol(assembly.unit))).policy();
  options.cross_check = cross_check_engine(arguments.cross_check);
  options.region = region_named(arguments.region);
  return options;
}

// What the file says of the solid: where it is from, and what colours were asked for.
MeshHeader header_of(const Document& document) {
  MeshHeader header{std::string(symbol(document.assembly.unit)), {}};
  header.name = std::filesystem::path(document.assembly.source).stem().string();
  header.colours = document.colours;
  return header;
}

// Meshes for solvers are made of solids that do not touch themselves: what --contacts chooses is
// done before, not when they are rounded.
Solid settled_for_solvers(const Solid& solid, const ContactChoice& contacts, OutputReport& report) {
  const Solid settled = settle(solid, contacts, report);
  require_something_left(report, settled.triangle_count());
  return settled;
}

// The solid as a file, as the arguments say.
void write_built(const Built& built, const Document& document, const BuildOptions& options,
                 const BuildArguments& arguments, BuildReport& report, TriMesh* written) {
  const std::string unit(symbol(document.assembly.unit));
  if (is_step(arguments.output)) {
    tell(options.progress, "STEP");
    ExchangeFile file = step_file(
        document.assembly, built,
        {options.tolerance, exchange_solids(arguments.output, arguments.solids), document.colours});
    write_exchange(file, arguments.output.path);
    report.exchange = std::move(file.report);
    report.output.file = report.exchange->file;
    report.output.format = report.exchange->format;
    return;
  }
  const MeshHeader header = header_of(document);
  RemeshOptions solver = solver_options(
      arguments.solver, 2 * options.tolerance.value_or(document.assembly.tolerance), unit);
  solver.progress = options.progress;
  const ContactChoice contacts = contact_choice(arguments.contacts, unit);
  OutputReport before;
  if (is_volume(arguments.output)) {
    report.output = write_volume(settled_for_solvers(built.solid, contacts, before), solver,
                                 arguments.output, header);
    report.output.settled = std::move(before.settled);
    return;
  }
  std::optional<SolverMeshReport> remeshed;
  Solid solid = built.solid;
  if (arguments.quality == kForSolvers) {
    Remeshed made = remesh(settled_for_solvers(solid, contacts, before), solver);
    solid = made.solid;
    remeshed = solver_report(std::move(made.report), solver);
  }
  const double distance = remeshed ? solver.distance : 0;
  const NormalsOf normals = [&](const TriMesh& mesh, double moved) {
    return smooth_normals(document.assembly, built, mesh, distance + moved);
  };
  const Destination to = destination(arguments.output);
  const RoundingOptions rounding = rounding_options(arguments.rounding, unit);
  report.output = built.districts.size() > 1 && !remeshed
                      ? write_districts(built.districts, built.boxes, to, rounding, header,
                                        contacts, written, normals)
                      : write_solid(solid, to, rounding, header, contacts, {}, written, normals);
  report.output.solver_mesh = std::move(remeshed);
  if (before.settled) {
    add_settled(*std::move(before.settled), report.output);
  }
}

}  // namespace

void check_destination(const BuildArguments& arguments) {
  if (!arguments.page.empty()) {
    require_page_file(arguments.page, arguments.output.path);
  }
  refuse_idle_options(arguments);
  if (is_step(arguments.output)) {
    (void)exchange_solids(arguments.output, arguments.solids);
    if (!arguments.page.empty()) {
      throw UsageError("--report shows a mesh that is written; the command report makes one");
    }
    return;
  }
  if (is_volume(arguments.output)) {
    check_volume_output(arguments.output);
    if (!arguments.page.empty()) {
      throw UsageError("--report shows a surface that is written; the command report makes one");
    }
  } else {
    (void)tiled_destination(arguments.output);
  }
  if (!arguments.solids.empty()) {
    throw UsageError("--solids is for STEP files");
  }
}

namespace {

// Whether districts are written one after the other.
bool is_in_districts(const BuildArguments& arguments, const Ranks& ranks) {
  return is_tiled(arguments.tiles) || ranks.count() > 1 || is_in_files(arguments.output);
}

// No piping file and no graph.
bool is_plain(const Document& document) { return !document.network && !document.piping; }

// Nothing where what hangs together is to be divided.
std::optional<Built> build_undivided(Document& document, const BuildOptions& options) {
  if (options.most_of_piece == 0 ||
      (!is_plain(document) && document.assembly.parts.size() < kManyParts)) {
    return build(document, options);
  }
  try {
    const DistrictBuild plan(document.assembly, options);
    if (!plan.seams().empty()) {
      plan.refuse_too_costly();
      return std::nullopt;
    }
    if (is_plain(document)) {
      return plan.build_all(options.progress);
    }
  } catch (const Error&) {
    if (is_plain(document)) {
      throw;
    }
  }
  return build(document, options);  // which knows the lines of a file, and does without
                                    // fillets that were not asked for
}

// The solid built and written, whole or in tiles.
Built build_and_write(Document& document, const BuildOptions& options,
                      const BuildArguments& arguments, const Ranks& ranks, BuildReport& report,
                      TriMesh* written, std::string& warning) {
  const auto in_districts = [&] {
    TiledBuilt made = build_in_tiles(document, options, arguments, header_of(document), ranks);
    report.output = std::move(made.output);
    warning = std::move(made.warning);
    return std::move(made.built);
  };
  if (is_in_districts(arguments, ranks)) {
    return in_districts();
  }
  std::optional<Built> built = build_undivided(document, options);
  if (!built) {
    try {
      return in_districts();
    } catch (const Error&) {
      if (is_plain(document)) {
        throw;
      }
      built = build(document, options);  // as above
    }
  }
  write_built(*built, document, options, arguments, report, written);
  return *std::move(built);
}

// Districts are to be rounded apart where a mesh of the exact union is written.
void prepare_districts(const BuildArguments& arguments, const std::string& unit,
                       BuildOptions& options) {
  if (!is_step(arguments.output) && !is_volume(arguments.output) &&
      arguments.quality != kForSolvers) {
    const DistrictMargin margin = district_margin(tiled_destination(arguments.output),
                                                  rounding_options(arguments.rounding, unit),
                                                  contact_choice(arguments.contacts, unit));
    options.margin = margin.absolute;
    options.relative_margin = margin.relative;
  }
  prepare_pieces(arguments, options);
}

// What is no part of the report, as the same build without it would say the same.
void print_warning(const std::string& warning, const CommonOptions& common) {
  if (!warning.empty() && !common.quiet) {
    std::cerr << "dupin: warning: " << warning << '\n';
  }
}

ExitCode run_build(const BuildArguments& arguments, const CommonOptions& common) {
  check_destination(arguments);
  const Ranks ranks;
  if (is_in_districts(arguments, ranks)) {
    check_tiled(arguments);
  }
  if (ranks.count() > 1) {
    require_read_again(arguments.files.front(), "all processes of mpirun read the document");
  }
  std::optional<ProgressLine> line(common.quiet || !ranks.is_first());
  Document document = alike(ranks, [&] {
    return read_document(arguments.files.front(), arguments.source, arguments.walls,
                         line->callback());
  });
  Assembly& assembly = document.assembly;
  BuildOptions options = build_options(assembly, arguments, common);
  (void)rounding_options(arguments.rounding, std::string(symbol(assembly.unit)));
  if (is_step(arguments.output)) {
    require_exchange(assembly, options.region, exchange_solids(arguments.output, arguments.solids));
  }
  prepare_districts(arguments, std::string(symbol(assembly.unit)), options);
  BuildReport report;
  TriMesh written;
  std::string warning;
  {
    options.progress = line->callback();
    Built built = build_and_write(document, options, arguments, ranks, report,
                                  arguments.page.empty() ? nullptr : &written, warning);
    if (!ranks.is_first()) {
      print_warning(warning, common);
      return ExitCode::ok;
    }
    take(report, std::move(built), document, options.connect);
    if (!arguments.page.empty()) {
      tell(options.progress, "report");
      writing_beside(arguments.output.path,
                     [&] { write_page(arguments.page, document, report, std::move(written)); });
    }
    line.reset();
  }
  print_warning(warning, common);
  if (common.json) {
    report_stream(arguments.output.path) << to_json(report) << '\n';
  } else if (!common.quiet) {
    print_build(report_stream(arguments.output.path), report);
    if (!arguments.page.empty()) {
      print_row(report_stream(arguments.output.path), "report", arguments.page);
    }
  }
  return report.findings() == 0 ? ExitCode::ok : ExitCode::findings;
}

struct BatchArguments {
  std::string folder;
  std::optional<std::size_t> jobs;
};

ExitCode run_build_or_batch(const CLI::App& command, const BuildArguments& arguments,
                            const BatchArguments& batch, const CommonOptions& common) {
  if (!batch.folder.empty()) {
    if (!arguments.output.path.empty()) {
      throw UsageError("--output and --out-dir both say where to; give one of them");
    }
    if (is_under_mpirun()) {
      throw UsageError("--out-dir is not for mpirun, which shares one document among processes");
    }
    return run_batch(command, batch_items(arguments.files, batch.folder, arguments.output.format),
                     batch.folder, batch.jobs.value_or(1), common);
  }
  if (batch.jobs) {
    throw UsageError("--jobs is for many documents; give --out-dir, or leave it out");
  }
  if (arguments.files.size() > 1) {
    throw UsageError("several documents need --out-dir");
  }
  if (arguments.output.path.empty()) {
    throw UsageError("--output is required");
  }
  return run_build(arguments, common);
}

}  // namespace

void add_build_options(CLI::App& command, BuildArguments& arguments) {
  std::vector<std::string> others = volume_format_names();
  others.emplace_back("step");
  others.emplace_back("pvtu");
  add_output_options(command, arguments.output, others);
  command
      .add_option("--quality", arguments.quality,
                  "Triangles like those of the exact union, cad (the usual), or cfd,\n"
                  "well-shaped ones for solvers, within --distance; see the command remesh.\n"
                  "Tetrahedra, .msh and .vtu, are always for solvers")
      ->type_name("KIND")
      ->check(CLI::IsMember({"cad", kForSolvers}));
  add_solver_options(command, arguments.solver);
  command
      .add_option("--distance", arguments.solver.distance,
                  "Largest distance between a mesh for solvers and the exact union; twice the\n"
                  "tolerance if not given")
      ->type_name("LENGTH");
  add_solids_option(command, arguments.solids);
  command
      .add_option("--report", arguments.page,
                  "HTML file beside it: the solid in 3D, and where its gaps, contacts and\n"
                  "margins are; see the command report")
      ->type_name("FILE");
  command.add_option("--segments", arguments.segments, "Fixed number of segments of every ring")
      ->type_name("NUMBER")
      ->check(CLI::Range(kFewestSegments, kMostSegments));
  add_wall_options(command, arguments.walls);
  add_region_option(command, arguments.region);
  add_triangles_option(command, arguments.most_triangles);
  command.get_option("--triangles")->each([&arguments](const std::string& /*number*/) {
    arguments.are_triangles_limited = true;
  });
  add_connect_option(command, arguments.connect);
  add_source_options(command, arguments.source);
  add_contacts_option(command, arguments.contacts);
  add_cross_check_option(command, arguments.cross_check);
  add_rounding_options(command, arguments.rounding);
  add_build_tile_options(command, arguments.tiles);
}

void add_build(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("build", "Make a watertight solid of an assembly");
  const auto arguments = std::make_shared<BuildArguments>();
  const auto batch = std::make_shared<BatchArguments>();
  command
      ->add_option("FILE", arguments->files,
                   "assembly document, piping file (.pcf) or graph (.swc, .graph); - for\n"
                   "standard input; several with --out-dir")
      ->type_name("")
      ->required();
  command
      ->add_option("-o,--output", arguments->output.path,
                   "mesh, tetrahedra (.msh, .vtu) or STEP file, or files of VTK (.pvtu);\n"
                   "- for standard output")
      ->type_name("OUT");
  command
      ->add_option("--out-dir", batch->folder,
                   "Folder for the meshes of any number of documents, each built by itself\n"
                   "and named like it, as STL if --format is not given")
      ->type_name("DIR");
  command
      ->add_option("-j,--jobs", batch->jobs,
                   "Documents built at a time with --out-dir; 1 if not given")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, 1024));
  add_build_options(*command, *arguments);
  command->footer(
      "Exit code 1: built and written, but ends that belong together do not meet, or a "
      "cross-check\n"
      "disagrees, or something of a graph or piping file was left out; of several documents, any "
      "of\n"
      "this or a failure of one.\n\n"
      "Examples:\n"
      "  dupin build examples/reducer.json -o reducer.stl\n"
      "  dupin build plant.json -o plant.off --tolerance 0.2mm --connect 1mm\n"
      "  dupin build plant.json -o plant.step\n"
      "  dupin build plant.json -o fluid.msh --region fluid --size 20mm\n"
      "  dupin build - -o - --format stl < plant.json > plant.stl\n"
      "  dupin build *.pcf --out-dir meshes -j 4");
  command->callback([command, arguments, batch, &action] {
    action = [command, arguments, batch](const CommonOptions& common) {
      return run_build_or_batch(*command, *arguments, *batch, common);
    };
  });
}

}  // namespace dupin::cli
