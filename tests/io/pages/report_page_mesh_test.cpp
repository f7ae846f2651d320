#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/report_page.h"
#include "support/shapes.h"

namespace dupin {
namespace {

MeshSummary summary_of(TriMesh mesh) {
  MeshSummary summary{"part.stl", "mm", std::move(mesh), {}};
  summary.check = check(summary.mesh);
  return summary;
}

TEST(ReportPageMesh, shows_a_solid_with_its_walls) {
  const ReportPage page =
      report_page(summary_of(test::labelled(test::box({0, 0, 0}, {1, 2, 3}), "box.side")));
  EXPECT_EQ(page.summary, "12 triangles, a solid");
  ASSERT_EQ(page.parts.size(), 1);
  EXPECT_EQ(page.parts[0].name, "box");
  EXPECT_TRUE(std::ranges::none_of(page.sections,
                                   [](const PageSection& s) { return s.title == "Faults"; }));
  const auto walls = std::ranges::find(page.sections, "Walls", &PageSection::title);
  ASSERT_NE(walls, page.sections.end());
  EXPECT_EQ(walls->rows.at(0).cells.at(1), "1 mm");
}

TEST(ReportPageMesh, leads_to_every_fault) {
  TriMesh open = test::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  const ReportPage page = report_page(summary_of(open));
  EXPECT_EQ(page.summary, "11 triangles, no solid");
  const auto faults = std::ranges::find(page.sections, "Faults", &PageSection::title);
  ASSERT_NE(faults, page.sections.end());
  EXPECT_THAT(faults->note, testing::HasSubstr("3 boundary_edge"));
  for (const PageRow& row : faults->rows) {
    EXPECT_TRUE(row.is_finding);
    ASSERT_TRUE(row.place);
    EXPECT_TRUE(row.place->is_marked);
  }
}

}  // namespace
}  // namespace dupin
