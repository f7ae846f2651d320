#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "dupin/kernel/check.h"
#include "rounding/edits/edit_strategy.h"
#include "rounding/edits/thicken_in_slabs.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

constexpr double kReach = 1e-3;

/// A rough pipe along x of rings, in pairs nearly in one place, with long strips between pairs and
/// short edges around.
TriMesh rough_pipe(std::uint32_t rings, std::uint32_t segments) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> offset(-kReach / 16, kReach / 16);
  TriMesh mesh;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    const double x = (ring - ring % 2) / 2.0 + (ring % 2) * kReach / 3;
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle = 2 * std::numbers::pi * i / segments;
      mesh.points.emplace_back(x + offset(random), std::cos(angle) + offset(random),
                               std::sin(angle) + offset(random));
    }
  }
  const auto at = [&](std::uint32_t ring, std::uint32_t i) {
    return ring * segments + i % segments;
  };
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
    for (std::uint32_t i = 0; i < segments; ++i) {
      mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i)});
      mesh.triangles.push_back({at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)});
    }
  }
  for (std::uint32_t i = 1; i + 1 < segments; ++i) {
    mesh.triangles.push_back({at(0, 0), at(0, i + 1), at(0, i)});
    mesh.triangles.push_back({at(rings - 1, 0), at(rings - 1, i), at(rings - 1, i + 1)});
  }
  return mesh;
}

struct Thickened {
  TriMesh mesh;
  std::size_t short_edges = 0;
  double reach = 0;
};

template <class Thicken>
Thickened thickened(const TriMesh& shape, const Thicken& thicken) {
  std::vector<std::uint32_t> own(shape.points.size());
  std::iota(own.begin(), own.end(), 0U);
  const BrokenMesh original{shape.points, shape.points, shape.triangles, {}, own};
  EditedMesh mesh(shape.points, shape.triangles, {}, own);
  thicken(mesh, original);
  Thickened result{mesh.mesh_of(mesh.alive_faces())};
  for (const Triangle& t : result.mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 edge = result.mesh.points[t[i]] - result.mesh.points[t[(i + 1) % 3]];
      result.short_edges += edge.norm() < kReach ? 1 : 0;
    }
  }
  for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
    result.reach = std::max(result.reach, mesh.reach(v));
  }
  return result;
}

Thickened in_slabs(const TriMesh& shape, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return thickened(shape, [](EditedMesh& mesh, const BrokenMesh& original) {
    thicken(mesh, kReach, thicken_in_slabs(mesh, original, kReach));
  });
}

TEST(ThickenInSlabs, makes_of_a_large_mesh_what_one_thread_makes_of_the_whole) {
  const TriMesh shape = rough_pipe(400, 100);
  ASSERT_TRUE(check(shape).is_solid());
  const Thickened slabs = in_slabs(shape, 1);
  EXPECT_TRUE(check(slabs.mesh).is_solid());
  EXPECT_LE(slabs.reach, kReach);
  const Thickened whole = thickened(shape, [](EditedMesh& mesh, const BrokenMesh&) {
    std::vector<std::uint32_t> all(mesh.face_count());
    std::iota(all.begin(), all.end(), 0U);
    thicken(mesh, kReach, std::move(all));
  });
  EXPECT_LT(100 * slabs.mesh.triangles.size(), 55 * shape.triangles.size());
  EXPECT_LE(100 * slabs.short_edges, 102 * whole.short_edges + 800);
  EXPECT_LE(100 * slabs.mesh.triangles.size(), 102 * whole.mesh.triangles.size());
}

TEST(ThickenInSlabs, does_not_depend_on_threads) {
  const TriMesh shape = rough_pipe(400, 100);
  const TriMesh one = in_slabs(shape, 1).mesh, two = in_slabs(shape, 2).mesh;
  EXPECT_EQ(one.triangles, two.triangles);
  EXPECT_EQ(one.points, two.points);
}

TEST(ThickenInSlabs, does_without_slabs_where_there_are_none) {
  const TriMesh small = rough_pipe(4, 12);
  EXPECT_EQ(in_slabs(small, 2).mesh.triangles.size(), 2 * 24 - 4U);
  std::vector<TriMesh> columns;  // with points on two heights only
  for (int i = 0; i < 3000; ++i) {
    const Vec3 low(2 * (i % 50), 2 * (i / 50), 0);
    columns.push_back(test::box(low, low + Vec3(1, 1, 1000)));
  }
  const TriMesh shape = test::joined(columns);
  EXPECT_EQ(in_slabs(shape, 2).mesh.triangles, shape.triangles);
}

}  // namespace
}  // namespace dupin::rounding
