#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "surfaces/kneecap_chain_mesh.h"

namespace dupin::surfaces {
namespace {

using test::corner_spheres;
using test::cylinder_to_cone_spheres;
using test::lune_spheres;

using Spheres = std::vector<PeVector>;

struct Meshed {
  std::vector<PeArc> arcs;
  std::uint32_t segments = 0;
  Tessellation result;
};

Meshed meshed(const Spheres& spheres, double tolerance, double grid = 0) {
  Meshed found{through_all(spheres)};
  found.segments = kneecap_chain_segments(found.arcs, tolerance, grid);
  found.result =
      kneecap_chain_mesh(flipped(circle_at(found.arcs.front(), 0)), circle_at(found.arcs.back(), 1),
                         found.arcs, {found.segments, 0.3, grid}, {tolerance})
          .tessellation;
  return found;
}

// The shells' triangles, in the order of the chain.
std::vector<std::vector<Triangle>> shells(const TriMesh& mesh) {
  const Report report = check(mesh, {.limit = 1, .self_intersections = false});
  std::vector<std::vector<Triangle>> result;
  auto from = mesh.triangles.begin();
  for (const ShellReport& shell : report.shells) {
    EXPECT_EQ(shell.first_face, from - mesh.triangles.begin());
    const auto to = from + std::ptrdiff_t(shell.triangles);
    result.emplace_back(from, to);
    from = to;
  }
  return result;
}

bool is_in_plane(const Ring& circle, const TriMesh& mesh, const Triangle& triangle) {
  return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t corner) {
    return std::abs((mesh.points[corner] - circle.center).dot(circle.normal)) < 1e-12;
  });
}

TEST(KneecapChainMesh, consists_of_pieces_and_sectors) {
  Spheres three = corner_spheres(1);
  three.push_back({three.back().m + 2 * Vec3::UnitY() + 1.5 * Vec3::UnitZ(), 1});
  three.push_back({three.back().m + 2 * Vec3::UnitY() + 1.5 * Vec3::UnitZ(), .9});
  struct Row {
    Spheres spheres;
    std::vector<int> euler;  // of the shells: pieces are open where the chain ends
  };
  const Row rows[] = {
      {lune_spheres(), {1, 2, 1}},
      {corner_spheres(2), {1, 2, 1}},
      {cylinder_to_cone_spheres(-0.2, 0.15), {1, 2, 1}},  // a band
      {cylinder_to_cone_spheres(0.2, 0.15), {1, 1}},      // nothing of the joint is seen
      {corner_spheres(0), {1, 1}},                        // smooth
      {three, {1, 2, 2, 2, 1}},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(&row - rows);
    const Meshed found = meshed(row.spheres, 0.02, 0x1p-20);
    const Report report = check(found.result.mesh, {.self_intersections = false});
    EXPECT_EQ(report.count(Defect::boundary_edge), 2 * found.segments);
    for (const Defect none :
         {Defect::degenerate_face, Defect::non_manifold_edge, Defect::non_manifold_vertex,
          Defect::inconsistent_orientation, Defect::isolated_point}) {
      EXPECT_EQ(report.count(none), 0U) << name(none);
    }
    ASSERT_EQ(report.shells.size(), row.euler.size());
    for (std::size_t i = 0; i < row.euler.size(); ++i) {
      EXPECT_EQ(report.shells[i].euler_number, row.euler[i]);
      if (row.euler[i] == 2) {
        EXPECT_GT(report.shells[i].volume, 0);
      }
    }
  }
}

// So that the union's exact arithmetic has nothing to cut where they meet.
TEST(KneecapChainMesh, sectors_have_the_very_triangles_of_the_pieces_discs) {
  for (const Spheres& spheres : {lune_spheres(), corner_spheres(2), corner_spheres(0.3),
                                 cylinder_to_cone_spheres(-0.2, 0.15)}) {
    const Meshed found = meshed(spheres, 0.02);
    const TriMesh& mesh = found.result.mesh;
    const auto parts = shells(mesh);
    ASSERT_EQ(parts.size(), 3U);
    const auto key = [&](Triangle triangle, bool reversed) {
      if (reversed) {
        std::swap(triangle[1], triangle[2]);
      }
      std::array<std::array<double, 3>, 3> places{};
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& p = mesh.points[triangle.at(i)];
        places.at(i) = {p.x(), p.y(), p.z()};
      }
      std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
      return places;
    };
    std::map<std::array<std::array<double, 3>, 3>, int> of_pieces;
    for (const std::size_t piece : {0U, 2U}) {
      for (const Triangle& triangle : parts[piece]) {
        ++of_pieces[key(triangle, false)];
      }
    }
    const Ring before = circle_at(found.arcs[0], 1), after = circle_at(found.arcs[1], 0);
    int plane = 0;
    for (const Triangle& triangle : parts[1]) {
      const bool is_disc =
          is_in_plane(before, mesh, triangle) || is_in_plane(after, mesh, triangle);
      EXPECT_EQ(of_pieces.count(key(triangle, true)), is_disc ? 1U : 0U);
      plane += is_disc ? 1 : 0;
    }
    EXPECT_GT(plane, 4);
  }
}

