#include <gtest/gtest.h>

#include "drawings/annotations.h"

namespace dupin::drawings {
namespace {

Drawing drawing(double error, Unit unit = Unit::millimetre) {
  return {"a", unit, view_along(-Vec3::UnitZ()), error, {}};
}

TEST(Annotations, lengths_have_the_digits_that_the_error_leaves) {
  EXPECT_EQ(length_text(drawing(0.02), 123.456), "123.5");
  EXPECT_EQ(length_text(drawing(0.001), 123.4567), "123.457");
  EXPECT_EQ(length_text(drawing(0.5), 60.3), "60");
  EXPECT_EQ(length_text(drawing(5), 12345), "12350");
  EXPECT_EQ(length_text(drawing(0.0001, Unit::metre), 0.06), "0.06 m");
  EXPECT_EQ(length_text(drawing(0), 2.5), "2.5");
}

TEST(Annotations, notes_do_not_cover_each_other) {
  Drawing many = drawing(0.01);
  PaperSheet sheet;
  for (int i = 0; i < 6; ++i) {
    many.parts.push_back({"part " + std::to_string(i), {i, 0}, {1, 1}});
  }
  add_notes(many, {true, false}, sheet);
  ASSERT_EQ(sheet.texts.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector2d apart = (sheet.texts[i].at - sheet.texts[j].at).cwiseAbs();
      EXPECT_TRUE(apart[1] > kTextHeight || apart[0] > 0.5 * kFontSize * 6) << i << " " << j;
    }
  }
}

TEST(Annotations, extents_are_of_the_outline_in_views_along_an_axis) {
  Drawing box = drawing(0.01);
  PaperSheet sheet;
  sheet.lines.push_back({Pen::edge, "a", {{0, 0}, {30, -20}}});
  sheet.lines.push_back({Pen::center, "a", {{-3, 0}, {33, 0}}});
  sheet.lines.push_back({Pen::thin, {}, {{0, 0}, {0, 50}}});  // a note's
  add_extents(box, sheet);
  ASSERT_EQ(sheet.texts.size(), 2U);
  EXPECT_EQ(sheet.texts[0].text, "30");
  EXPECT_EQ(sheet.texts[1].text, "20");
  EXPECT_TRUE(sheet.texts[1].is_upright);
  box.view = view_along({-1, 1, -1});
  PaperSheet oblique;
  oblique.lines = {sheet.lines.front()};
  add_extents(box, oblique);
  EXPECT_TRUE(oblique.texts.empty());
}

}  // namespace
}  // namespace dupin::drawings
