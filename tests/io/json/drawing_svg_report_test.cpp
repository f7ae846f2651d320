#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/io/drawing_svg.h"

namespace dupin {
namespace {

TEST(DrawingSvgReport, counts_lines) {
  Drawing drawing{"x", Unit::inch, view_along(Vec3::UnitY()), 0.5, {}};
  drawing.lines.push_back({"a", LineKind::contour, false, {{0, 0}, {1, 2}}});
  drawing.lines.push_back({"a", LineKind::contour, true, {{0, 0}, {1, 2}}});
  drawing.lines.push_back({"b", LineKind::edge, false, {{0, 0}, {1, 2}}});
  const auto report = nlohmann::json::parse(drawing_report_json(drawing, {1, 10}, "out.svg"));
  EXPECT_EQ(report, nlohmann::json::parse(R"({"file": "out.svg", "unit": "in", "scale": "1:10",
      "size": [12.54, 15.08], "direction": [0, 1, 0], "up": [0, 0, 1], "error": 0.5,
      "lines": {"center": 0, "contour": 1, "edge": 1, "hidden": 1}})"));
}

}  // namespace
}  // namespace dupin
