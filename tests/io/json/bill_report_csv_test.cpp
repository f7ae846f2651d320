#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/bill_report.h"

namespace dupin {
namespace {

// Cells by the rules of RFC 4180.
std::vector<std::vector<std::string>> cells(const std::string& text) {
  std::vector<std::vector<std::string>> lines{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') {
      lines.back().back() += '"';
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      lines.back().emplace_back();
    } else if (c == '\r' && !quoted) {
      EXPECT_EQ(text.at(++i), '\n');
      lines.push_back({""});
    } else {
      lines.back().back() += c;
    }
  }
  EXPECT_FALSE(quoted);
  EXPECT_EQ(lines.back(), std::vector<std::string>{""});
  lines.pop_back();
  return lines;
}

TEST(BillCsv, has_as_many_cells_in_every_line_whatever_the_names) {
  BillReport report;
  report.bill.unit = Unit::inch;
  BillRow full;
  full.name = "a \"quoted\", two-line\r\nname";
  full.kind = "pipe";
  full.sizes = {{4.5, 4.5}};
  full.length = 2.5;
  full.metal = full.outer = SolidMoments{3, Vec3(1, 2, 4), Eigen::Matrix3d::Identity()};
  BillRow empty;
  empty.name = "b";
  empty.index = 1;
  empty.remarks = {"one", "two"};
  report.bill.rows = {full, empty};
  report.origins = {{"comp", "PIPE", 17}};
  const auto lines = cells(to_csv(report));
  ASSERT_EQ(lines.size(), 4U);
  const auto at = [&](std::size_t line, const std::string& column) {
    const auto found = std::ranges::find(lines[0], column);
    EXPECT_NE(found, lines[0].end()) << column;
    return lines[line].at(std::size_t(found - lines[0].begin()));
  };
  for (const auto& line : lines) {
    EXPECT_EQ(line.size(), lines[0].size());
  }
  EXPECT_EQ(at(1, "name"), full.name);
  EXPECT_EQ(at(1, "component"), "comp");
  EXPECT_EQ(at(1, "line"), "17");
  EXPECT_EQ(at(1, "size"), "DN100");
  EXPECT_EQ(at(1, "length_in"), "2.5");
  EXPECT_EQ(at(1, "metal_volume_in3"), "3");
  EXPECT_EQ(at(1, "center_z_in"), "4");
  EXPECT_EQ(at(1, "inertia_xx_in5"), "2");
  EXPECT_EQ(at(2, "metal_volume_in3"), "");
  EXPECT_EQ(at(2, "inertia_xx_in5"), "");
  EXPECT_EQ(at(2, "line"), "");
  EXPECT_EQ(at(2, "remarks"), "one; two");
  EXPECT_EQ(at(3, "name"), "sum");
  EXPECT_EQ(at(3, "metal_volume_in3"), "3");
  // No row has any: that is not 0.
  EXPECT_EQ(at(3, "wall_in"), "");
  EXPECT_EQ(at(3, "area_in2"), "");
  EXPECT_EQ(at(3, "fluid_volume_in3"), "");
}

TEST(BillCsv, has_no_texts_that_spreadsheets_take_for_formulas) {
  for (const std::string name : {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "\n=1"}) {
    BillReport report;
    BillRow row;
    row.name = name;
    row.kind = "pipe";
    row.remarks = {name};
    report.bill.rows = {row};
    report.origins = {{name, name, 1}};
    const auto line = cells(to_csv(report)).at(1);
    for (const std::size_t column : {std::size_t(0), std::size_t(2), line.size() - 1}) {
      EXPECT_EQ(line.at(column), "'" + name);
    }
    EXPECT_EQ(line.at(1), "pipe");
  }
  BillReport report;
  report.bill.rows.emplace_back().name = "a=b-c+d@e";
  EXPECT_EQ(cells(to_csv(report)).at(1).at(0), "a=b-c+d@e");
}

}  // namespace
}  // namespace dupin
