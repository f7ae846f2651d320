#include <gtest/gtest.h>

#include "blends/network/piping_network_internal.h"
#include "network/piping_parts.h"

namespace dupin::network {
namespace {

PipingNetwork parts_of(const PipingLine& line, const PipingOptions& options = {}) {
  LineNotes notes("a.pcf", true);
  PipingSpans spans = spans_of(line, options, notes);
  PipingNetwork network;
  network.joints.resize(spans.pairs.size());
  add_parts(line, options, spans, chains_of(spans, options.snap), network, notes);
  return network;
}

TEST(PipingParts, begin_once_and_go_on_from_port_to_port) {
  const PipingNetwork network =
      parts_of(line_of({component(PipingShape::straight, {{-900, 0, 0}, {-300, 0, 0}}),
                        component(PipingShape::bend, {{-300, 0, 0}, {0, 300, 0}}, Vec3(0, 0, 0)),
                        component(PipingShape::straight, {{0, 300, 0}, {0, 900, 0}})}));
  ASSERT_EQ(network.assembly.parts.size(), 3);
  EXPECT_TRUE(std::holds_alternative<PipeBetween>(network.assembly.parts[0].shape));
  const auto& elbow = std::get<ElbowCorner>(network.assembly.parts[1].shape);
  EXPECT_EQ(std::get<PortReference>(elbow.from), (PortReference{"c0", End::end}));
  EXPECT_EQ(elbow.to, Vec3(0, 300, 0));
  EXPECT_EQ(std::get<PipeTo>(network.assembly.parts[2].shape).from,
            (PortReference{"c1", End::end}));
}

TEST(PipingParts, keep_the_walls_of_their_components) {
  PipingLine line = line_of({component(PipingShape::straight, {{0, 0, 0}, {300, 0, 0}}),
                             component(PipingShape::straight, {{300, 0, 0}, {600, 0, 0}})});
  line.components[1].wall = 3;
  const PipingNetwork network = parts_of(line);
  EXPECT_FALSE(network.assembly.parts[0].wall);
  EXPECT_EQ(network.assembly.parts[1].wall, 3);
}

TEST(PipingParts, are_plates_only_where_there_are_walls) {
  const PipingLine line = line_of({component(PipingShape::straight, {{0, 0, 0}, {300, 0, 0}}),
                                   component(PipingShape::closure, {{300, 0, 0}})});
  EXPECT_EQ(std::get<CapAt>(parts_of(line).assembly.parts[1].shape).at,
            (PortReference{"c0", End::end}));
  const PipingNetwork hollow = parts_of(line, {.wall = 4});
  EXPECT_EQ(std::get<PipeAlong>(hollow.assembly.parts[1].shape).length, 4);
  EXPECT_TRUE(hollow.assembly.parts[1].solid);
}

}  // namespace
}  // namespace dupin::network
