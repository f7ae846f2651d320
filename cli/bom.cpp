#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <memory>
#include <numbers>

#include <CLI/App.hpp>

#include "commands.h"
#include "document.h"
#include "dupin/io/bill_report.h"
#include "dupin/kernel/decimal.h"
#include "length.h"
#include "progress_line.h"
#include "report_text.h"
#include "source_text.h"

namespace dupin::cli {
namespace {

struct BomArguments {
  std::string file;
  WallArguments walls;
  SourceArguments source;
  double density = 0;  // 0: not given
  bool csv = false, mesh = false;
  std::size_t most_triangles = kUsualTriangles;
};

using Cells = std::vector<std::string>;

std::string digits(double value) { return decimal(value, kMessageDigits); }

std::string digits(const std::optional<double>& value) { return value ? digits(*value) : "-"; }

std::string volume(const std::optional<SolidMoments>& solid) {
  return solid ? digits(solid->volume) : "-";
}

std::string bend(const std::optional<double>& radius, const std::optional<double>& degrees) {
  return radius && degrees ? std::string("R ")
                                 .append(digits(*radius))
                                 .append(", ")
                                 .append(digits(*degrees).append(" deg"))
                           : "-";
}

std::optional<double> in_degrees(const std::optional<double>& radians) {
  return radians ? std::optional(*radians * 180 / std::numbers::pi) : std::nullopt;
}

// Columns as wide as their widest cell, two spaces apart.
void print_table(const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  for (const Cells& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line.append(row[i]).append(i + 1 < row.size() ? widths[i] + 2 - row[i].size() : 0, ' ');
    }
    std::cout << line << '\n';
  }
}

void print_parts(const BillReport& report) {
  const bool has_mass = report.density.has_value();
  Cells head{"part", "kind", "size", "wall", "length", "bend", "area", "metal", "fluid"};
  if (has_mass) {
    head.emplace_back("mass");
  }
  std::vector<Cells> rows{std::move(head)};
  rows.reserve(report.bill.rows.size() + 1);
  for (const BillRow& row : report.bill.rows) {
    Cells cells{row.name,
                row.kind,
                row.sizes.empty() ? "-" : size_text(row.sizes, report.bill.unit),
                row.wall > 0 ? digits(row.wall) : "-",
                digits(row.length),
                bend(row.bend_radius, in_degrees(row.bend_angle)),
                digits(row.area),
                volume(row.metal),
                volume(row.fluid)};
    if (has_mass) {
      cells.push_back(digits(row.metal ? mass(report, row.metal->volume) : std::nullopt));
    }
    rows.push_back(std::move(cells));
  }
  print_table(rows);
}

void print_take_off(const BillReport& report) {
  std::vector<Cells> rows{{"count", "component", "kind", "size", "wall", "bend", "length"}};
  const std::vector<TakeOff> all = take_off(report);
  rows.reserve(all.size() + 1);
  for (const TakeOff& entry : all) {
    rows.push_back(
        {std::to_string(entry.count), entry.component.empty() ? "-" : entry.component, entry.kind,
         entry.size.empty() ? "-" : entry.size, entry.wall > 0 ? digits(entry.wall) : "-",
         bend(entry.bend_radius, entry.bend_angle), entry.length > 0 ? digits(entry.length) : "-"});
  }
  print_table(rows);
}

void print_sum(const BillReport& report) {
  const BillTotals sum = totals(report.bill);
  const std::string unit(symbol(report.bill.unit));
  print_row(std::cout, "sum of areas", number(sum.area) + " " + unit + "2");
  print_row(std::cout, "sum of metal", number(sum.metal.volume) + " " + unit + "3");
  if (const auto kilograms = mass(report, sum.metal.volume)) {
    print_row(std::cout, "sum of masses", number(*kilograms) + " kg");
  }
  if (sum.fluid.volume > 0) {
    print_row(std::cout, "sum of fluid", number(sum.fluid.volume) + " " + unit + "3");
  }
  if (sum.metal.volume > 0) {
    print_row(std::cout, "centre of gravity", place_text(sum.metal.centroid));
  }
  if (sum.without_volume > 0) {
    print_row(std::cout, "not in the sums", counted(sum.without_volume, "row"));
  }
  std::cout << "What lies in two parts counts twice in the sums.\n";
  if (report.mesh) {
    const auto& [outer, metal, fluid] = report.mesh->volumes;
    print_row(std::cout, "mesh of the union",
              "outer " + number(outer) + ", metal " + number(metal) + ", fluid " + number(fluid) +
                  " " + unit + "3, at a tolerance of " + number(report.mesh->tolerance) + " " +
                  unit);
  }
}

void print_bill(const BillReport& report) {
  print_row(std::cout, "file", report.bill.source);
  print_row(std::cout, "unit", symbol(report.bill.unit));
  std::cout << '\n';
  print_parts(report);
  for (const BillRow& row : report.bill.rows) {
    for (const std::string& remark : row.remarks) {
      std::cout << "  " << row.name << ": " << remark << '\n';
    }
  }
  std::cout << '\n';
  print_take_off(report);
  std::cout << '\n';
  print_sum(report);
}

void refuse_contradictions(const BomArguments& arguments, const CommonOptions& common) {
  if (!arguments.mesh) {
    refuse_tolerance("bom", common, "--mesh --tolerance");
    if (arguments.most_triangles != kUsualTriangles) {
      throw UsageError("--triangles is for the mesh of bom --mesh");
    }
  }
  if (!arguments.walls.insulation.empty()) {
    throw UsageError("--insulation changes nothing that bom lists; leave it out");
  }
  if (arguments.csv && (common.json || arguments.mesh)) {
    throw UsageError("--csv excludes --json and --mesh");
  }
}

bool is_hollow_chain(const Part& part) {
  const auto* const chain = std::get_if<CyclideChainThrough>(&part.shape);
  return chain != nullptr && chain->wall > 0;
}

MeshVolumes mesh_volumes(Document& document, std::size_t most_triangles,
                         const CommonOptions& common) {
  const double tolerance = document_length("--tolerance", document.assembly.unit, common.tolerance,
                                           document.assembly.tolerance);
  BuildOptions options;
  options.tolerance = tolerance;
  options.most_triangles = most_triangles;
  // A chain that has a wall of its own is built with it, and has no regions unless asked for one.
  if (std::ranges::any_of(document.assembly.parts, is_hollow_chain)) {
    options.region = Region::metal;
  }
  ProgressLine line(common.quiet);
  options.progress = line.callback();
  const Built built = build(document, options);
  const double whole = built.solid.volume();
  return {tolerance, built.volumes.value_or(RegionVolumes{whole, whole, 0})};
}

ExitCode run_bom(const BomArguments& arguments, const CommonOptions& common) {
  refuse_contradictions(arguments, common);
  Document document = read_document(arguments.file, arguments.source, arguments.walls);
  // Told to keep going, a build leaves out parts that the bill then does not have either.
  const auto mesh = arguments.mesh
                        ? std::optional(mesh_volumes(document, arguments.most_triangles, common))
                        : std::nullopt;
  BillReport report = bill_report(document);
  report.mesh = mesh;
  if (arguments.density > 0) {
    report.density = arguments.density;
  }
  if (common.json) {
    std::cout << to_json(report) << '\n';
  } else if (arguments.csv) {
    std::cout << to_csv(report);
  } else if (!common.quiet) {
    print_bill(report);
  }
  if (!common.json && !common.quiet) {
    print_source(std::cerr, report.source);
  }
  return report.source.source_findings() == 0 ? ExitCode::ok : ExitCode::findings;
}

// Osmium has 22 590.
constexpr double kMostDensity = 1e6;

// A positive number; what the parser itself lets pass includes infinity and hexadecimals.
std::string density_fault(const std::string& typed) {
  try {
    std::size_t read = 0;
    const double value = std::stod(typed, &read);
    const bool is_decimal = typed.find_first_of("xX") == std::string::npos;
    return read == typed.size() && is_decimal && value > 0 && value <= kMostDensity
               ? ""
               : "must be a positive number of at most 1e6, in kg/m3";
  } catch (const std::exception&) {
    return "must be a positive number of at most 1e6, in kg/m3";
  }
}

}  // namespace

void add_bom(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("bom", "List what the parts measure: lengths, areas, volumes, masses");
  const auto arguments = std::make_shared<BomArguments>();
  command
      ->add_option("FILE", arguments->file,
                   "assembly document, graph or piping file; - for standard input")
      ->type_name("")
      ->required();
  command
      ->add_option("--density", arguments->density,
                   "Of the metal, in kg/m3; no masses if not given")
      ->type_name("NUMBER")
      ->check(density_fault);
  command->add_flag("--csv", arguments->csv, "Write a table as comma-separated values (RFC 4180)");
  command->add_flag("--mesh", arguments->mesh,
                    "Build the mesh, too, within --tolerance or the document's, and say the\n"
                    "volumes of the union, in which nothing counts twice");
  add_triangles_option(*command, arguments->most_triangles);
  add_wall_options(*command, arguments->walls);
  add_source_options(*command, arguments->source);
  command->footer(
      "Everything is of the smooth surfaces, to 1e-9 at least, and not of a mesh.\n\n"
      "Examples:\n"
      "  dupin bom plant.json --density 7850\n"
      "  dupin bom line.pcf --wall 3.6mm --csv > line.csv");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_bom(*arguments, common); };
  });
}

}  // namespace dupin::cli
