#include "dupin/io/drawing_svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Geometry>

#include "drawings/paper_sheet.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "text/xml_text.h"

namespace dupin {
namespace {

Eigen::AlignedBox2d bounds(const Drawing& drawing) {
  Eigen::AlignedBox2d box;
  for (const DrawnLine& line : drawing.lines) {
    for (const Eigen::Vector2d& point : line.points) {
      box.extend(point);
    }
  }
  return box.isEmpty() ? Eigen::AlignedBox2d(Eigen::Vector2d(0, 0)) : box;
}

// To a thousandth of a millimetre, which is far below a line's width.
void append_paper(std::string& text, double value) {
  append_decimal(text, std::round(1000 * value) / 1000 + 0.0);
}

void append_path(std::string& text, const drawings::PaperLine& line) {
  text += "<path class=\"";
  text.append(name(line.pen)).append("\" d=\"M");
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    append_paper(text, line.points[i][0]);
    text += ' ';
    append_paper(text, line.points[i][1]);
    text += i == 0 ? "L" : " ";
  }
  text.back() = line.is_closed ? 'Z' : '"';
  text += line.is_closed ? "\"/>\n" : "/>\n";
}

void append_text(std::string& text, const drawings::PaperText& one) {
  text += one.is_centered ? "<text class=\"centered\" " : "<text ";
  text += one.is_upright ? "transform=\"translate(" : "x=\"";
  append_paper(text, one.at[0]);
  text += one.is_upright ? " " : "\" y=\"";
  append_paper(text, one.at[1]);
  text += one.is_upright ? ") rotate(-90)\">" : "\">";
  text.append(text::xml_escaped(one.text)).append("</text>\n");
}

double positive(const std::string& text, std::string_view number) {
  double value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc() || end != number.data() + number.size() || !std::isfinite(value) ||
      !(value > 0)) {
    throw Error(Errc::invalid_argument,
                "'" + text + "' is no scale; a scale is such as 1:50 or 2:1, two positive numbers");
  }
  return value;
}

}  // namespace

std::string to_string(const DrawingScale& scale) {
  const UsualArithmetic usual;
  return decimal(scale.paper).append(":").append(decimal(scale.real));
}

DrawingScale drawing_scale(const std::string& text) {
  const UsualArithmetic usual;
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view whole = text;
  const std::string_view real = whole.substr(std::min(colon + 1, text.size()));
  return {positive(text, whole.substr(0, colon)), positive(text, real)};
}

DrawingScale fitting_scale(const Drawing& drawing) {
  const UsualArithmetic usual;
  constexpr double kWidth = 420 - 20, kHeight = 297 - 20;
  const Eigen::Vector2d size = bounds(drawing).sizes() * millimetres(drawing.unit);
  const double larger = std::max(size[0] / kWidth, size[1] / kHeight);
  if (!(larger > 0)) {
    return {};
  }
  return drawings::usual_scale(larger);
}

Eigen::Vector2d size_on_paper(const Drawing& drawing, const DrawingScale& scale,
                              const SheetOptions& options) {
  const UsualArithmetic usual;
  return drawings::paper_sheet(drawing, scale, options).size;
}

std::string drawing_svg(const Drawing& drawing, const DrawingScale& scale,
                        const SheetOptions& options) {
  const UsualArithmetic usual;
  const drawings::PaperSheet sheet = drawings::paper_sheet(drawing, scale, options);
  std::string width, height;
  append_paper(width, sheet.size[0]);
  append_paper(height, sheet.size[1]);
  std::string text = R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width=")";
  text.append(width).append("mm\" height=\"").append(height).append("mm\" viewBox=\"0 0 ");
  text.append(width).append(" ").append(height).append("\">\n<title>");
  text.append(text::xml_escaped(sheet.title));
  text += R"(</title>
<style>
path { fill: none; stroke: #000; stroke-linecap: round; stroke-linejoin: round; }
.contour, .edge { stroke-width: 0.35; }
.hidden { stroke-width: 0.18; stroke-dasharray: 2 1; }
.center { stroke-width: 0.18; stroke-dasharray: 6 1 0.5 1; stroke-linecap: butt; }
.thin { stroke-width: 0.18; }
.arrow { fill: #000; stroke: none; }
text { font: 3.5px sans-serif; paint-order: stroke; stroke: #fff; stroke-width: 0.8; stroke-linejoin: round; }
.centered { text-anchor: middle; }
</style>
)";
  std::map<std::string_view, std::string> groups;
  std::string others;
  for (const drawings::PaperLine& line : sheet.lines) {
    append_path(line.part.empty() ? others : groups[line.part], line);
  }
  for (const auto& [part, paths] : groups) {
    text.append("<g>\n<title>").append(text::xml_escaped(part)).append("</title>\n");
    text.append(paths).append("</g>\n");
  }
  text += others;
  for (const drawings::PaperText& one : sheet.texts) {
    append_text(text, one);
  }
  return text + "</svg>\n";
}

}  // namespace dupin
