#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

#include <CLI/App.hpp>

#include "commands.h"
#include "document.h"
#include "dupin/blends/drawing.h"
#include "dupin/io/drawing_svg.h"
#include "length.h"
#include "output.h"
#include "progress_line.h"
#include "report_text.h"
#include "source_text.h"

namespace dupin::cli {
namespace {

struct DrawArguments {
  std::string file, output, wall, region, scale;
  std::vector<double> direction{-1, 1, -1}, up;
  SourceArguments source;
  bool hidden = false;
};

void print_drawing(std::ostream& out, const Drawing& drawing, const DrawingScale& scale,
                   const std::string& file) {
  const Eigen::Vector2d size = size_on_paper(drawing, scale);
  const auto hidden = std::size_t(std::ranges::count(drawing.lines, true, &DrawnLine::hidden));
  print_row(out, "lines",
            std::to_string(drawing.lines.size() - hidden) + " visible" +
                (hidden > 0 ? ", " + std::to_string(hidden) + " hidden" : ""));
  print_row(out, "scale",
            to_string(scale) + ", on " + number(size[0]) + " x " + number(size[1]) + " mm");
  print_row(out, "looking along", place_text(-drawing.view.towards));
  print_row(out, "error",
            "at most " + number(drawing.error) + " " + std::string(symbol(drawing.unit)));
  print_row(out, "written", file);
}

Vec3 vector_of(const std::vector<double>& numbers) {
  return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

BuildOptions build_options(const Assembly& assembly, const DrawArguments& arguments,
                           const CommonOptions& common) {
  BuildOptions options;
  if (!common.tolerance.empty()) {
    options.tolerance = length_in(assembly.unit, common.tolerance, 0);
  }
  options.region = region_named(arguments.region);
  return options;
}

// How and how large, which say at once what is wrong with them.
std::pair<DrawingOptions, std::optional<DrawingScale>> typed(const DrawArguments& arguments) {
  try {
    const auto up = arguments.up.empty() ? std::nullopt : std::optional(vector_of(arguments.up));
    return {{view_along(vector_of(arguments.direction), up), arguments.hidden},
            arguments.scale.empty() ? std::nullopt : std::optional(drawing_scale(arguments.scale))};
  } catch (const Error& error) {
    throw UsageError(error.message());
  }
}

ExitCode run_draw(const DrawArguments& arguments, const CommonOptions& common) {
  const auto [options, typed_scale] = typed(arguments);
  Document document = read_document(arguments.file, arguments.source, arguments.wall);
  BuildReport report;
  Drawing drawing;
  {
    ProgressLine line(common.quiet);
    BuildOptions build = build_options(document.assembly, arguments, common);
    build.progress = line.callback();
    const Built built = build_document(document, build);
    tell(build.progress, "draw");
    drawing = draw(document.assembly, built, options);
  }
  report.graph = std::move(document.network);
  report.piping = std::move(document.piping);
  const DrawingScale scale = typed_scale.value_or(fitting_scale(drawing));
  write_text(arguments.output, drawing_svg(drawing, scale));
  std::ostream& out = report_stream(arguments.output);
  if (common.json) {
    out << drawing_report_json(drawing, scale, arguments.output) << '\n';
  } else if (!common.quiet) {
    print_source(out, report);
    print_drawing(out, drawing, scale, arguments.output);
  }
  return report.source_findings() == 0 ? ExitCode::ok : ExitCode::findings;
}

void add_vector_option(CLI::App& command, const std::string& name, std::vector<double>& value,
                       const std::string& help) {
  command.add_option(name, value, help)->type_name("X,Y,Z")->delimiter(',')->expected(3);
}

}  // namespace

void add_draw(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("draw", "Draw the visible outline of an assembly to scale, as SVG");
  const auto arguments = std::make_shared<DrawArguments>();
  command
      ->add_option("FILE", arguments->file,
                   "assembly document, graph or piping file; - for standard input")
      ->type_name("")
      ->required();
  command->add_option("-o,--output", arguments->output, "SVG file; - for standard output")
      ->type_name("OUT")
      ->required();
  add_vector_option(*command, "--direction", arguments->direction,
                    "To look along; -1,1,-1 if not given, which is isometric");
  add_vector_option(*command, "--up", arguments->up,
                    "What is upwards in the picture; z if not given, or y seen along z");
  command
      ->add_option("--scale", arguments->scale,
                   "Such as 1:50; if not given, the largest usual one that fits on A3")
      ->type_name("PAPER:REAL");
  command->add_flag("--hidden", arguments->hidden, "Draw hidden lines, too, dashed");
  add_wall_option(*command, arguments->wall);
  add_region_option(*command, arguments->region);
  add_source_options(*command, arguments->source);
  command->footer(
      "Contours of the smooth surfaces and the edges in which they meet, within --tolerance (the\n"
      "document's if not given).\n\n"
      "Examples:\n"
      "  dupin draw plant.json -o plant.svg\n"
      "  dupin draw line.pcf -o plan.svg --direction 0,0,-1 --scale 1:100 --hidden");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_draw(*arguments, common); };
  });
}

}  // namespace dupin::cli
