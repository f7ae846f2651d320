#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "assembly/run_solids.h"
#include "assembly/welded_runs.h"
#include "dupin/blends/build.h"
#include "dupin/kernel/boolean.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::fillet;
using test::pipe;

TEST(RunSolids, are_one_for_each_run_and_one_for_what_a_fillet_joins) {
  const Assembly assembly{
      "",
      Unit::millimetre,
      0.1,
      {},
      {pipe("run", {-20, 0, 0}, {20, 0, 0}, 4), pipe("branch", {0, 0, 0}, {0, 0, 20}, 2),
       fillet("f", "run", "branch", 1), pipe("far", {50, 0, 0}, {60, 0, 0}, 1)}};
  const ResolvedAssembly resolved = resolve(assembly);
  const RunSolids made =
      solids_of_runs(assembly, resolved, lattice_spacing(assembly, resolved), {});
  EXPECT_EQ(made.runs, 3);
  ASSERT_EQ(made.solids.size(), 2);
  EXPECT_GT(made.solids[0].volume(), made.solids[1].volume());
  ASSERT_EQ(made.parts.size(), 3);
  for (const PartReport& part : made.parts) {
    EXPECT_GT(part.triangles, 0);
    EXPECT_LE(part.error_bound, 0.1);
  }
  ASSERT_EQ(made.others.size(), 1);
  EXPECT_EQ(made.others[0].first, 2);
  EXPECT_EQ(made.others[0].second.name, "f");
}

// The branch leads back through the run, where no fillet joins them.
TEST(RunSolids, of_filleted_runs_that_cross_elsewhere_are_what_the_fillet_joins_and_the_rest) {
  const Assembly assembly{"",
                          Unit::millimetre,
                          0.005,
                          {},
                          {pipe("run", {-20, 0, 0}, {20, 0, 0}, 4),
                           {"rest", PipeAlong{PortReference{"run", End::end}, 40}},
                           pipe("branch", {0, 0, 0}, {0, 0, 20}, 2),
                           {"turn", ElbowTurning{PortReference{"branch", End::end}, 20,
                                                 std::numbers::pi, Vec3::UnitX()}},
                           {"back", PipeAlong{PortReference{"turn", End::end}, 40}},
                           fillet("f", "run", "branch", 1)}};
  const ResolvedAssembly resolved = resolve(assembly);
  const RunSolids made =
      solids_of_runs(assembly, resolved, lattice_spacing(assembly, resolved), {});
  ASSERT_EQ(made.solids.size(), 3);
  const Solid whole = unite(made.solids);
  EXPECT_EQ(whole.components(), 1);
  EXPECT_EQ(whole.euler_number(), 0);  // a loop
  // The same without the fillet is less by what the fillet adds alone.
  Assembly plain = assembly;
  plain.parts.pop_back();
  Assembly tee = assembly;
  tee.parts = {assembly.parts[0], assembly.parts[2], assembly.parts[5]};
  Assembly plain_tee = tee;
  plain_tee.parts.pop_back();
  const auto volume = [](const Assembly& of) { return build(of).solid.volume(); };
  EXPECT_NEAR(whole.volume() - volume(plain), volume(tee) - volume(plain_tee), 0.5);
  EXPECT_GT(volume(tee) - volume(plain_tee), 2);
}

TEST(RunSolids, of_a_run_that_crosses_itself_are_its_pieces) {
  const Assembly assembly{"",
                          Unit::millimetre,
                          0.05,
                          {},
                          {pipe("a", {0, 0, 0}, {10, 0, 0}, 1),
                           {"b", ElbowTurning{PortReference{"a", End::end}, 2, 4.7, Vec3::UnitY()}},
                           {"c", PipeAlong{PortReference{"b", End::end}, 10}}}};
  const ResolvedAssembly resolved = resolve(assembly);
  const RunSolids made =
      solids_of_runs(assembly, resolved, lattice_spacing(assembly, resolved), {});
  EXPECT_EQ(made.runs, 1);
  EXPECT_GT(made.solids.size(), 1);
}

// Two pipes side by side on a hub that is a hundred times as thick as one of them: its collar
// flares within less than the tolerance.
TEST(RunSolids, of_hubs_much_larger_than_their_pipes_are_meshed_finer) {
  const auto along = [](double angle) { return Vec3(std::cos(angle), std::sin(angle), 0); };
  for (const double degrees : {7., 9., 12.}) {
    const double angle = degrees * std::numbers::pi / 180, far = 88 / angle + 30;
    const Assembly assembly{
        "",
        Unit::millimetre,
        0.2,
        {},
        {pipe("thin", far * along(0), (far + 5) * along(0), 1),
         pipe("thick", far * along(angle), (far + 5) * along(angle), 10),
         {"hub", JunctionOfPorts{{{"thin", End::start}, {"thick", End::start}}, {}}}}};
    const ResolvedAssembly resolved = resolve(assembly);
    const RunSolids made =
        solids_of_runs(assembly, resolved, lattice_spacing(assembly, resolved), {});
    ASSERT_EQ(made.solids.size(), 1);
    EXPECT_EQ(made.solids[0].euler_number(), 2);
    ASSERT_EQ(made.others.size(), 1);
    EXPECT_LE(made.others[0].second.error_bound, 0.2);
  }
}

}  // namespace
}  // namespace dupin::assembly
