#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/report_page.h"
#include "dupin/kernel/rounding.h"

namespace dupin {
namespace {

struct Case {
  Assembly assembly;
  BuildReport report;
  TriMesh mesh;
};

Case built(const std::string& parts, const std::string& head = "") {
  Case result{
      parse_assembly(R"({"units": "mm", "tolerance": 0.1, )" + head + "\"parts\": [" + parts + "]}",
                     "plant.json"),
      {},
      {}};
  Built built = build(result.assembly, {.connect = 1});
  const Rounded rounded = to_mesh(built.solid);
  result.report.output.check = check(rounded);
  result.report.output.rounding = rounded.report();
  result.report.gaps = {"plant.json", Unit::millimetre, 1, std::move(built.ports),
                        std::move(built.gaps)};
  result.report.parts = std::move(built.parts);
  result.report.region = built.region;
  result.report.volumes = built.volumes;
  result.mesh = rounded.mesh();
  return result;
}

const std::string kApart = R"(
  {"name": "run", "colour": "#cc3311", "pipe": {"from": [0, 0, 0], "to": [10, 0, 0], "radius": 2}},
  {"name": "next", "pipe": {"from": [10.5, 0, 0], "to": [20, 0, 0], "radius": 2}},
  {"name": "lid", "cap": {"at": "next.end"}})";

const PageSection& section(const ReportPage& page, const std::string& title) {
  const auto found = std::ranges::find(page.sections, title, &PageSection::title);
  if (found == page.sections.end()) {
    throw std::runtime_error("no section " + title);
  }
  return *found;
}

TEST(ReportPageBuild, shows_gaps_where_they_are) {
  const Case c = built(kApart);
  const ReportPage page = report_page({c.assembly, c.report}, c.mesh);
  EXPECT_EQ(page.title, "plant.json");
  const PageSection& gaps = section(page, "Gaps");
  ASSERT_EQ(gaps.rows.size(), 3);
  EXPECT_EQ(gaps.rows[0].cells,
            (std::vector<std::string>{"gap", "run.end", "next.start", "axial 0.5 mm"}));
  EXPECT_TRUE(gaps.rows[0].is_finding);
  EXPECT_TRUE(gaps.rows[0].place->is_marked);
  EXPECT_EQ(gaps.rows[0].place->at, Vec3(10.25, 0, 0));
  EXPECT_EQ(gaps.rows[0].place->lines.size(), 2);
  for (const Vec3& point : gaps.rows[0].place->lines[0]) {
    EXPECT_NEAR((point - Vec3(10, 0, 0)).norm(), 2, 1e-9);
  }
  EXPECT_EQ(gaps.rows[1].cells[0], "open");
  EXPECT_FALSE(gaps.rows[1].is_finding);
}

TEST(ReportPageBuild, has_every_label_in_one_part) {
  const Case c = built(kApart);
  const ReportPage page = report_page({c.assembly, c.report}, c.mesh);
  std::vector<std::uint32_t> labels;
  for (const PagePart& part : page.parts) {
    labels.insert(labels.end(), part.labels.begin(), part.labels.end());
  }
  std::ranges::sort(labels);
  ASSERT_EQ(labels.size(), page.mesh.names.size());
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    EXPECT_EQ(labels[i], i);
  }
  EXPECT_EQ(page.parts[0].colour, "");
  EXPECT_EQ(page.parts.back().name, "lid");
  EXPECT_EQ(page.parts.back().kind, "cap");
}

TEST(ReportPageBuild, parts_have_the_colours_of_the_document) {
  const Case c = built(kApart);
  BuiltDocument document{c.assembly, c.report};
  document.colours = {{"run", "#cc3311"}};
  const ReportPage page = report_page(document, c.mesh);
  EXPECT_EQ(page.parts[0].colour, "#cc3311");
  EXPECT_EQ(page.parts[1].colour, "");
}

