#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pages/page_sections.h"
#include "support/shapes.h"

namespace dupin::pages {
namespace {

TEST(PageSections, numbers_have_units) {
  EXPECT_EQ(measure(1.5), "1.5");
  EXPECT_EQ(measure(1.5, "mm"), "1.5 mm");
  EXPECT_EQ(measure(1.5, "mm", 3), "1.5 mm\u00b3");
  EXPECT_EQ(counted(1, "point") + ", " + counted(2, "point"), "1 point, 2 points");
}

TEST(PageSections, an_outline_is_closed) {
  const auto points = outline({{1, 2, 3}, Vec3::UnitX(), 5});
  EXPECT_EQ(points.front(), points.back());
  for (const Vec3& point : points) {
    EXPECT_NEAR((point - Vec3(1, 2, 3)).norm(), 5, 1e-12);
    EXPECT_NEAR(point.x(), 1, 1e-12);
  }
}

TEST(PageSections, contacts_are_points_and_edges) {
  const PageSection section =
      contact_section({{Contact::Kind::edge, {0, 0, 0}, {2, 0, 0}, {"a", ""}},
                       {Contact::Kind::vertex, {1, 1, 1}, {1, 1, 1}, {"b"}}},
                      std::nullopt, "mm", 7);
  ASSERT_EQ(section.rows.size(), 2);
  EXPECT_EQ(section.rows[0].place->at, Vec3(1, 0, 0));
  EXPECT_EQ(section.rows[0].place->lines.size(), 1);
  EXPECT_EQ(section.rows[0].cells[1], "a, (no name)");
  EXPECT_EQ(section.rows[1].place->size, 7);
}

TEST(PageSections, contacts_that_were_settled_are_places_too) {
  const ContactSettlement settled{
      "separate", 0.25, {{Contact::Kind::vertex, {1, 1, 1}, {1, 1, 1}, {"a", "b"}}}};
  const PageSection section = contact_section({}, settled, "mm", 7);
  ASSERT_EQ(section.rows.size(), 1);
  EXPECT_EQ(section.rows[0].place->at, Vec3(1, 1, 1));
  EXPECT_EQ(section.rows[0].cells,
            (std::vector<std::string>{"a point at (1, 1, 1)", "a, b", "separated"}));
  EXPECT_THAT(section.note, testing::HasSubstr("nothing changed beyond 0.25 mm"));
}

TEST(PageSections, without_a_port_there_is_nothing_to_count) {
  const PageSection section = gap_section({"x.json", Unit::millimetre, 0.5, {}, {}});
  EXPECT_TRUE(section.rows.empty());
  EXPECT_EQ(section.note, "Ends up to 0.5 mm apart were taken to belong together.");
}

TEST(PageSections, rounding_shows_every_place) {
  RoundingReport rounding;
  rounding.moved = 3;
  rounding.largest_move = 0.25;
  rounding.filled_places = {{1, 0, 0}};
  rounding.snapped_places = {{2, 0, 0}, {3, 0, 0}};
  rounding.thin_shells = {{{4, 0, 0}, 0.1, 0.2}};
  const PageSection section = rounding_section(rounding, "mm", 1);
  ASSERT_EQ(section.rows.size(), 4);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(section.rows[std::size_t(i)].place->at, Vec3(i + 1, 0, 0));
  }
  EXPECT_EQ(section.note, "3 points moved, at most 0.25 mm.");
}

TEST(PageSections, what_was_refused_is_shown_where_the_file_has_it) {
  PipingLine line;
  line.components.push_back({.name = "elbow-1",
                             .kind = "ELBOW",
                             .line = 40,
                             .shape = PipingShape::bend,
                             .ports = {{{0, 0, 0}, 5, 41}, {{10, 10, 0}, 5, 42}},
                             .center = Vec3(10, 0, 0)});
  BuildReport report;
  report.piping.emplace();
  report.piping->network.notes = {{12, "a note", false}, {40, "too sharp", true}};
  report.piping->file.unknown = {{7, "what", false}};
  const PageSection section = note_section(report, &line, nullptr);
  ASSERT_EQ(section.rows.size(), 3);
  EXPECT_EQ(section.rows[0].cells, (std::vector<std::string>{"refused", "40", "too sharp"}));
  EXPECT_TRUE(section.rows[0].is_finding);
  EXPECT_EQ(section.rows[0].place->at, Vec3(5, 5, 0));
  EXPECT_EQ(section.rows[0].place->lines.at(0).size(), 4);
  EXPECT_FALSE(section.rows[1].place);
  EXPECT_FALSE(section.rows[2].is_finding);
}

TEST(PageSections, refused_nodes_and_edges_of_a_graph_have_places) {
  PipeGraph graph;
  graph.nodes = {{"1", {0, 0, 0}, 2, 3}, {"2", {4, 0, 0}, {}, 4}};
  graph.edges = {{0, 1, 9}};
  BuildReport report;
  report.graph.emplace();
  report.graph->notes = {{4, "no radius", true}, {9, "too short", true}};
  const PageSection section = note_section(report, nullptr, &graph);
  EXPECT_EQ(section.rows.at(0).place->at, Vec3(4, 0, 0));
  EXPECT_EQ(section.rows.at(1).place->at, Vec3(2, 0, 0));
}

TEST(PageSections, joints_that_are_apart_are_findings) {
  PipingLine line;
  line.components = {{.name = "a", .ports = {{{0, 0, 0}, 5, 1}, {{10, 0, 0}, 5, 2}}},
                     {.name = "b", .ports = {{{12, 0, 0}, 5, 3}, {{20, 0, 0}, 5, 4}}}};
  PcfReport piping;
  piping.network.joints = {{{"a", "b"}, {2, 3}, 2, 0, 0, JointState::apart, ""},
                           {{"a", "b"}, {2, 3}, 0, 0, 0, JointState::met, ""}};
  const PageSection section = joint_section(piping, &line);
  ASSERT_EQ(section.rows.size(), 1);
  EXPECT_TRUE(section.rows[0].is_finding);
  EXPECT_EQ(section.rows[0].place->at, Vec3(11, 0, 0));
  EXPECT_THAT(section.note, testing::HasSubstr("1 more"));
}

TEST(PageSections, faults_are_described) {
  MeshSummary summary{"x.off", "", test::box({0, 0, 0}, {1, 1, 1}), {}};
  summary.check = check(summary.mesh);
  EXPECT_TRUE(fault_section(summary, 1).rows.empty());
  EXPECT_THAT(fault_section(summary, 1).note, testing::HasSubstr("is a solid"));
  summary.mesh.points.emplace_back(5, 5, 5);
  summary.check = check(summary.mesh);
  const PageSection section = fault_section(summary, 1);
  ASSERT_EQ(section.rows.size(), 1);
  EXPECT_FALSE(section.rows[0].is_finding);
  EXPECT_EQ(section.rows[0].place->at, Vec3(5, 5, 5));
}

}  // namespace
}  // namespace dupin::pages
