#include "dupin/io/graph_file.h"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

TEST(GraphFile, is_told_by_its_extension) {
  EXPECT_TRUE(is_graph_file("a/tree.swc"));
  EXPECT_TRUE(is_graph_file("TREE.SWC"));
  EXPECT_TRUE(is_graph_file("octopus.graph"));
  EXPECT_FALSE(is_graph_file("graph.json"));
  EXPECT_FALSE(is_graph_file("graph"));
}

TEST(GraphFile, is_told_by_its_first_line_where_it_has_no_name) {
  EXPECT_TRUE(is_graph_text("# a tree\n\n 1 3 0 0 0 1.5 -1\n"));
  EXPECT_TRUE(is_graph_text("n 0 0 0\n"));
  EXPECT_TRUE(is_graph_text("\xEF\xBB\xBFn 0 0 0\n"));
  EXPECT_TRUE(is_graph_text("n 0 0 0 2 # with a radius\n"));
  EXPECT_TRUE(is_graph_text("c 0 1\nn 0 0 0\n"));
  for (const std::string text :
       {"", "# nothing", "{\"units\": \"mm\"}", "OFF\n8 6 12\n", "8 6 12\n", "n 0 0\n",
        "nothing 1 2 3\n", "solid a\n", "v 0 0 0\n", "1 2 3 4 5 6 seven\n"}) {
    EXPECT_FALSE(is_graph_text(text)) << text;
  }
  EXPECT_EQ(parse_graph_file("1 3 0 0 0 1.5 -1\n2 3 9 0 0 1 1\n", "standard input").edges.size(),
            1);
  EXPECT_EQ(parse_graph_file("n 0 0 0\nn 1 0 0\nc 0 1\n", "standard input").edges.size(), 1);
}

TEST(GraphFile, swc_gives_nodes_with_lines_and_edges_to_parents) {
  const PipeGraph graph = parse_swc(
      "# a neuron\n10 1 0 0 0 2.5 -1\r\n\n  7 3 1 2 3 0.5 11 # child first\n"
      "11 3 1 0 0 .5 10\n",
      "a.swc");
  ASSERT_EQ(graph.nodes.size(), 3);
  EXPECT_EQ(graph.nodes[0].name, "10");
  EXPECT_EQ(graph.nodes[0].radius, 2.5);
  EXPECT_EQ(graph.nodes[1].center, Vec3(1, 2, 3));
  EXPECT_EQ(graph.nodes[1].line, 4);
  ASSERT_EQ(graph.edges.size(), 2);
  EXPECT_EQ(graph.edges[0].from, 2);
  EXPECT_EQ(graph.edges[0].to, 1);
  EXPECT_EQ(graph.edges[1].line, 5);
}

TEST(GraphFile, plain_graphs_have_radii_or_not) {
  const PipeGraph graph =
      parse_graph("c 0 1\nn 0 0 0 \nn 1 0 0 0.25\nn nan -nan 0\n# end", "a.graph");
  ASSERT_EQ(graph.nodes.size(), 3);
  EXPECT_FALSE(graph.nodes[0].radius);
  EXPECT_EQ(graph.nodes[1].radius, 0.25);
  EXPECT_TRUE(std::isnan(graph.nodes[2].center.x()));
  ASSERT_EQ(graph.edges.size(), 1);
  EXPECT_EQ(graph.edges[0].to, 1);
  EXPECT_EQ(graph.edges[0].line, 1);
}

TEST(GraphFile, leaves_numbers_that_are_not_finite_to_those_who_clean_graphs) {
  for (const char* number : {"nan", "-nan", "+nan", "NaN", "inf", "-inf", "1e400", "-1e400"}) {
    const std::string word(number);
    EXPECT_FALSE(std::isfinite(*parse_swc("1 1 0 0 0 " + word + " -1\n", "a").nodes[0].radius))
        << word;
    EXPECT_FALSE(std::isfinite(*parse_graph("n 0 0 0 " + word + "\n", "a").nodes[0].radius))
        << word;
    EXPECT_FALSE(parse_swc("1 1 0 " + word + " 0 1 -1\n", "a").nodes[0].center.allFinite()) << word;
  }
}

TEST(GraphFile, malformed_lines_are_refused_where_they_are) {
  struct Row {
    std::string text, place, message;
    bool is_swc;
  };
  const Row rows[] = {
      {"1 1 0 0 0 1\n", "a:1", "parent", true},
      {"# c\n1 1 0 0 x 1 -1\n", "a:2", "a coordinate", true},
      {"1 1 0 0 0 1 -1 5\n", "a:1", "the end of the line", true},
      {"1 1 0 0 0 1 -2\n", "a:1", "the parent's id", true},
      {"1 1 0 0 0 infinite -1\n", "a:1", "radius", true},
      {"1 1 0 0 0 nano -1\n", "a:1", "radius", true},
      {"1.5 1 0 0 0 1 -1\n", "a:1", "id", true},
      {"1 1 0 0 0 1 -1\n1 1 1 0 0 1 -1\n", "a:2", "node 1: the id occurs before", true},
      {"1 1 0 0 0 1 -1\n2 1 1 0 0 1 9\n", "a:2", "node 2: there is no parent 9", true},
      {"n 0 0\n", "a:1", "a coordinate", false},
      {"n 0 0 0 1 2\n", "a:1", "the end of the line", false},
      {"n 0 0 0\nc 0\n", "a:2", "the number of a node", false},
      {"n 0 0 0\nc 0 -1\n", "a:2", "the number of a node", false},
      {"n 0 0 0\nc 0 1\n", "a:2", "edge 0-1: there is no node 1, only 1 from 0 on", false},
      {"c 0 99999999999999999999\n", "a:1", "the number of a node", false},
      {std::string("\0\xff\x01", 3), "a:1", "for a node", false}};
  for (const Row& row : rows) {
    try {
      (void)(row.is_swc ? parse_swc(row.text, "a") : parse_graph(row.text, "a"));
      ADD_FAILURE() << row.text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::parse_failed) << row.text;
      EXPECT_EQ(error.where().substr(0, row.place.size()), row.place) << row.text;
      EXPECT_THAT(error.message(), HasSubstr(row.message)) << row.text;
    }
  }
}

TEST(GraphFile, what_refers_to_nothing_is_left_out_if_asked_for) {
  std::vector<SourceNote> notes;
  const PipeGraph swc = parse_swc("1 1 0 0 0 1 -1\n1 1 1 0 0 1 -1\n2 1 2 0 0 1 9\n", "a", &notes);
  EXPECT_EQ(swc.nodes.size(), 2);
  EXPECT_TRUE(swc.edges.empty());
  ASSERT_EQ(notes.size(), 2);
  EXPECT_EQ(notes[0].line, 2);
  EXPECT_TRUE(notes[0].is_refusal);
  EXPECT_EQ(notes[1].text, "node 2: there is no parent 9; left out");
  EXPECT_EQ(parse_graph_file("n 0 0 0\nc 0 4\n", "a.graph", &notes).edges.size(), 0);
  EXPECT_EQ(notes.size(), 3);
}

}  // namespace
}  // namespace dupin::test
