#include "dupin/io/drawing_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using testing::HasSubstr;

Drawing drawing() {
  Drawing result{"a<b.json", Unit::centimetre, view_along(-Vec3::UnitZ()), 0.01, {}};
  result.lines.push_back({"pipe & co", LineKind::contour, false, {{0, 0}, {10, 0}, {10, 5}}});
  result.lines.push_back({"pipe & co", LineKind::edge, true, {{1, 1}, {2, 1}}});
  result.lines.push_back({"a", LineKind::edge, false, {{1, 1}, {2, 1}, {1, 2}, {1, 1}}});
  return result;
}

TEST(DrawingSvg, puts_lines_on_paper) {
  const std::string svg = drawing_svg(drawing(), {1, 2});
  EXPECT_EQ(size_on_paper(drawing(), {1, 2}), Eigen::Vector2d(60, 35));
  EXPECT_THAT(svg, HasSubstr(R"(width="60mm" height="35mm" viewBox="0 0 60 35")"));
  EXPECT_THAT(svg, HasSubstr("<title>a&lt;b.json 1:2</title>"));
  // Closed ones say so; parts in order, hidden lines first.
  EXPECT_THAT(
      svg,
      HasSubstr("<g>\n<title>a</title>\n<path class=\"edge\" d=\"M10 25L15 25 10 20Z\"/>\n</g>\n"
                "<g>\n<title>pipe &amp; co</title>\n"
                "<path class=\"hidden\" d=\"M10 25L15 25\"/>\n"
                "<path class=\"contour\" d=\"M5 30L55 30 55 5\"/>\n</g>\n</svg>\n"));
}

TEST(DrawingSvg, text_keeps_lines_away) {
  EXPECT_THAT(
      drawing_svg(drawing(), {1, 2}, {.names = true}),
      testing::ContainsRegex("text \\{[^}]*paint-order: stroke; stroke: #fff; stroke-width: 0.8"));
}

TEST(DrawingSvg, of_nothing_is_an_empty_sheet) {
  const Drawing nothing{"x", Unit::metre, {}, 0, {}};
  EXPECT_EQ(size_on_paper(nothing, {1, 1}), Eigen::Vector2d(10, 10));
  EXPECT_THAT(drawing_svg(nothing, {}), HasSubstr("viewBox=\"0 0 10 10\""));
  EXPECT_EQ(to_string(fitting_scale(nothing)), "1:1");
}

TEST(DrawingSvg, fits_on_a_sheet) {
  for (const auto& [width, height, scale] :
       std::vector<std::tuple<double, double, std::string>>{{40, 1, "1:1"},
                                                            {40.01, 1, "1:2"},
                                                            {1, 27.7, "1:1"},
                                                            {1, 27.71, "1:2"},
                                                            {20, 1, "2:1"},
                                                            {8, 1, "5:1"},
                                                            {4, 1, "10:1"},
                                                            {0.4, 0.1, "100:1"},
                                                            {0.41, 0.1, "50:1"},
                                                            {81, 1, "1:5"},
                                                            {20000, 1, "1:500"},
                                                            {20001, 1, "1:1000"}}) {
    Drawing one{"", Unit::centimetre, {}, 0, {}};
    one.lines.push_back({"", LineKind::edge, false, {{0, 0}, {width, height}}});
    EXPECT_EQ(to_string(fitting_scale(one)), scale) << width << " " << height;
  }
}

TEST(DrawingSvg, reads_scales) {
  EXPECT_EQ(drawing_scale("1:50").real, 50);
  EXPECT_EQ(drawing_scale("2.5:1").paper, 2.5);
  for (const char* bad : {"", "1", ":", "1:", ":2", "1:0", "0:1", "-1:2", "1:nan", "inf:1", "1:2:3",
                          "1/2", " 1:2", "1:2 "}) {
    EXPECT_THROW((void)drawing_scale(bad), Error) << bad;
  }
}

}  // namespace
}  // namespace dupin
