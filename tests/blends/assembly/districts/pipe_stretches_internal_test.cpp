#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/districts/pipe_stretches.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::fillet;
using test::pipe;

const Ring& ring(const ResolvedAssembly& resolved, std::uint32_t part, End end) {
  return *port_ring(resolved.parts[part].shape, end);
}

// Two pipes after the one that is cut and one before; what they share is shared bitwise.
void expect_welded(const ResolvedAssembly& resolved) {
  for (std::uint32_t i = 0; i < resolved.parts.size(); ++i) {
    for (const End end : {End::start, End::end}) {
      if (const auto& next = resolved.parts[i].joined.at(at(end))) {
        EXPECT_EQ(resolved.parts[next->part].joined.at(at(next->end)), (EndIndex{i, end}));
        EXPECT_EQ(ring(resolved, next->part, next->end), flipped(ring(resolved, i, end)));
      }
    }
  }
}

TEST(PipeStretches, share_rings_with_each_other_and_the_pipes_neighbours) {
  for (const auto& [direction, places] :
       {std::pair(1., std::vector{14., 17.}), std::pair(-1., std::vector{-12.5, -18., -19.})}) {
    Assembly assembly{
        "line.json", Unit::millimetre, 0.1, {}, {pipe("p0", {0, 3, 4}, {10 * direction, 3, 4}, 1)}};
    assembly.parts.push_back({"p1", PipeAlong{PortReference{"p0", End::end}, 10}});
    assembly.parts.push_back({"p2", PipeAlong{PortReference{"p1", End::end}, 10}});
    const ResolvedAssembly whole = resolve(assembly);
    const PipeStretches made = in_stretches(whole, {{1, places}, {2, {25 * direction}}});
    expect_welded(made.resolved);
    const std::vector<std::uint32_t>& own = made.of_pipe.at(1);
    ASSERT_EQ(own.size(), places.size() + 1);
    EXPECT_EQ(own.front(), 1);
    EXPECT_EQ(own[1], 3);
    EXPECT_EQ(made.resolved.parts.size(), 3 + places.size() + 1);
    EXPECT_EQ(ring(made.resolved, own.front(), End::start), ring(whole, 1, End::start));
    EXPECT_EQ(ring(made.resolved, own.back(), End::end), ring(whole, 1, End::end));
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Ring& cut = ring(made.resolved, own[i], End::end);
      EXPECT_EQ(cut.center, Vec3(places[i], 3, 4));
      EXPECT_EQ(cut.radius, 1);
      EXPECT_TRUE(is_cut(made.resolved.parts[own[i]], End::end));
      EXPECT_TRUE(is_cut(made.resolved.parts[own[i + 1]], End::start));
      EXPECT_EQ(made.resolved.parts[own[i]].end_names[1],
                made.resolved.parts[own[i + 1]].end_names[0]);
    }
    for (const std::uint32_t stretch : own) {
      EXPECT_EQ(made.resolved.parts[stretch].name, "p1");
      EXPECT_EQ(made.resolved.parts[stretch].index, 1);
    }
    EXPECT_FALSE(is_cut(made.resolved.parts[own.front()], End::start));
    EXPECT_FALSE(is_cut(made.resolved.parts[own.back()], End::end));
    EXPECT_EQ(made.resolved.parts[0].joined[1], (EndIndex{1, End::start}));
    EXPECT_EQ(made.resolved.parts[own.back()].joined[1], (EndIndex{2, End::start}));
    EXPECT_EQ(made.resolved.parts[2].joined[0], (EndIndex{own.back(), End::end}));
  }
}

TEST(PipeStretches, have_the_fillets_that_are_on_them) {
  const Assembly assembly{"tees.json",
                          Unit::millimetre,
                          0.1,
                          {},
                          {pipe("run", {20, 0, 0}, {0, 0, 0}, 1),
                           pipe("a", {4, 0, 0}, {4, 0, 9}, .5), fillet("fa", "run", "a", .1),
                           pipe("b", {16, 0, 9}, {16, 0, 0}, .5), fillet("fb", "b", "run", .1)}};
  const ResolvedAssembly whole = resolve(assembly);
  const PipeStretches made = in_stretches(whole, {{0, {14, 10}}, {1, {5}}, {2, {6, 4}}});
  const auto &run = made.of_pipe.at(0), &a = made.of_pipe.at(1), &b = made.of_pipe.at(2);
  EXPECT_EQ(made.resolved.fillets[0].between, (std::array{run[2], a[0]}));
  EXPECT_EQ(made.resolved.fillets[1].between, (std::array{b[2], run[0]}));
  const BuriedEnds buried(made.resolved);
  EXPECT_TRUE(buried.contains({a[0], End::start}));
  EXPECT_TRUE(buried.contains({b[2], End::end}));
  EXPECT_FALSE(buried.contains({b[0], End::end}));
  EXPECT_EQ(in_stretches(whole, {}).resolved.fillets[1].between, whole.fillets[1].between);
}

TEST(PipeStretches, are_of_straight_circular_pipes_only) {
  Assembly assembly{"line.json", Unit::millimetre, 0.1, {}, {pipe("p0", {0, 0, 0}, {1, 10, 2}, 1)}};
  assembly.parts.push_back(
      {"e", ElbowTurning{PortReference{"p0", End::end}, 4, 1.5, Vec3(0, 0, 1)}});
  assembly.parts.push_back({"c", ConeAlong{PortReference{"e", End::end}, 10, .5}});
  const ResolvedAssembly resolved = resolve(assembly);
  const auto own = cuttable(resolved.parts[0]);
  ASSERT_TRUE(own);
  EXPECT_EQ(own->axis, 1);
  EXPECT_EQ(own->from, 0);
  EXPECT_EQ(own->to, 10);
  EXPECT_EQ(own->clear, 1);
  EXPECT_FALSE(cuttable(resolved.parts[1]));
  EXPECT_FALSE(cuttable(resolved.parts[2]));
  for (bool ResolvedPart::*flag : {&ResolvedPart::is_tangent, &ResolvedPart::ends_in_hub}) {
    ResolvedPart part = resolved.parts[0];
    part.*flag = true;
    EXPECT_FALSE(cuttable(part));
  }
}

TEST(PipeStretches, are_cut_from_start_to_end) {
  const ResolvedAssembly resolved =
      resolve({"line.json",
               Unit::millimetre,
               0.1,
               {},
               {pipe("up", {0, 0, 0}, {9, 0, 0}, 1), pipe("no", {0, 9, 0}, {9, 9, 0}, 1),
                pipe("down", {9, 5, 0}, {0, 5, 0}, 1)}});
  EXPECT_EQ(pipe_cuts(resolved, std::vector<std::uint32_t>{0, 1, 2}, {{2, 4}, {}, {3, 6}}),
            (PipeCuts{{0, {2, 4}}, {2, {6, 3}}}));
}

}  // namespace
}  // namespace dupin::assembly
