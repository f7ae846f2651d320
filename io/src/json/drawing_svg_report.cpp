#include <algorithm>

#include "dupin/io/drawing_svg.h"
#include "dupin/kernel/parallel.h"
#include "json/json_value.h"

namespace dupin {

std::string drawing_report_json(const Drawing& drawing, const DrawingScale& scale,
                                const std::string& file, const SheetOptions& options) {
  const UsualArithmetic usual;
  using json::Json;
  const Eigen::Vector2d size = size_on_paper(drawing, scale, options);
  const auto count = [&](LineKind kind) {
    return std::ranges::count_if(
        drawing.lines, [&](const DrawnLine& line) { return line.kind == kind && !line.hidden; });
  };
  return json::text(
      Json{{"file", file},
           {"unit", symbol(drawing.unit)},
           {"scale", to_string(scale)},
           {"size", {size[0], size[1]}},
           {"direction", json::json_value(Vec3(-drawing.view.towards))},
           {"up", json::json_value(drawing.view.up)},
           {"error", drawing.error},
           {"lines",
            {{"contour", count(LineKind::contour)},
             {"edge", count(LineKind::edge)},
             {"center", count(LineKind::center)},
             {"hidden", std::ranges::count(drawing.lines, true, &DrawnLine::hidden)}}}});
}

}  // namespace dupin
