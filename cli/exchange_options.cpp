#include "exchange_options.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <ostream>

#include <CLI/App.hpp>

#include "dupin/kernel/decimal.h"
#include "exit_code.h"
#include "report_text.h"

namespace dupin::cli {

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

void refuse_other_extensions(const std::string& path, std::span<const std::string_view> known) {
  const std::string extension = lower_extension(path);
  if (extension.empty() || std::ranges::find(known, extension) != known.end()) {
    return;
  }
  std::string all;
  for (const std::string_view one : known) {
    all += (all.empty() ? "" : ", ") + std::string(one);
  }
  throw UsageError(path + ": the extension '" + extension +
                   "' names nothing that is written here; " + "known are " + all);
}

bool is_step(const OutputArguments& arguments) {
  const std::string extension = lower_extension(arguments.path);
  return arguments.format.empty() ? extension == ".step" || extension == ".stp"
                                  : arguments.format == "step";
}

void add_solids_option(CLI::App& command, std::string& solids) {
  command
      .add_option("--solids", solids,
                  "What becomes a solid of a STEP file: united (the usual), where parts\n"
                  "cross each other; runs of parts that share rings; or parts, each by\n"
                  "itself")
      ->type_name("WHAT")
      ->check(CLI::IsMember(
          {name(ExchangeSolids::united), name(ExchangeSolids::runs), name(ExchangeSolids::parts)}));
}

ExchangeSolids exchange_solids(const OutputArguments& arguments, const std::string& solids) {
  if (!arguments.patches.empty()) {
    throw UsageError("--patches lists those of a mesh; the faces of a STEP file have names");
  }
  return solids == name(ExchangeSolids::runs)    ? ExchangeSolids::runs
         : solids == name(ExchangeSolids::parts) ? ExchangeSolids::parts
                                                 : ExchangeSolids::united;
}

void write_exchange(ExchangeFile& file, const std::string& path) {
  write_text(path, file.bytes);
  file.report.file = output_path(path) == "-" ? "standard output" : path;
}

void print_exchange(std::ostream& out, const ExchangeReport& report, const std::string& unit) {
  print_row(out, "written", report.file + ", " + report.format);
  print_row(out, "solids",
            std::to_string(report.solids.size()) + ", " + counted(report.faces, "face"));
  print_row(
      out, "surfaces",
      std::to_string(report.exact_surfaces) + " exact" +
          (report.lofted_surfaces > 0 ? ", " + std::to_string(report.lofted_surfaces) + " within " +
                                            decimal_at_most(report.error_bound) + " " + unit
                                      : ""));
  print_row(out, "edges", "within " + decimal_at_most(report.edge_tolerance) + " " + unit);
  print_row(out, "volume", number(report.volume) + " " + unit + "3");
  if (report.expected_volume) {
    print_row(out, "of the mesh",
              number(*report.expected_volume) + " " + unit + "3, which may differ by " +
                  number(report.volume_bound));
  }
  print_row(out, "verified", "read back, valid and closed (BRepCheck)");
}

}  // namespace dupin::cli
