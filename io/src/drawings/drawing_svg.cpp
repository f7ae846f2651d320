#include "dupin/io/drawing_svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Geometry>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "text/xml_text.h"

namespace dupin {
namespace {

constexpr double kAround = 5;  // millimetres of paper

double paper_millimetres(const Drawing& drawing, const DrawingScale& scale) {
  return millimetres(drawing.unit) * scale.paper / scale.real;
}

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

std::string_view style_class(const DrawnLine& line) {
  return line.hidden ? "hidden" : line.kind == LineKind::contour ? "contour" : "edge";
}

// Puts points on paper, whose y axis points down.
class Path {
 public:
  Path(const Drawing& drawing, const DrawingScale& scale)
      : factor_(paper_millimetres(drawing, scale)),
        corner_(bounds(drawing).min()[0], bounds(drawing).max()[1]) {}

  void append(std::string& text, const DrawnLine& line) const {
    const bool is_closed = line.points.size() > 2 && line.points.front() == line.points.back();
    text += "<path class=\"";
    text.append(style_class(line)).append("\" d=\"M");
    for (std::size_t i = 0; i + (is_closed ? 1 : 0) < line.points.size(); ++i) {
      const Eigen::Vector2d from_corner = factor_ * (line.points[i] - corner_);
      append_paper(text, from_corner[0] + kAround);
      text += ' ';
      append_paper(text, -from_corner[1] + kAround);
      text += i == 0 ? "L" : " ";
    }
    text.back() = is_closed ? 'Z' : '"';
    text += is_closed ? "\"/>\n" : "/>\n";
  }

 private:
  double factor_;
  Eigen::Vector2d corner_;
};

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
  return decimal(scale.paper).append(":").append(decimal(scale.real));
}

DrawingScale drawing_scale(const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view whole = text;
  const std::string_view real = whole.substr(std::min(colon + 1, text.size()));
  return {positive(text, whole.substr(0, colon)), positive(text, real)};
}

DrawingScale fitting_scale(const Drawing& drawing) {
  constexpr double kWidth = 420 - 20, kHeight = 297 - 20;
  const Eigen::Vector2d size = bounds(drawing).sizes() * millimetres(drawing.unit);
  const double larger = std::max(size[0] / kWidth, size[1] / kHeight);
  if (!(larger > 0)) {
    return {};
  }
  // The least 1, 2 or 5 times a power of ten that is not below `larger`.
  for (int exponent = int(std::floor(std::log10(larger)));; ++exponent) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double power = std::pow(10.0, std::abs(exponent));
      const double ratio = exponent < 0 ? digit / power : digit * power;
      if (ratio >= larger) {
        // 5 / 100 is 1 / 20, 2 / 100 is 1 / 50.
        return ratio >= 1 ? DrawingScale{1, ratio} : DrawingScale{std::round(power / digit), 1};
      }
    }
  }
}

Eigen::Vector2d size_on_paper(const Drawing& drawing, const DrawingScale& scale) {
  return bounds(drawing).sizes() * paper_millimetres(drawing, scale) +
         Eigen::Vector2d::Constant(2 * kAround);
}

std::string drawing_svg(const Drawing& drawing, const DrawingScale& scale) {
  const Eigen::Vector2d size = size_on_paper(drawing, scale);
  std::string width, height;
  append_paper(width, size[0]);
  append_paper(height, size[1]);
  std::string text = R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" version="1.1" width=")";
  text.append(width).append("mm\" height=\"").append(height).append("mm\" viewBox=\"0 0 ");
  text.append(width).append(" ").append(height).append("\">\n<title>");
  text.append(text::xml_escaped(drawing.source)).append(" ").append(to_string(scale));
  text += R"(</title>
<style>
path { fill: none; stroke: #000; stroke-linecap: round; stroke-linejoin: round; }
.contour, .edge { stroke-width: 0.35; }
.hidden { stroke-width: 0.18; stroke-dasharray: 2 1; }
</style>
)";
  std::map<std::string_view, std::string> groups;
  const Path path(drawing, scale);
  for (const bool hidden : {true, false}) {  // visible lines lie over hidden ones
    for (const DrawnLine& line : drawing.lines) {
      if (line.hidden == hidden) {
        path.append(groups[line.part], line);
      }
    }
  }
  for (const auto& [part, paths] : groups) {
    text.append("<g>\n<title>").append(text::xml_escaped(part)).append("</title>\n");
    text.append(paths).append("</g>\n");
  }
  return text + "</svg>\n";
}

}  // namespace dupin
