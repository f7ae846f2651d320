#include "report_text.h"

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace dupin::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ReportText, numbers_have_nine_digits) {
  EXPECT_EQ(number(1.0 / 3), "0.333333333");
  EXPECT_EQ(number(-2), "-2");
  EXPECT_EQ(number(1234567890), "1.23456789e+09");
  EXPECT_EQ(place_text(Vec3(0.1, 1, -1e-10)), "(0.1, 1, -1e-10)");
}

TEST(ReportText, one_is_singular) {
  EXPECT_EQ(counted(0, "point"), "0 points");
  EXPECT_EQ(counted(1, "point"), "1 point");
  EXPECT_EQ(counted(2, "point"), "2 points");
}

TEST(ReportText, values_stand_in_a_column) {
  std::ostringstream out;
  print_row(out, "volume", "8");
  print_row(out, "a label that is longer", "9");
  EXPECT_EQ(out.str(), "volume               8\na label that is longer 9\n");
}

TEST(ReportText, values_are_one_line_whatever_is_in_them) {
  std::ostringstream out;
  print_row(out, "label", "a\tb\nc\x1b[31m\x7f \xc3\xa9");
  EXPECT_EQ(out.str(), "label                a\\x09b\\x0ac\\x1b[31m\\x7f \xc3\xa9\n");
  std::ostringstream more;
  print_row(more, "label", "\xc2\x85\xc2\xa0\u202e\u202f\u2069 \xe2");
  EXPECT_EQ(more.str(),
            "label                \\xc2\\x85\xc2\xa0\\xe2\\x80\\xae\u202f\\xe2\\x81\\xa9 \\xe2\n");
  OutputReport report;
  report.contacts = {{Contact::Kind::vertex, Vec3::Zero(), Vec3::Zero(), {"a\nb"}}};
  std::ostringstream output;
  print_output(output, report, "mm");
  EXPECT_THAT(output.str(), HasSubstr(": a\\x0ab\n"));
}

std::string text_of(const OutputReport& report, std::string_view unit) {
  std::ostringstream out;
  print_output(out, report, unit);
  return out.str();
}

TEST(ReportText, an_output_tells_only_what_happened) {
  OutputReport report;
  report.file = "a.stl";
  report.format = "binary STL";
  EXPECT_EQ(text_of(report, "mm"),
            "written              a.stl, binary STL\n"
            "rounding             none\n"
            "verified             no\n");
  report.rounding.moved = 1;
  report.rounding.largest_move = 0.5;
  report.rounding.filled_places = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  report.rounding.snapped_places = {Vec3(7, 8, 9)};
  report.rounding.slit_width = 0.25;
  report.rounding.removed_shells = 2;
  report.rounding.thin_shells = {{Vec3(4, 5, 6), 0.01, 0.0625}, {Vec3(7, 5, 6), 0.02, 0.0625}};
  report.rounding.origin = Vec3(1, 2, 3);
  report.simplification = {12, 0.125};
  report.verification = Verification::full;
  report.check = check(test::box({0, 0, 0}, {2, 2, 2}));
  const std::string text = text_of(report, "mm");
  EXPECT_THAT(text, HasSubstr("rounding             1 point moved, at most 0.5 mm\n"));
  EXPECT_THAT(
      text, HasSubstr("slits                2 filled, at most 0.25 mm wide, first at (1, 2, 3)\n"));
  EXPECT_THAT(text, HasSubstr("snapped              1 time, first at (7, 8, 9)\n"));
  EXPECT_THAT(
      text,
      HasSubstr("removed              2 shells that the numbers of the format cannot hold\n"));
  EXPECT_THAT(text, HasSubstr("warning              rounding moves points by up to 0.0625 mm, more "
                              "than the shell there is thick, 0.01 mm, at (4, 5, 6), and in 1 "
                              "other shell\n"));
  EXPECT_THAT(text, HasSubstr("origin               (1, 2, 3)\n"));
  EXPECT_THAT(text,
              HasSubstr("simplified           12 triangles less, deviation at most 0.125 mm"));
  EXPECT_THAT(text, HasSubstr("volume               8 mm^3\n"));
  EXPECT_THAT(text, HasSubstr("area                 24 mm^2\n"));
  EXPECT_THAT(text_of(report, ""), HasSubstr("volume               8\n"));
}

TEST(ReportText, contacts_that_are_settled_take_the_place_of_those_that_are) {
  OutputReport report;
  const Contact edge{Contact::Kind::edge, Vec3(0, 0, 0), Vec3(0, 0, 1), {"a", ""}};
  const Contact point{Contact::Kind::vertex, Vec3(1, 0, 0), Vec3(1, 0, 0), {}};
  report.contacts = {edge, point};
  EXPECT_THAT(text_of(report, "mm"), HasSubstr("contacts             2\n"
                                               "  edge (0, 0, 0) to (0, 0, 1): a, (no name)\n"
                                               "  point (1, 0, 0)\n"));
  report.settled = {"bridge", 0.5, {edge}};
  EXPECT_THAT(text_of(report, "mm"), HasSubstr("contacts             1 bridged within 0.5 mm\n"));
  EXPECT_THAT(text_of(report, "mm"), Not(HasSubstr("point (1, 0, 0)")));
}

TEST(ReportText, repairs_are_told_file_by_file) {
  OutputReport report;
  RepairReport repair;
  repair.merged_points = 1;
  repair.duplicate_faces = 2;
  repair.united_overlaps = true;
  repair.cavities = 1;
  report.repairs = {{"a.off", repair}};
  EXPECT_THAT(text_of(report, ""),
              HasSubstr("repaired             a.off: 1 point merged, 2 faces dropped as "
                        "duplicates, overlaps united, 1 shell kept as a cavity\n"));
}

TEST(ReportText, findings_beyond_five_are_counted) {
  TriMesh empty_holes;
  for (int i = 0; i < 3; ++i) {
    const TriMesh hole = test::box({3.0 * i, 0, 0}, {3.0 * i + 1, 1, 1});
    const auto first = static_cast<std::uint32_t>(empty_holes.points.size());
    empty_holes.points.insert(empty_holes.points.end(), hole.points.begin(), hole.points.end());
    for (std::size_t face = 1; face < hole.triangles.size(); ++face) {
      Triangle triangle = hole.triangles[face];
      for (std::uint32_t& corner : triangle) {
        corner += first;
      }
      empty_holes.triangles.push_back(triangle);
    }
  }
  std::ostringstream out;
  print_report(out, check(empty_holes));
  EXPECT_THAT(out.str(), HasSubstr("solid                no\nboundary_edge: 9\n  face "));
  EXPECT_THAT(out.str(), HasSubstr("  and 4 more\n"));
}

}  // namespace
}  // namespace dupin::cli
