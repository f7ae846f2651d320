#include <gtest/gtest.h>

#include "assembly/selected_parts.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::fillet;
using test::pipe;

Part after(const std::string& name, const std::string& port) {
  return {name, PipeAlong{PortReference{port, End::end}, 5}};
}

TEST(SelectedParts, keep_the_joints_among_them_only) {
  const Assembly assembly{"",
                          Unit::millimetre,
                          0.1,
                          {},
                          {pipe("a", {0, 0, 0}, {5, 0, 0}, 1), after("b", "a"), after("c", "b")}};
  const ResolvedAssembly whole = resolve(assembly);
  const SelectedParts last = selected_parts(whole, {false, true, true});
  ASSERT_EQ(last.resolved.parts.size(), 2);
  EXPECT_EQ(last.position[0], std::nullopt);
  EXPECT_EQ(last.position[2], 1);
  EXPECT_EQ(last.resolved.parts[0].joined[0], std::nullopt);
  EXPECT_EQ(last.resolved.parts[0].joined[1], (EndIndex{1, End::start}));
  EXPECT_EQ(last.resolved.parts[1].joined[0], (EndIndex{0, End::end}));
}

TEST(SelectedParts, keep_fillets_of_both_pipes_and_whole_junctions) {
  const Assembly assembly{"",
                          Unit::millimetre,
                          0.1,
                          {},
                          {pipe("x", {50, 50, 0}, {60, 50, 0}, 1),
                           pipe("run", {-20, 0, 0}, {20, 0, 0}, 4),
                           pipe("branch", {0, 0, 0}, {0, 0, 20}, 2),
                           fillet("f", "run", "branch", 1),
                           after("on", "x"),
                           {"hub", JunctionOfPorts{{{"x", End::start}, {"on", End::end}}}}}};
  Assembly bent = assembly;
  bent.parts[4] = pipe("on", {40, 90, 0}, {40, 80, 0}, 1);
  const ResolvedAssembly whole = resolve(bent);
  ASSERT_EQ(whole.junctions.size(), 1);
  const SelectedParts with = selected_parts(whole, {true, true, true, false, true, true});
  ASSERT_EQ(with.resolved.fillets.size(), 1);
  EXPECT_EQ(with.resolved.junctions.front().arms, whole.junctions.front().arms);
  const SelectedParts without = selected_parts(whole, {false, true, false, false, false, false});
  EXPECT_EQ(without.resolved.parts.size(), 1);
  EXPECT_TRUE(without.resolved.fillets.empty());
  EXPECT_TRUE(without.resolved.junctions.empty());
}

}  // namespace
}  // namespace dupin::assembly
