#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <string_view>

#include <CLI/App.hpp>

#include "commands.h"
#include "document.h"
#include "dupin/io/nurbs_json.h"
#include "exchange_options.h"
#include "exit_code.h"
#include "length.h"
#include "output.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

struct NurbsArguments {
  std::string file, output;
  SourceArguments source;
};

// What the extension asks for.
std::string nurbs_file(const std::vector<NamedNurbs>& parts, Unit unit,
                       const std::string& extension) {
  if (extension == ".step" || extension == ".stp") {
    return surfaces_step(parts, unit);
  }
  if (extension == ".iges" || extension == ".igs") {
    return surfaces_iges(parts, unit);
  }
  return nurbs_json(parts, unit) + "\n";
}

void print_nurbs(std::ostream& out, const std::vector<NamedNurbs>& parts, const std::string& output,
                 Unit unit) {
  std::size_t surfaces = 0, points = 0, exact = 0;
  double error = 0;
  for (const NamedNurbs& part : parts) {
    surfaces += part.form.surfaces.size();
    exact += part.form.error_bound == 0 ? 1 : 0;
    error = std::max(error, part.form.error_bound);
    for (const NurbsSurface& surface : part.form.surfaces) {
      points += surface.net.size() * surface.net.front().size();
    }
  }
  print_row(out, "parts", std::to_string(parts.size()) + ", " + std::to_string(exact) + " exact");
  print_row(out, "surfaces", std::to_string(surfaces));
  print_row(out, "control points", std::to_string(points));
  print_row(out, "error", at_most(error, symbol(unit)));
  print_row(out, "written", output);
}

ExitCode run_nurbs(const NurbsArguments& arguments, const CommonOptions& common) {
  constexpr std::array<std::string_view, 5> kKnown{".json", ".step", ".stp", ".iges", ".igs"};
  refuse_other_extensions(arguments.output, kKnown);
  const Document document = read_document(arguments.file, arguments.source);
  const Assembly& assembly = document.assembly;
  const double tolerance =
      document_length("--tolerance", assembly.unit, common.tolerance, assembly.tolerance);
  const auto parts = named_nurbs(assembly, tolerance);
  write_text(arguments.output, nurbs_file(parts, assembly.unit, lower_extension(arguments.output)));
  if (output_path(arguments.output) == "-") {
    return ExitCode::ok;
  }
  if (common.json) {
    std::cout << nurbs_report_json(parts, arguments.output) << '\n';
  } else if (!common.quiet) {
    print_nurbs(std::cout, parts, arguments.output, assembly.unit);
  }
  return ExitCode::ok;
}

}  // namespace

void add_nurbs(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("nurbs", "Write the parts' surfaces as NURBS");
  const auto arguments = std::make_shared<NurbsArguments>();
  command
      ->add_option("FILE", arguments->file,
                   "assembly document, graph or piping file; - for standard input")
      ->type_name("")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "JSON, STEP (.step) or IGES (.iges) file; - for standard output")
      ->type_name("OUT")
      ->required();
  add_source_options(*command, arguments->source);
  command->footer(
      "Rational surfaces are exact; others are within --tolerance (the document's if not given),\n"
      "as proven: 'error_bound' says how far. Pipes with fillets or copes are not trimmed.\n\n"
      "Examples:\n"
      "  dupin nurbs examples/reducer.json -o reducer-nurbs.json --tolerance 0.001mm\n"
      "  dupin nurbs examples/reducer.json -o reducer.iges");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_nurbs(*arguments, common); };
  });
}

}  // namespace dupin::cli
