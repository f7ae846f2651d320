#include <random>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "gaps/union_components.h"
#include "support/shapes.h"

namespace dupin::gaps {
namespace {

UnionTopology topology(const TriMesh& a, const TriMesh& b, bool closed = true) {
  const MeshPair pair = merged(a, b);
  return union_topology(pair, FaceBoxIndex(pair), closed);
}

TriMesh cube(double low, double high) {
  return test::box(Vec3::Constant(low), Vec3::Constant(high));
}

TEST(UnionComponents, are_those_of_nested_shells) {
  const TriMesh hollow = test::joined({cube(0, 9), test::reversed(cube(1, 8))});
  EXPECT_EQ(topology(cube(0, 9), cube(2, 3)).components, 1) << "inside the material";
  EXPECT_EQ(topology(hollow, cube(2, 3)).components, 2) << "inside the void";
  EXPECT_EQ(topology(hollow, cube(0.25, 0.75)).components, 1);
  EXPECT_EQ(topology(hollow, cube(20, 30)).components, 2);
  EXPECT_EQ(topology(hollow, cube(-5, 20)).components, 1) << "swallowed";
  EXPECT_EQ(topology(cube(0, 9), cube(2, 3), false).components, 2) << "surfaces have no inside";
  const UnionTopology corner = topology(cube(0, 1), cube(1, 2));
  EXPECT_TRUE(corner.touching);
  EXPECT_EQ(corner.components, 1);
}

TEST(UnionComponents, are_those_of_the_union) {
  std::mt19937 random(3);
  const auto boxes = [&](std::size_t count) {
    std::vector<Solid> all;
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 low, size;
      for (int k = 0; k < 3; ++k) {
        low[k] = static_cast<double>(random() % 12);
        size[k] = static_cast<double>(1 + random() % 4) - 0.5;
      }
      all.push_back(Solid::from(test::box(low, low + size)));
    }
    return unite(all);
  };
  std::size_t several = 0;
  for (int round = 0; round < 40; ++round) {
    const Solid a = boxes(4), b = boxes(4);
    if (!a.contacts().empty() || !b.contacts().empty()) {
      continue;
    }
    const auto mesh = [](const Solid& solid) {
      return TriMesh{solid.nearest_points(), solid.triangles(), {}, {}};
    };
    const Solid both = unite(std::vector<Solid>{a, b});
    const UnionTopology found = topology(mesh(a), mesh(b));
    if (!both.contacts().empty()) {
      continue;  // pieces that touch count as one here
    }
    ASSERT_EQ(found.components, both.components()) << round;
    several += found.components > 1 ? 1 : 0;
  }
  EXPECT_GT(several, 5);
}

}  // namespace
}  // namespace dupin::gaps
