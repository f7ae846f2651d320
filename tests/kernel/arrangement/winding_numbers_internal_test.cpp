#include <gtest/gtest.h>

#include "arrangement/manifold_patches.h"
#include "arrangement/winding_numbers.h"
#include "kernel/arrangement/stages_internal.h"
#include "support/shapes.h"

namespace dupin::arrangement {
namespace {

using test::cube;

struct Selected {
  std::size_t patches = 0, kept = 0, reversed = 0;
  friend bool operator==(const Selected&, const Selected&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Selected& s) {
    return out << s.patches << " patches, " << s.kept << " kept, " << s.reversed << " reversed";
  }
};

Selected selected(const std::vector<TriMesh>& solids, const BooleanRule& rule) {
  test::Stages stages(solids, rule);
  const Subdivision subdivision = stages.subdivision(stages.incidences());
  const ManifoldPatches patches(stages.input, rule, subdivision);
  Selected result;
  const auto selection = propagate_winding_numbers(stages.input, rule, subdivision, patches).kept;
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    ++result.patches;
    result.kept += selection[p] == 1 ? 1 : 0;
    result.reversed += selection[p] == -1 ? 1 : 0;
  }
  return result;
}

TEST(Selection, keeps_the_patches_that_bound_the_result) {
  const struct {
    const char* description;
    std::vector<TriMesh> solids;
    Selected united, common, difference;
  } table[] = {
      {"apart", {cube(0, 0, 0), cube(5, 0, 0)}, {2, 2, 0}, {2, 0, 0}, {2, 1, 0}},
      {"nested, told by a ray", {cube(0, 0, 0, 6), cube(2, 2, 2)}, {2, 1, 0}, {2, 1, 0}, {2, 1, 1}},
      {"three nested",
       {cube(0, 0, 0, 6), cube(1, 1, 1, 4), cube(2, 2, 2)},
       {3, 1, 0},
       {3, 1, 0},
       {3, 1, 1}},
      {"corner in corner", {cube(0, 0, 0), cube(1, 1, 1)}, {4, 2, 0}, {4, 2, 0}, {4, 1, 1}},
      {"a bar through a slab",
       {test::box({0, 0, 0}, {6, 6, 1}), test::box({2, 2, -2}, {4, 4, 3})},
       {6, 3, 0},  // the slab's two holes come out of one side; the bar has two ends and a middle
       {6, 3, 0},
       {6, 1, 1}},
      {"equal", {cube(0, 0, 0), cube(0, 0, 0)}, {1, 1, 0}, {1, 1, 0}, {1, 0, 0}},
  };
  for (const auto& row : table) {
    SCOPED_TRACE(row.description);
    const std::size_t n = row.solids.size();
    EXPECT_EQ(selected(row.solids, union_rule(n)), row.united);
    EXPECT_EQ(selected(row.solids, intersection_rule(n)), row.common);
    EXPECT_EQ(selected(row.solids, difference_rule(n)), row.difference);
  }
}

TEST(Selection, asks_the_same_operand_for_many_shells) {
  // A row of cubes, twelve triangles each: more than a run of triangles, whose boxes are asked.
  std::vector<TriMesh> cubes;
  cubes.reserve(20);
  for (int i = 0; i < 20; ++i) {
    cubes.push_back(cube(10 * i, 0, 0, 6));
  }
  std::vector<TriMesh> solids{test::joined(cubes)};
  for (int i = 0; i < 20; i += 2) {
    solids.push_back(cube(10 * i + 2, 2, 2));  // inside of one
    solids.push_back(cube(10 * i + 7, 2, 2));  // between two
  }
  const std::size_t n = solids.size();
  EXPECT_EQ(selected(solids, union_rule(n)), (Selected{40, 30, 0}));
  EXPECT_EQ(selected(solids, difference_rule(n)), (Selected{40, 20, 10}));
}

TEST(Selection, follows_any_rule) {
  const std::vector<TriMesh> solids{cube(0, 0, 0), cube(1, 1, 1)};
  const BooleanRule exclusive{
      {0, 1}, 2, [](std::span<const int> counts) { return (counts[0] > 0) != (counts[1] > 0); }};
  EXPECT_EQ(selected(solids, exclusive), (Selected{4, 2, 2}));
  const BooleanRule all{{0, 0}, 1, [](std::span<const int>) { return false; }};
  EXPECT_EQ(selected(solids, all), (Selected{4, 0, 0}));
}

TEST(Patches, know_how_counts_change_through_them) {
  const BooleanRule rule = union_rule(3);
  test::Stages stages({cube(0, 0, 0), cube(0, 0, 0), cube(9, 9, 9)}, rule);
  const Subdivision subdivision = stages.subdivision(stages.incidences());
  const ManifoldPatches patches(stages.input, rule, subdivision);
  EXPECT_EQ(patches.change(patches.of_triangle(0)), std::vector<int>{2});
  EXPECT_EQ(patches.change(patches.of_triangle(24)), std::vector<int>{1});
  EXPECT_TRUE(patches.seams().empty());
}

}  // namespace
}  // namespace dupin::arrangement
