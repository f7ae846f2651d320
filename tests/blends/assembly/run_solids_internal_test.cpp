#include <gtest/gtest.h>

#include "assembly/run_solids.h"
#include "assembly/welded_runs.h"
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

}  // namespace
}  // namespace dupin::assembly