TEST(KneecapChainMesh, keeps_to_the_tolerance_with_the_segments_it_asks_for) {
  for (const Spheres& spheres : {lune_spheres(), corner_spheres(2), corner_spheres(1e-3),
                                 cylinder_to_cone_spheres(-0.2, 0.15)}) {
    for (const double tolerance : {0.1, 0.01}) {
      const Meshed found = meshed(spheres, tolerance, 0x1p-16);
      EXPECT_LE(found.result.error_bound, tolerance);
      const TriMesh& mesh = found.result.mesh;
      const auto parts = shells(mesh);
      // Lateral triangles, by their own piece.
      double largest = 0;
      for (std::size_t i = 0; i < 2; ++i) {
        for (const Triangle& triangle : i == 0 ? parts.front() : parts.back()) {
          const auto& [a, b, c] = triangle;
          const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
          const Vec3 facing = (q - p).cross(r - p).normalized();
          const Ring circle = circle_at(found.arcs[i], i == 0 ? 1 : 0);
          if (std::abs(facing.dot(circle.normal)) < 0.9) {
            const Vec3 middle = (p + q + r) / 3;
            largest = std::max(largest, std::abs(signed_distance(found.arcs[i], middle)));
          }
        }
      }
      EXPECT_LE(largest, found.result.error_bound);
      EXPECT_GE(largest, found.result.error_bound / 5);
    }
  }
  const std::vector<PeArc> arcs = through_all(lune_spheres());
  EXPECT_THROW((void)kneecap_chain_segments(arcs, 0.01, 0.01), Error);
  const Ring start = flipped(circle_at(arcs.front(), 0)), end = circle_at(arcs.back(), 1);
  EXPECT_THROW((void)kneecap_chain_mesh(start, end, arcs, {32, 0, 0.01}, {0.01}), Error);
  // What snapping costs is stated on top: where chords are left as much, the bands are the same.
  const std::vector<PeArc> pipe = through_all(corner_spheres(0));
  const auto bound = [&](double tolerance, double grid) {
    return kneecap_chain_mesh(flipped(circle_at(pipe.front(), 0)), circle_at(pipe.back(), 1), pipe,
                              {32, 0, grid}, {tolerance})
        .tessellation.error_bound;
  };
  constexpr double kGrid = 0x1p-7, kMove = std::numbers::sqrt3 / 2 * kGrid;
  EXPECT_NEAR(bound(0.1 + kMove, kGrid), bound(0.1, 0) + kMove, 1e-9);
  // With fewer segments it says how far it is.
  EXPECT_GT(kneecap_chain_mesh(start, end, arcs, {12}, {0.001}).tessellation.error_bound, 0.01);
}

// The circles are apart by a hundredth of the tolerance; they become one polygon.
TEST(KneecapChainMesh, joins_circles_that_are_nearly_one) {
  constexpr double kBend = 1e-3, kTolerance = 0.1;
  const Meshed found = meshed(corner_spheres(kBend), kTolerance);
  const auto parts = shells(found.result.mesh);
  ASSERT_EQ(parts.size(), 2U);
  const auto joint_points = [&](const std::vector<Triangle>& part) {
    std::vector<std::array<double, 3>> places;
    for (const Triangle& triangle : part) {
      for (const std::uint32_t corner : triangle) {
        const Vec3& p = found.result.mesh.points[corner];
        if (p.norm() < 1.5) {
          places.push_back({p.x(), p.y(), p.z()});
        }
      }
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  };
  EXPECT_EQ(joint_points(parts[0]).size(), found.segments);
  EXPECT_EQ(joint_points(parts[0]), joint_points(parts[1]));
  // What they are apart counts: as much more than of a straight chain.
  const double straight = meshed(corner_spheres(0), kTolerance).result.error_bound;
  EXPECT_NEAR(found.result.error_bound - straight, kBend, kBend / 10);
}

}  // namespace
}  // namespace dupin::surfaces
