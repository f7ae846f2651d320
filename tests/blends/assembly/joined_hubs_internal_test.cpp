#include <gtest/gtest.h>

#include "assembly/joined_hubs.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/solid.h"

namespace dupin::assembly {
namespace {

Ring towards_origin(const Vec3& direction) {
  return {6 * direction.normalized(), -direction.normalized(), 1};
}

TEST(JoinedHubs, close_what_ends_at_their_circles) {
  const std::vector<Ring> ends{towards_origin({1, 0, 0}), towards_origin({0, 1, 0}),
                               towards_origin({-1, -1, 1})};
  const ResolvedJunction junction{"hub", 0, {0, 1, 2}, junction_of(ends)};
  const Assembly document{"d.json", Unit::millimetre, 0.05, {}, {{"hub", JunctionOfPorts()}}};
  const std::vector<RingSampling> samplings{{40}, {48, 0.3}, {56, 0.7}};
  Tessellation hub = hub_tessellation(document, junction, samplings, 100'000);
  EXPECT_LE(hub.error_bound, 0.05);
  hub.mesh.names = {"hub"};
  // Arms side by side, without common points, with discs at the ends.
  TriMesh arms;
  arms.names = {"arms"};
  const auto append = [&](const TriMesh& mesh) {
    const auto offset = std::uint32_t(arms.points.size());
    arms.points.insert(arms.points.end(), mesh.points.begin(), mesh.points.end());
    for (const auto& [a, b, c] : mesh.triangles) {
      arms.triangles.push_back({offset + a, offset + b, offset + c});
    }
  };
  for (std::size_t i = 0; i < 3; ++i) {
    TriMesh arm = tessellate(tube(junction.shape.arms[i]), samplings[i]).mesh;
    for (const auto& [a, b, c] : end_cap_mesh(ends[i], samplings[i]).triangles) {
      arm.triangles.push_back({a, c, b});  // the first row is that polygon
    }
    append(arm);
  }
  arms.labels.assign(arms.triangles.size(), 0);
  const std::size_t points = arms.points.size() + hub.mesh.points.size() - (40 + 48 + 56);
  const std::size_t triangles = arms.triangles.size() + hub.mesh.triangles.size();
  const std::vector<HubPatch> hubs{{hub.mesh, 40 + 48 + 56}};
  const TriMesh joined = joined_with_hubs(arms, hubs);
  EXPECT_EQ(joined.points.size(), points);
  EXPECT_EQ(joined.triangles.size(), triangles);
  EXPECT_EQ(joined.names, (std::vector<std::string>{"arms", "hub"}));
  EXPECT_EQ(joined.labels.back(), 1U);
  EXPECT_NO_THROW((void)Solid::from(joined));
}

}  // namespace
}  // namespace dupin::assembly