TEST(ReportPageBuild, leads_to_the_tightest_place_and_the_thinnest_wall) {
  const Case c = built(R"(
    {"name": "run", "pipe": {"from": [0, 0, -20], "to": [0, 0, 0], "radius": 4}},
    {"name": "bend", "elbow": {"from": "run.end", "bend_radius": 10, "angle": 90, "toward": [1, 0, 0]}})",
                       R"("wall": 1, )");
  const ReportPage page = report_page({c.assembly, c.report}, c.mesh);
  const PageSection& margins = section(page, "Margins");
  ASSERT_EQ(margins.rows.size(), 2);
  EXPECT_EQ(margins.rows[0].cells[0], "bend");
  EXPECT_NEAR(std::stod(margins.rows[0].cells[1]), 0.6, 1e-5);
  EXPECT_NEAR((margins.rows[0].place->at - Vec3(10, 0, 0)).norm(), 10, 1e-6);
  const PageSection& walls = section(page, "Walls");
  ASSERT_FALSE(walls.rows.empty());
  EXPECT_NEAR(std::stod(walls.rows[0].cells[1]), 1, 0.2);
  const PageSection& volumes = section(page, "Volumes");
  EXPECT_EQ(volumes.rows.size(), 3);
  const auto row = [&page](const std::string& what) {
    const auto& rows = section(page, "Overview").rows;
    const auto found = std::ranges::find_if(
        rows, [&what](const PageRow& shown) { return shown.cells[0] == what; });
    return found == rows.end() ? PageRow{{what, "missing"}} : *found;
  };
  EXPECT_THAT(row("smallest margin").cells[1], testing::StartsWith("proved, at least 0.59999"));
  EXPECT_THAT(row("smallest margin").cells[1], testing::EndsWith(", bend"));
  EXPECT_EQ(row("smallest margin").part, 1);
  EXPECT_THAT(row("least wall").cells[1], testing::StartsWith("proved, at least 0.9"));
}

// As the bill of materials has it.
TEST(ReportPageBuild, has_the_metal_of_what_has_no_wall) {
  constexpr const char* kTwo = R"(
    {"name": "pipe", "pipe": {"from": [0, 0, 0], "to": [0, 0, 20], "radius": 4}},
    {"name": "plug", "pipe": {"from": "pipe.end", "length": 5}, "wall": 0})";
  for (const char* const head : {"", R"("wall": 1, )"}) {
    const bool is_hollow = *head != 0;
    const Case c = built(kTwo, head);
    const ReportPage page = report_page({c.assembly, c.report}, c.mesh);
    const std::vector<PageRow>& rows = section(page, "Volumes").rows;
    ASSERT_EQ(rows.size(), 3);
    for (const PageRow& row : rows) {
      const bool has_bore = is_hollow && row.cells[0] != "plug";
      EXPECT_EQ(row.cells[4] == row.cells[3], !has_bore) << row.cells[0];
      EXPECT_NE(row.cells[4], "") << row.cells[0];
    }
    EXPECT_EQ(rows[0].cells[5] == "0 mm³", !is_hollow) << rows[0].cells[5];
    EXPECT_EQ(rows[1].cells[5] == "", !is_hollow);
    EXPECT_EQ(rows[2].cells[5], "");
  }
}

TEST(ReportPageBuild, counts_claims_by_their_verdict) {
  const Case c = built(kApart);
  const Certificate certificate = certify(c.assembly);
  BuiltDocument document{c.assembly, c.report};
  document.certificate = &certificate;
  const PageSection shown = section(report_page(document, c.mesh), "Certificate");
  EXPECT_THAT(shown.note, testing::HasSubstr("embedded: 2 proved, 0 refuted, 0 undecided"));
  EXPECT_THAT(shown.note, testing::HasSubstr("mesh error: 2 proved"));
  EXPECT_TRUE(std::ranges::none_of(shown.rows, &PageRow::is_finding));
  EXPECT_EQ(
      std::ranges::find(shown.rows, "next", [](const PageRow& row) { return row.cells.at(2); })
          ->part,
      1);
}

}  // namespace
}  // namespace dupin
