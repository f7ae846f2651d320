#include <gtest/gtest.h>

#include "blends/junction/junction_meshes_internal.h"
#include "certification/prove_hub.h"
#include "verification/claims/hub_claims.h"

namespace dupin::certification {
namespace {

Junction six() {
  std::vector<Ring> ends;
  for (int i = 0; i < 3; ++i) {
    ends.push_back({4 * Vec3::Unit(i), -Vec3::Unit(i), 1});
    ends.push_back({-4 * Vec3::Unit(i), Vec3::Unit(i), 1});
  }
  return junction_of(ends);
}

TEST(ProveHub, needs_boxes) {
  const Junction junction = six();
  const verification::Solid arm({"", "", tube(junction.arms[0]), {}});
  EXPECT_EQ(prove_at_hub(arm, junction.hub, 1).verdict, Verdict::undecided);
  const ClearanceClaim claim = prove_at_hub(arm, junction.hub, 1 << 12);
  ASSERT_EQ(claim.verdict, Verdict::proved);
  EXPECT_EQ(claim.leaves.front().first.from, 0);
  EXPECT_EQ(claim.leaves.back().first.to, arm.length());
}

TEST(ProveHub, claims_of_meshes_have_as_many_segments_as_their_triangles_ask_for) {
  const Junction junction = six();
  const auto coarse = test::mesh_of(junction, 0.05, 0), fine = test::mesh_of(junction, 0.01, 0);
  const MeshClaim of_coarse = hub_mesh_claim(junction.hub, coarse.hub.mesh, 1000, 0),
                  of_fine = hub_mesh_claim(junction.hub, fine.hub.mesh, 1000, 0);
  EXPECT_GT(of_coarse.segments, 8);
  EXPECT_GT(of_fine.segments, of_coarse.segments);
  EXPECT_EQ(hub_mesh_claim(junction.hub, fine.hub.mesh, 5, 0).segments, 5);
  MeshClaim claim = of_fine;
  claim.error_bound = 2 * fine.hub.error_bound;
  EXPECT_TRUE(verification::follows_of_hub(junction.hub, claim));
}

}  // namespace
}  // namespace dupin::certification
