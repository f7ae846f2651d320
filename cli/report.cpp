#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/App.hpp>

#include "argument_checks.h"
#include "commands.h"
#include "document.h"
#include "dupin/blends/certify.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/report_page.h"
#include "dupin/kernel/rounding.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "output.h"
#include "progress_line.h"
#include "report_page_file.h"
#include "report_text.h"
#include "source_text.h"

namespace dupin::cli {
namespace {

struct ReportArguments {
  std::string file, output, connect, region, certificate;
  WallArguments walls;
  std::size_t most_triangles = kUsualTriangles;
  SourceArguments source;
  bool certify = false;
};

// The page beside nothing: "plant.json" becomes "plant.html" in the folder where one is.
std::string page_path(const ReportArguments& arguments) {
  if (!arguments.output.empty()) {
    return arguments.output;
  }
  if (arguments.file == "-") {
    throw UsageError("of standard input, say -o where the page goes");
  }
  const std::filesystem::path name = std::filesystem::path(arguments.file).filename();
  std::string page = std::filesystem::path(name).replace_extension(".html").string();
  if (are_one_file(page, arguments.file) || are_one_file(page, arguments.certificate)) {
    throw UsageError("the page would take the place of what is read, " + page +
                     "; say -o where it goes");
  }
  return page;
}

ExitCode tell_result(const std::string& page, std::size_t findings, const CommonOptions& common) {
  std::ostream& out = report_stream(page);
  if (common.json) {
    out << page_report_json(page, findings) << '\n';
  } else if (!common.quiet) {
    print_row(out, "findings", std::to_string(findings));
    print_row(out, "written", page);
  }
  return findings == 0 ? ExitCode::ok : ExitCode::findings;
}

ExitCode report_mesh(const ReportArguments& arguments, const Input& input, const std::string& page,
                     const CommonOptions& common) {
  refuse_tolerance("report, of a mesh,", common);
  if (!arguments.certificate.empty() || arguments.certify || !arguments.connect.empty() ||
      !arguments.region.empty() || arguments.most_triangles != kUsualTriangles) {
    throw UsageError(
        "--certificate, --certify, --connect, --region and --triangles are for documents, and " +
        input.name + " is a mesh");
  }
  refuse_of_mesh(input.name, arguments.source, arguments.walls);
  MeshSummary summary{input.name, input.unit(), read_mesh(input.bytes, input.name), {}};
  summary.check = check(summary.mesh);
  std::size_t findings = 0;
  for (std::size_t i = 0; i < summary.check.counts.size(); ++i) {
    findings += is_fatal(static_cast<Defect>(i)) ? summary.check.counts[i] : 0;
  }
  write_text(page, report_page_html(report_page(summary)));
  return tell_result(page, findings, common);
}

std::optional<Certificate> certificate_of(const ReportArguments& arguments, const Input& input,
                                          const Assembly& assembly) {
  if (!arguments.certificate.empty()) {
    const Input claims = read_input(arguments.certificate);
    Certificate certificate = parse_certificate(claims.bytes, claims.name);
    require_about(certificate, input.bytes, input.name);
    verify(certificate, claims.name);
    return certificate;
  }
  if (arguments.certify) {
    return certify(assembly, {.most_triangles = arguments.most_triangles});
  }
  return std::nullopt;
}

// What a build has written, of a solid that is not.
TriMesh round(const Solid& solid, OutputReport& report) {
  const Rounded rounded = to_mesh(solid);
  report.rounding = rounded.report();
  report.contacts = rounded.contacts();
  report.check = check(rounded);
  return in_own_place(rounded);
}

ExitCode report_document(const ReportArguments& arguments, const Input& input,
                         const std::string& page, const CommonOptions& common) {
  refuse_idle_insulation(arguments.walls, arguments.region);
  Document document = read_document(input, arguments.source, arguments.walls);
  Assembly& assembly = document.assembly;
  if (!common.tolerance.empty()) {
    assembly.tolerance = document_length("--tolerance", assembly.unit, common.tolerance, 0);
  }
  BuildOptions options;
  options.most_triangles = arguments.most_triangles;
  options.connect = length_in(assembly.unit, arguments.connect, assembly.tolerance);
  options.region = region_named(arguments.region);
  BuildReport report;
  std::optional<Certificate> certificate;
  {
    ProgressLine line(common.quiet);
    options.progress = line.callback();
    Built built = build(document, options);
    tell(options.progress, "round");
    TriMesh mesh = round(built.solid, report.output);
    take(report, std::move(built), document, options.connect);
    tell(options.progress, "certify");
    certificate = certificate_of(arguments, input, assembly);
    tell(options.progress, "report");
    write_page(page, document, report, std::move(mesh), certificate ? &*certificate : nullptr);
  }
  if (!common.json && !common.quiet) {
    print_source(report_stream(page), report);
  }
  return tell_result(page, report.findings() + (certificate ? certificate->findings() : 0), common);
}

ExitCode run_report(const ReportArguments& arguments, const CommonOptions& common) {
  const std::string page = page_path(arguments);
  require_page_file(page, {});
  const Input input = read_input(arguments.file);
  return is_source(input) || input.is_document() ? report_document(arguments, input, page, common)
                                                 : report_mesh(arguments, input, page, common);
}

}  // namespace

void add_report(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "report", "Show a solid in 3D, and where its findings are, on a page of HTML");
  const auto arguments = std::make_shared<ReportArguments>();
  command
      ->add_option("FILE", arguments->file, "assembly document, piping file, graph, or mesh file")
      ->type_name("")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "HTML file, FILE's name with .html if not given; - for standard output")
      ->type_name("PAGE");
  command
      ->add_option("--certificate", arguments->certificate,
                   "What certify wrote of the document: it is verified and shown")
      ->type_name("FILE");
  command->add_flag("--certify", arguments->certify,
                    "Certify the document now and show the claims");
  add_wall_options(*command, arguments->walls);
  add_region_option(*command, arguments->region);
  add_triangles_option(*command, arguments->most_triangles);
  add_connect_option(*command, arguments->connect);
  add_source_options(*command, arguments->source);
  command->footer(
      "The page is one file that needs no network and no other file: a solid to turn, cut open "
      "and\n"
      "measure, its parts, and tables whose rows lead to the places that they are about.\n\n"
      "Exit code 1: there are gaps, faults, or claims that are not proved; the page shows them.\n\n"
      "Examples:\n"
      "  dupin report examples/header.json\n"
      "  dupin report part.stl -o part.html\n"
      "  dupin build plant.json -o plant.stl --report plant.html");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_report(*arguments, common); };
  });
}

}  // namespace dupin::cli
