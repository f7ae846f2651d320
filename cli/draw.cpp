#include <algorithm>
#include <array>
#include <charconv>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>

#include <CLI/App.hpp>

#include "commands.h"
#include "document.h"
#include "dupin/blends/drawing.h"
#include "dupin/io/drawing_page.h"
#include "dupin/io/drawing_svg.h"
#include "exchange_options.h"
#include "length.h"
#include "number_range.h"
#include "output.h"
#include "progress_line.h"
#include "report_text.h"
#include "source_text.h"

namespace dupin::cli {
namespace {

struct DrawArguments {
  std::string file, output, region, scale, view;
  WallArguments walls;
  std::vector<double> direction, up;
  SourceArguments source;
  std::optional<double> dots_per_inch;
  std::size_t most_triangles = kUsualTriangles;
  bool hidden = false, center = false, shaded = false;
  SheetOptions sheet;
};

void print_drawing(std::ostream& out, const Drawing& drawing, const DrawingScale& scale,
                   const DrawArguments& arguments) {
  const Eigen::Vector2d size = size_on_paper(drawing, scale, arguments.sheet);
  const auto hidden = std::size_t(std::ranges::count(drawing.lines, true, &DrawnLine::hidden));
  const auto center =
      std::size_t(std::ranges::count(drawing.lines, LineKind::center, &DrawnLine::kind));
  print_row(out, "lines",
            std::to_string(drawing.lines.size() - hidden - center) + " visible" +
                (hidden > 0 ? ", " + std::to_string(hidden) + " hidden" : "") +
                (center > 0 ? ", " + std::to_string(center) + " of axes" : ""));
  print_row(out, "scale",
            to_string(scale) + ", on " + number(size[0]) + " x " + number(size[1]) + " mm");
  print_row(out, "looking along", place_text(-drawing.view.towards));
  print_row(out, "error", at_most(drawing.error, symbol(drawing.unit)));
  print_row(out, "written", arguments.output);
}

// What a file is written as.
enum class Page { svg, pdf, png };

Page page_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".pdf" ? Page::pdf : extension == ".png" ? Page::png : Page::svg;
}

std::string page(const Drawing& drawing, const Solid& solid, const DrawingScale& scale,
                 const DrawArguments& arguments,
                 const std::map<std::string, std::string>& colours) {
  switch (page_of(arguments.output)) {
    case Page::svg:
      return drawing_svg(drawing, scale, arguments.sheet);
    case Page::pdf:
      return drawing_pdf(drawing, scale, arguments.sheet);
    case Page::png:
      return drawing_png(
          drawing, scale, arguments.sheet,
          {arguments.dots_per_inch.value_or(150), arguments.shaded ? &solid : nullptr, colours});
  }
  return {};
}

Vec3 vector_of(const std::vector<double>& numbers) {
  return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

BuildOptions build_options(const Assembly& assembly, const DrawArguments& arguments,
                           const CommonOptions& common) {
  BuildOptions options;
  if (!common.tolerance.empty()) {
    options.tolerance = document_length("--tolerance", assembly.unit, common.tolerance, 0);
  }
  options.most_triangles = arguments.most_triangles;
  options.region = region_named(arguments.region);
  return options;
}

// What is looked along, of a view by its name or of the place that one looks from.
Vec3 direction_of(const DrawArguments& arguments) {
  if (!arguments.direction.empty()) {
    return vector_of(arguments.direction);
  }
  const std::array<std::pair<std::string_view, Vec3>, 4> named{
      {{"iso", {-1, 1, -1}}, {"top", {0, 0, -1}}, {"front", {0, 1, 0}}, {"side", {-1, 0, 0}}}};
  const std::string typed = arguments.view.empty() ? "iso" : arguments.view;
  for (const auto& [view, direction] : named) {
    if (typed == view) {
      return direction;
    }
  }
  std::vector<double> from;
  std::istringstream in(typed);
  for (std::string number; std::getline(in, number, ',');) {
    double value = 0;
    const auto [end, fault] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (fault == std::errc() && end == number.data() + number.size()) {
      from.push_back(value);
    }
  }
  if (from.size() != 3 || std::ranges::count(typed, ',') != 2) {
    throw UsageError("--view " + typed +
                     " is none: it is iso, top, front or side, or from where one "
                     "looks, such as 1,-1,1");
  }
  return -vector_of(from);
}

// How and how large, which say at once what is wrong with them.
std::pair<DrawingOptions, std::optional<DrawingScale>> typed(const DrawArguments& arguments) {
  constexpr std::array<std::string_view, 3> kKnown{".svg", ".pdf", ".png"};
  refuse_other_extensions(arguments.output, kKnown);
  if (arguments.shaded && page_of(arguments.output) != Page::png) {
    throw UsageError("--shaded is for pictures: write a .png file");
  }
  if (arguments.dots_per_inch && page_of(arguments.output) != Page::png) {
    throw UsageError(
        "--dpi is for pictures, and lines of SVG and PDF have no pixels: write a .png "
        "file, or leave it out");
  }
  refuse_idle_insulation(arguments.walls, arguments.region);
  try {
    const auto up = arguments.up.empty() ? std::nullopt : std::optional(vector_of(arguments.up));
    return {{view_along(direction_of(arguments), up), arguments.hidden, arguments.center},
            arguments.scale.empty() ? std::nullopt : std::optional(drawing_scale(arguments.scale))};
  } catch (const Error& error) {
    throw UsageError(error.message());
  }
}

ExitCode run_draw(const DrawArguments& arguments, const CommonOptions& common) {
  const auto [options, typed_scale] = typed(arguments);
  Document document = read_document(arguments.file, arguments.source, arguments.walls);
  BuildReport report;
  Drawing drawing;
  DrawingScale scale;
  {
    ProgressLine line(common.quiet);
    BuildOptions build = build_options(document.assembly, arguments, common);
    build.progress = line.callback();
    const Built built = dupin::build(document, build);
    tell(build.progress, "draw");
    drawing = draw(document.assembly, built, options);
    scale = typed_scale.value_or(fitting_scale(drawing));
    write_text(arguments.output, page(drawing, built.solid, scale, arguments, document.colours));
  }
  report.graph = std::move(document.network);
  report.piping = std::move(document.piping);
  std::ostream& out = report_stream(arguments.output);
  if (common.json) {
    out << drawing_report_json(drawing, scale, arguments.output, arguments.sheet) << '\n';
  } else if (!common.quiet) {
    print_source(out, report);
    print_drawing(out, drawing, scale, arguments);
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
      app.add_subcommand("draw", "Draw the visible outline of an assembly to scale");
  const auto arguments = std::make_shared<DrawArguments>();
  command
      ->add_option("FILE", arguments->file,
                   "assembly document, graph or piping file; - for standard input")
      ->type_name("")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "SVG, PDF (.pdf) or PNG (.png) file; - for standard output, as SVG")
      ->type_name("OUT")
      ->required();
  command
      ->add_option("--view", arguments->view,
                   "iso (the usual), top, front or side (from the right), or X,Y,Z from where\n"
                   "one looks")
      ->type_name("VIEW");
  add_vector_option(*command, "--direction", arguments->direction,
                    "To look along, instead of a view");
  command->get_option("--direction")->excludes(command->get_option("--view"));
  add_vector_option(*command, "--up", arguments->up,
                    "What is upwards in the picture; z if not given, or y seen along z");
  command
      ->add_option("--scale", arguments->scale,
                   "Such as 1:50; if not given, the largest usual one that fits on A3,\n"
                   "landscape")
      ->type_name("PAPER:REAL");
  command->add_flag("--hidden", arguments->hidden, "Draw hidden lines, too, dashed");
  command->add_flag("--axes", arguments->center, "Draw the axes of the parts, dash-dotted");
  command->add_flag("--names", arguments->sheet.names, "Write the parts' names beside them");
  command->add_flag("--dimensions", arguments->sheet.dimensions,
                    "Write the parts' diameters and, of a view along an axis, the overall\n"
                    "width and height");
  command->add_flag("--shaded", arguments->shaded,
                    "Show the solid behind the lines of a PNG, in colours, with light and shade");
  command
      ->add_option("--dpi", arguments->dots_per_inch,
                   "Pixels of a PNG for an inch of paper; 150 if not given")
      ->type_name("NUMBER")
      ->check(number_range(1, 2400));
  add_wall_options(*command, arguments->walls);
  add_region_option(*command, arguments->region);
  add_triangles_option(*command, arguments->most_triangles);
  add_source_options(*command, arguments->source);
  command->footer(
      "Contours of the smooth surfaces and the edges in which they meet, within --tolerance (the\n"
      "document's if not given).\n\n"
      "Examples:\n"
      "  dupin draw plant.json -o plant.svg\n"
      "  dupin draw plant.json -o plant.png --shaded\n"
      "  dupin draw line.pcf -o plan.pdf --view top --scale 1:100 --axes --dimensions");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_draw(*arguments, common); };
  });
}

}  // namespace dupin::cli
