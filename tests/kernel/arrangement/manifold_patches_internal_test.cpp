#include <map>

#include <gtest/gtest.h>

#include "arrangement/manifold_patches.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

// Every operand a group of its own.
BooleanRule separate_groups(std::size_t operands) {
  BooleanRule rule{
      {}, static_cast<std::uint32_t>(operands), [](std::span<const int>) { return true; }};
  for (std::uint32_t o = 0; o < operands; ++o) {
    rule.group_of_operand.push_back(o);
  }
  return rule;
}

class PatchesOf : public testing::TestWithParam<test::Meeting> {
 protected:
  struct Facet {
    Triangle corners;
    std::uint32_t patch;
    std::vector<int> change;
  };

  PatchesOf() {
    for (std::uint32_t t = 0; t < stages.input.triangles.size(); ++t) {
      if (!constraints.touched[t] && !stages.input.merged[t]) {
        facets.push_back({stages.input.triangles[t], patches.of_triangle(t),
                          winding_change(stages.input, stages.rule, stages.input.cover(t))});
      }
    }
    for (const Subdivision::SubTriangle& t : subdivision.triangles) {
      facets.push_back({t.corners, patches.of_region(t.region),
                        winding_change(stages.input, stages.rule, subdivision.cover(t.region))});
    }
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const PointId a = facets[f].corners[k], b = facets[f].corners[(k + 1) % 3];
        at_edge[edge_key(a, b)].push_back({f, a < b});
      }
    }
  }

  struct Side {
    std::uint32_t facet;
    bool forward;
  };
  test::Stages stages{GetParam().solids, separate_groups(GetParam().solids.size())};
  Constraints constraints = stages.incidences();
  Subdivision outlined = stages.subdivision(constraints);
  ManifoldPatches patches{stages.input, stages.rule, outlined};
  Subdivision subdivision = stages.triangulated(outlined);
  std::vector<Facet> facets;
  std::map<EdgeKey, std::vector<Side>> at_edge;
};

TEST_P(PatchesOf, operands_change_the_counts_as_their_facets_do) {
  for (const Facet& facet : facets) {
    ASSERT_LT(facet.patch, patches.size());
    EXPECT_EQ(patches.change(facet.patch), facet.change);
  }
}

// By definition: connected by edges where nothing but two facets of one kind meet.
TEST_P(PatchesOf, operands_are_what_plain_edges_connect) {
  std::vector<std::uint32_t> lowest(facets.size());
  for (std::uint32_t f = 0; f < lowest.size(); ++f) {
    lowest[f] = f;
  }
  std::size_t seams = 0;
  for (bool changed = true; changed;) {
    changed = false;
    seams = 0;
    for (const auto& [edge, sides] : at_edge) {
      const bool is_plain = sides.size() == 2 && sides[0].forward != sides[1].forward &&
                            facets[sides[0].facet].change == facets[sides[1].facet].change;
      seams += is_plain ? 0 : 1;
      if (is_plain) {
        std::uint32_t &a = lowest[sides[0].facet], &b = lowest[sides[1].facet];
        changed = changed || a != b;
        a = b = std::min(a, b);
      }
    }
  }
  std::map<std::uint32_t, std::uint32_t> patch_of;  // a bijection
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    EXPECT_EQ(patch_of.emplace(lowest[f], facets[f].patch).first->second, facets[f].patch);
  }
  std::set<std::uint32_t> different;
  for (const auto& [facet, patch] : patch_of) {
    EXPECT_TRUE(different.insert(patch).second);
  }
  EXPECT_EQ(patches.seams().size(), seams);
}

// Surfaces are closed: going around a seam, all counts come back to what they were.
TEST_P(PatchesOf, operands_balance_around_every_seam) {
  for (const support::IndexRange& seam : patches.seams()) {
    std::vector<int> sum(stages.rule.groups);
    for (const ManifoldPatches::Side& side : patches.sides(seam)) {
      const std::vector<int>& change = patches.change(patches.of_member(side.half_plane.owner));
      for (std::size_t g = 0; g < sum.size(); ++g) {
        sum[g] += side.half_plane.forward ? change[g] : -change[g];
      }
    }
    EXPECT_TRUE(changes_nothing(sum));
  }
}

INSTANTIATE_TEST_SUITE_P(Meetings, PatchesOf, testing::ValuesIn(test::meetings()),
                         test::meeting_name);

}  // namespace
}  // namespace dupin::arrangement
