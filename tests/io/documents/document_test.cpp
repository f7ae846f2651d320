#include "dupin/io/document.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

// Two pipes whose ends are 0.5 mm apart, and an elbow that is none.
const std::string kLine =
    "UNITS-BORE MM\nUNITS-CO-ORDS MM\n"
    "PIPE\n    END-POINT 0 0 0 50\n    END-POINT 100 0 0 50\n"
    "PIPE\n    END-POINT 100.5 0 0 50\n    END-POINT 200 0 0 50\n";
const std::string kElbow =
    "ELBOW\n    END-POINT 200 0 0 50\n    END-POINT 220 20 0 50\n    CENTRE-POINT 220 0 0\n";

const std::string kGraph = "n 0 0 0 1\nn 9 0 0 1\nn 9 9 0\nc 0 1\nc 1 2\n";

const std::string kAssembly = R"({"units": "cm", "tolerance": 0.5, "parts": [
  {"name": "a", "colour": "#102030", "pipe": {"from": [0, 0, 0], "to": [9, 0, 0], "radius": 2}}]})";

TEST(Document, kind_is_told_by_the_extension) {
  EXPECT_EQ(document_kind("a/line.PCF"), DocumentKind::piping);
  EXPECT_EQ(document_kind("tree.swc"), DocumentKind::graph);
  EXPECT_EQ(document_kind("tree.graph"), DocumentKind::graph);
  EXPECT_EQ(document_kind("line.json"), DocumentKind::assembly);
  EXPECT_EQ(document_kind(""), DocumentKind::assembly);
}

TEST(Document, of_an_assembly_has_its_colours_and_no_source) {
  const Document document = document_of(kAssembly, "a.json", DocumentKind::assembly);
  EXPECT_EQ(document.assembly.source, "a.json");
  EXPECT_EQ(document.colours.at("a"), "#102030");
  EXPECT_FALSE(document.network);
  EXPECT_FALSE(document.piping);
}

TEST(Document, of_a_graph_takes_its_unit_and_radius) {
  SourceOptions options;
  EXPECT_THROW((void)document_of(kGraph, "a.graph", DocumentKind::graph, options), Error);
  options.radius = 1;
  options.unit = Unit::inch;
  Document document = document_of(kGraph, "a.graph", DocumentKind::graph, options);
  EXPECT_EQ(document.assembly.unit, Unit::inch);
  ASSERT_TRUE(document.network);
  EXPECT_EQ(document.network->edges, 2);

  const std::size_t parts = document.assembly.parts.size();
  const Built built = build(document, {});
  EXPECT_EQ(built.parts.size(), parts);
  EXPECT_EQ(document.assembly.parts.size(), parts);
  EXPECT_TRUE(document.network);
}

TEST(Document, of_a_graph_keeps_going_without_what_is_refused) {
  SourceOptions options;
  options.keep_going = true;
  const Document document = document_of(kGraph, "a.graph", DocumentKind::graph, options);
  EXPECT_EQ(document.network->edges, 1);
  EXPECT_FALSE(document.network->notes.empty());
}

TEST(Document, of_a_piping_file_is_snapped_bridged_and_given_walls) {
  SourceOptions options;
  EXPECT_EQ(document_of(kLine, "a.pcf", DocumentKind::piping).piping->findings(), 1);
  options.snap = 1;
  options.schedule = "40";
  const Document snapped = document_of(kLine, "a.pcf", DocumentKind::piping, options);
  EXPECT_EQ(snapped.piping->findings(), 0);
  EXPECT_EQ(snapped.piping->snap, 1);
  EXPECT_GT(snapped.line.components.front().wall.value_or(0), 0);
  options.snap = {};
  options.bridge = 2;
  const Document bridged = document_of(kLine, "a.pcf", DocumentKind::piping, options);
  EXPECT_EQ(bridged.piping->findings(), 0);
  EXPECT_GT(bridged.assembly.parts.size(), snapped.assembly.parts.size());
}

TEST(Document, of_a_piping_file_is_built_without_what_is_refused_where_told_to) {
  EXPECT_THROW((void)document_of(kLine + kElbow, "a.pcf", DocumentKind::piping), Error);
  SourceOptions options;
  options.keep_going = true;
  options.snap = 1;
  Document document = document_of(kLine + kElbow, "a.pcf", DocumentKind::piping, options);
  const Built built = build(document, {});
  BuildReport report;
  const std::size_t parts = built.parts.size();
  take(report, Built(built), document, 0.25);
  EXPECT_EQ(report.parts.size(), parts);
  EXPECT_EQ(report.gaps.connect, 0.25);
  EXPECT_EQ(report.gaps.file, "a.pcf");
  ASSERT_TRUE(report.piping);
  EXPECT_EQ(report.source_findings(), 2) << "what is left out, and the joint to it";
}

TEST(Document, bill_names_components_where_there_are_any) {
  const BillReport piping = bill_report(document_of(kLine, "a.pcf", DocumentKind::piping));
  ASSERT_EQ(piping.origins.size(), piping.bill.rows.size());
  EXPECT_EQ(piping.origins.front().kind, "PIPE");
  EXPECT_TRUE(piping.source.piping);
  const BillReport plain = bill_report(document_of(kAssembly, "a.json", DocumentKind::assembly));
  EXPECT_TRUE(plain.origins.empty());
  EXPECT_EQ(plain.bill.rows.size(), 1);
}

TEST(Document, gaps_of_a_piping_file_are_those_of_its_ends) {
  const auto gaps = [](const GapSummary& summary) { return summary.findings(); };
  EXPECT_EQ(gaps(piping_gap_summary(kLine, "a.pcf")), 1);
  EXPECT_EQ(gaps(piping_gap_summary(kLine, "a.pcf", BoreMeaning::automatic, 0.25)), 0);
  EXPECT_EQ(piping_gap_summary(kLine, "a.pcf").connect, 1);
}

TEST(Document, gaps_of_an_assembly_are_up_to_its_tolerance) {
  const Document document = document_of(kAssembly, "a.json", DocumentKind::assembly);
  EXPECT_EQ(gap_summary(document.assembly).connect, 0.5);
  EXPECT_EQ(gap_summary(document.assembly, 2).connect, 2);
  EXPECT_EQ(gap_summary(document.assembly).unit, Unit::centimetre);
}

}  // namespace
}  // namespace dupin::test
