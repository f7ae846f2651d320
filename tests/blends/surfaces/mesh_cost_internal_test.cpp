#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "blends/tubes.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/tessellate.h"
#include "support/cyclide_cases.h"
#include "surfaces/mesh_cost.h"

namespace dupin::surfaces {
namespace {

Chain chain_of(const RingedSurface& piece) { return {piece}; }

RingedSurface swerving() {
  const Vec3 from = Vec3::Zero(), to(10, 4, 0), along = Vec3::UnitX();
  const CubicRadius law{1, 1.5};
  return {{from, -along, 1}, {to, along, 1.5}, HermiteSpine{from, to, 12 * along, 12 * along}, law};
}

TEST(MeshCost, estimates_the_triangles_of_a_mesh_that_is_not_made) {
  const std::pair<std::string, PartSurface> table[]{
      {"pipe", chain_of(test::cylinder(Vec3::Zero(), Vec3(3, 2, 10), 1))},
      {"cone", chain_of(test::cone(Vec3::Zero(), Vec3(3, 2, 10), 1, 4))},
      {"elbow", chain_of(test::elbow(3, 1.5, 1))},
      {"wide elbow", chain_of(test::elbow(3e4, 1.5, 1))},
      {"blend", chain_of(swerving())},
      {"sphere", Sphere{Vec3::Zero(), 2}}};
  for (const auto& [name, surface] : table) {
    for (const double tolerance : {0.05, 0.002, 0.0001}) {
      const auto made = [&](const auto& shape) {
        const RingSampling sampling{segments_for(shape, tolerance), 0, 0};
        return std::pair(mesh_cost(shape, sampling, tolerance).triangles, [&] {
          if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Sphere>) {
            return tessellate(shape, sampling);
          } else {
            return tessellate(shape, sampling, {tolerance});
          }
        }());
      };
      const auto [expected, mesh] = std::visit(made, surface);
      const double found = double(mesh.mesh.triangles.size());
      // A band more or less where there are few, and the twist of the last.
      EXPECT_NEAR(expected, found, 0.1 * found + 2 * found / mesh.bands) << name << tolerance;
    }
  }
}

TEST(MeshCost, counts_both_skins_of_a_hollow_chain_and_its_kneecaps) {
  for (const double wall : {0., 0.1}) {
    Chain chain = kneecap_chain(test::lune_spheres());
    chain.wall = wall;
    const RingSampling sampling{segments_for(chain, 0.0005), 0, 0};
    const double found = double(tessellate(chain, sampling, {0.0005}).mesh.triangles.size());
    // Discs and sectors between the pieces are left out.
    EXPECT_NEAR(mesh_cost(chain, sampling, 0.0005).triangles, found, 0.1 * found) << wall;
  }
}

TEST(MeshCost, costs_no_more_for_a_mesh_that_nobody_could_hold) {
  const Chain elbow = chain_of(test::elbow(1e9, 1.5, 1));
  EXPECT_GT(mesh_cost(elbow, {1'000'000, 0, 0}, 1e-4).triangles, 1e12);
}

TEST(MeshCost, counts_pairs_of_triangles_that_lie_side_by_side) {
  const Chain pipe = chain_of(test::cylinder(Vec3::Zero(), Vec3(3, 2, 10), 1));
  EXPECT_EQ(mesh_cost(pipe, {1000, 0, 0}, 0.01).pairs, 500'000);
  const Chain elbow = chain_of(test::elbow(3, 1.5, 1));
  EXPECT_LT(mesh_cost(elbow, {1000, 0, 0}, 0.0001).pairs, 10'000);
}

}  // namespace
}  // namespace dupin::surfaces
