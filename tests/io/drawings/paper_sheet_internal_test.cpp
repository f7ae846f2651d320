#include <gtest/gtest.h>

#include "drawings/paper_sheet.h"

namespace dupin::drawings {
namespace {

Drawing drawing() {
  Drawing result{"a", Unit::millimetre, view_along(-Vec3::UnitZ()), 0.01, {}};
  result.lines.push_back(
      {"p", LineKind::contour, false, {{0, 0}, {40, 0}, {40, 20}, {0, 20}, {0, 0}}});
  result.lines.push_back({"p", LineKind::center, false, {{0, 10}, {20, 10}}});
  result.lines.push_back({"q", LineKind::center, false, {{20, 10}, {40, 10}}});
  result.parts.push_back({"p", {10, 10}, {20, 10}});
  return result;
}

TEST(PaperSheet, lets_axes_reach_out_of_the_outline_but_not_into_each_other) {
  const PaperSheet sheet = paper_sheet(drawing(), {1, 2}, {});
  ASSERT_EQ(sheet.lines.size(), 3U);
  EXPECT_EQ(sheet.lines[0].pen, Pen::center);  // below the outline
  EXPECT_NEAR((sheet.lines[0].points[1] - sheet.lines[0].points[0]).norm(), 10 + 3, 1e-12);
  EXPECT_EQ(sheet.lines[0].points[1], sheet.lines[1].points[0]);
  EXPECT_TRUE(sheet.lines[2].is_closed);
  EXPECT_NEAR(sheet.size[0], 20 + 2 * 3 + 2 * 5, 1e-12);
  EXPECT_NEAR(sheet.size[1], 10 + 2 * 5, 1e-12);
}

TEST(PaperSheet, keeps_all_that_is_written_on_the_paper) {
  const PaperSheet sheet = paper_sheet(drawing(), {1, 1}, {true, true});
  EXPECT_EQ(sheet.texts.size(), 4U);  // name, diameters, width, height
  for (const PaperLine& line : sheet.lines) {
    for (const Eigen::Vector2d& point : line.points) {
      EXPECT_GE(point.minCoeff(), 0);
      EXPECT_LE(point[0], sheet.size[0]);
      EXPECT_LE(point[1], sheet.size[1]);
    }
  }
}

}  // namespace
}  // namespace dupin::drawings
