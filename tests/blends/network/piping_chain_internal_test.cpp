#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blends/network/piping_network_internal.h"
#include "network/piping_chain.h"

namespace dupin::network {
namespace {

using testing::ElementsAre;

std::vector<SeamKind> seams(const Chain& chain) {
  std::vector<SeamKind> result;
  for (const Seam& seam : chain.seams) {
    result.push_back(seam.kind);
  }
  return result;
}

Chain only_chain(std::vector<PipingComponent> components, double snap = .05) {
  const PipingLine line = line_of(std::move(components));
  PipingSpans spans = spans_of(line);
  const auto chains = chains_of(spans, snap);
  EXPECT_EQ(chains.size(), 1);
  return chains.front();
}

PipingComponent pipe(const Vec3& from, const Vec3& to) {
  return component(PipingShape::straight, {from, to});
}

TEST(PipingChain, has_one_leg_on_one_axis) {
  const Chain chain = only_chain({pipe({0, 0, 0}, {500, .04, 0}), pipe({900, 0, 0}, {500, 0, 0}),
                                  pipe({900, 0, 0}, {2000, 0, 0})});
  ASSERT_EQ(chain.legs.size(), 1);
  EXPECT_EQ(chain.legs[0].direction, Vec3(1, 0, 0));
  EXPECT_THAT(chain.legs[0].nodes, ElementsAre(0, 500, 900, 2000));
  EXPECT_TRUE(chain.legs[0].elements[1].is_reversed);
  EXPECT_THAT(seams(chain), ElementsAre(SeamKind::end, SeamKind::end));
}

TEST(PipingChain, turns_at_corners_that_its_axes_share) {
  const Chain chain =
      only_chain({pipe({-900, 0, 0}, {-300, 0, 0}),
                  component(PipingShape::bend, {{-300, 0, 0}, {0, 300, 0}}, Vec3(0, 0, 0)),
                  pipe({0, 300, 0}, {0, 900, .04})});
  EXPECT_THAT(seams(chain), ElementsAre(SeamKind::end, SeamKind::corner, SeamKind::end));
  EXPECT_EQ(point_at(chain.legs[0], chain.legs[0].nodes.back()), chain.legs[1].origin);
}

TEST(PipingChain, breaks_where_directions_differ_or_a_point_is_off_the_axis) {
  EXPECT_THAT(seams(only_chain({pipe({0, 0, 0}, {500, 0, 0}), pipe({500, 0, 0}, {900, 50, 0})})),
              ElementsAre(SeamKind::end, SeamKind::kink, SeamKind::end));
  std::vector<PipingComponent> arch;  // every joint fits, but not all on one line
  for (int i = 0; i < 40; ++i) {
    arch.push_back(
        pipe({10.0 * i, .001 * i * i, 0}, {10.0 * (i + 1), .001 * (i + 1) * (i + 1), 0}));
  }
  const Chain chain = only_chain(arch);
  EXPECT_GT(chain.legs.size(), 1);
  for (const Leg& leg : chain.legs) {
    EXPECT_GT(leg.elements.size(), 3);
  }
}

TEST(PipingChain, bridges_what_lies_apart_but_along_one_axis) {
  const PipingLine line = line_of({pipe({0, 0, 0}, {500, 0, 0}), pipe({501, 1, 0}, {900, 1, 0})});
  const PipingLine along = line_of({pipe({0, 0, 0}, {500, 0, 0}), pipe({501, 0, 0}, {900, 0, 0})});
  LineNotes notes("a.pcf", false);
  PipingSpans spans = spans_of(line, {.bridge = 2}, notes);
  const auto chains = chains_of(spans, .05);
  ASSERT_EQ(chains.size(), 1);
  EXPECT_EQ(chains[0].seams[1].kind, SeamKind::bridge);
  PipingSpans one_axis = spans_of(along, {.bridge = 2}, notes);
  EXPECT_EQ(chains_of(one_axis, .05).at(0).legs.size(), 1);
}

TEST(PipingChain, replaces_bends_that_do_not_fit) {
  const Chain chain =
      only_chain({pipe({-900, 0, 60}, {-300, 0, 0}),
                  component(PipingShape::bend, {{-300, 0, 0}, {0, 300, 0}}, Vec3(0, 0, 0))});
  EXPECT_THAT(seams(chain), ElementsAre(SeamKind::end, SeamKind::bend, SeamKind::end));
  EXPECT_EQ(chain.legs[1].elements.size(), 1);  // a stub
}

TEST(PipingChain, closes) {
  const Chain chain =
      only_chain({component(PipingShape::bend, {{100, 0, 0}, {0, 100, 0}}, Vec3(0, 0, 0)),
                  component(PipingShape::bend, {{0, 100, 0}, {100, 200, 0}}, Vec3(0, 200, 0)),
                  component(PipingShape::bend, {{100, 200, 0}, {200, 100, 0}}, Vec3(200, 200, 0)),
                  component(PipingShape::bend, {{200, 100, 0}, {100, 0, 0}}, Vec3(200, 0, 0))});
  EXPECT_TRUE(chain.is_closed);
  EXPECT_EQ(chain.legs.size(), 5);
}

TEST(PipingChain, takes_every_span_once) {
  const PipingLine line = line_of(
      {component(PipingShape::fitting, {{-9, 0, 0}, {9, 0, 0}, {0, 0, 9}}, Vec3(0, 0, 0)),
       pipe({9, 0, 0}, {99, 0, 0}), pipe({0, 0, 99}, {0, 0, 9}), pipe({0, 900, 0}, {99, 900, 0})});
  PipingSpans spans = spans_of(line);
  std::vector<int> taken(spans.spans.size(), 0);
  for (const Chain& chain : chains_of(spans, .05)) {
    for (const Leg& leg : chain.legs) {
      for (const ChainElement& element : leg.elements) {
        ++taken[element.span];
      }
    }
  }
  EXPECT_THAT(taken, testing::Each(1));
}

}  // namespace
}  // namespace dupin::network
