#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checking/height_field_patches.h"
#include "checking/self_intersection.h"
#include "kernel/torus.h"
#include "predicates/triangle_overlap.h"
#include "support/none.h"

namespace dupin::checking {
namespace {

using test::shake;
using test::torus;

/// Looks at each pair of triangles of one patch by itself. Returns how many there are.
std::size_t expect_apart(const TriMesh& mesh, const HeightFieldPatches& patches) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> faces;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    if (patches.of_triangle[f] != support::kNone) {
      faces[patches.of_triangle[f]].push_back(f);
    }
  }
  EXPECT_EQ(faces.size(), patches.count);
  std::size_t pairs = 0;
  for (const auto& [patch, members] : faces) {
    for (const std::uint32_t f : members) {
      const auto& [a, b, c] = mesh.triangles[f];
      EXPECT_FALSE(predicates::collinear(mesh.points[a], mesh.points[b], mesh.points[c]));
      const predicates::TriangleOverlapTest probe(mesh.points, mesh.triangles[f]);
      for (const std::uint32_t g : members) {
        if (f < g) {
          ++pairs;
          EXPECT_EQ(probe.meeting(mesh.triangles[g]), predicates::TriangleOverlap::none)
              << f << " " << g;
        }
      }
    }
  }
  return pairs;
}

std::size_t largest(const HeightFieldPatches& patches) {
  std::vector<std::size_t> sizes(patches.count);
  for (const std::uint32_t patch : patches.of_triangle) {
    if (patch != support::kNone) {
      ++sizes[patch];
    }
  }
  return std::ranges::max(sizes);
}

TEST(MonotonePatches, are_few_on_smooth_surfaces) {
  const TriMesh mesh = torus(64, 256, 10, 2);
  const HeightFieldPatches patches =
      height_field_patches(mesh.points, mesh.triangles, {.closed = true});
  EXPECT_LE(patches.count, 40);
  EXPECT_EQ(std::ranges::count(patches.of_triangle, support::kNone), 0);
  EXPECT_GT(largest(patches), mesh.triangles.size() / 8);
  EXPECT_EQ(height_field_patches(mesh.points, mesh.triangles).of_triangle, patches.of_triangle);
}

TEST(MonotonePatches, are_apart_on_rough_surfaces) {
  std::mt19937 random(20261122);
  std::size_t pairs = 0, crossing = 0;
  for (int round = 0; round < 200; ++round) {
    TriMesh mesh = torus(6 + round % 5, 9 + round % 7, 2, round % 2 == 0 ? 1 : 1.9);
    shake(mesh, 0.02 * (round % 40), random);
    for (const bool closed : {true, false}) {
      pairs +=
          expect_apart(mesh, height_field_patches(mesh.points, mesh.triangles, {.closed = closed}));
    }
    crossing += find_self_intersections(mesh.points, mesh.triangles).none() ? 0 : 1;
  }
  EXPECT_GT(pairs, 100000);
  EXPECT_GT(crossing, 100);
}

TEST(MonotonePatches, are_not_sought_where_fewer_points_are_smooth_than_asked_for) {
  TriMesh mesh = torus(64, 256, 10, 2);
  const auto patches = [&](double smooth) {
    return height_field_patches(mesh.points, mesh.triangles, {.closed = true, .smooth = smooth});
  };
  EXPECT_EQ(patches(0.8).of_triangle, patches(0).of_triangle);
  std::mt19937 random(8);
  shake(mesh, 0.2, random);
  EXPECT_GT(patches(0).count, 0);
  const HeightFieldPatches none = patches(0.8);
  EXPECT_EQ(none.count, 0);
  EXPECT_EQ(std::ranges::count(none.of_triangle, support::kNone), mesh.triangles.size());
  EXPECT_EQ(std::ranges::count(none.is_inner, 1), 0);
}

TEST(MonotonePatches, are_apart_where_points_lie_on_a_coarse_grid) {
  std::mt19937 random(3);
  std::size_t pairs = 0;
  for (int round = 0; round < 300; ++round) {
    TriMesh mesh = torus(5 + round % 4, 7 + round % 3, 3, 1.5);
    shake(mesh, 0.2, random);
    for (Vec3& p : mesh.points) {
      p = p.array().round();
    }
    pairs +=
        expect_apart(mesh, height_field_patches(mesh.points, mesh.triangles, {.closed = true}));
  }
  EXPECT_GT(pairs, 10000);
}

/// Triangles that share points at random, with edges of any number of them.
TEST(MonotonePatches, are_apart_in_soups) {
  std::mt19937 random(4);
  std::size_t pairs = 0;
  for (int round = 0; round < 10000; ++round) {
    TriMesh soup;
    for (int i = 0; i < 8; ++i) {
      soup.points.emplace_back(random() % 5, random() % 5, random() % 2);
    }
    while (soup.triangles.size() < 10) {
      const Triangle t = {static_cast<std::uint32_t>(random() % 8),
                          static_cast<std::uint32_t>(random() % 8),
                          static_cast<std::uint32_t>(random() % 8)};
      soup.triangles.push_back(t);
    }
    pairs += expect_apart(soup, height_field_patches(soup.points, soup.triangles));
  }
  EXPECT_GT(pairs, 1000);
}

/// A ramp that winds upward faces one way all along, and lies over itself.
TEST(MonotonePatches, do_not_lie_over_themselves) {
  TriMesh ramp;
  constexpr std::uint32_t kSteps = 300;
  for (std::uint32_t i = 0; i <= kSteps; ++i) {
    const double angle = 0.1 * i;
    ramp.points.emplace_back(std::cos(angle), std::sin(angle), 0.05 * i);
    ramp.points.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), 0.05 * i);
    if (i < kSteps) {
      ramp.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
      ramp.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
    }
  }
  const HeightFieldPatches patches = height_field_patches(ramp.points, ramp.triangles);
  const double turns = 0.1 * kSteps / (2 * std::numbers::pi);
  EXPECT_LT(static_cast<double>(largest(patches)),
            1.001 * static_cast<double>(ramp.triangles.size()) / turns);
  EXPECT_GT(largest(patches), ramp.triangles.size() / 20);
}

/// Two flat fans about one point, each of which goes round once.
TEST(MonotonePatches, go_round_a_point_once) {
  TriMesh mesh;
  mesh.points.emplace_back(0, 0, 0);
  for (std::uint32_t i = 0; i < 16; ++i) {
    const double angle = std::numbers::pi * i / 4;
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0.01 * i);
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 16});
  }
  const HeightFieldPatches patches = height_field_patches(mesh.points, mesh.triangles);
  expect_apart(mesh, patches);
  EXPECT_LE(largest(patches), 8);
}

TEST(SelfIntersection, within_patches_need_not_be_sought) {
  std::mt19937 random(9);
  std::size_t found = 0;
  for (int round = 0; round < 60; ++round) {
    TriMesh mesh = torus(12, 24, 2, round % 3 == 0 ? 2.2 : 1);
    shake(mesh, 0.01 * (round % 20), random);
    std::vector<FacePair> expected;
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
      const predicates::TriangleOverlapTest probe(mesh.points, mesh.triangles[f]);
      for (std::uint32_t g = f + 1; g < mesh.triangles.size(); ++g) {
        if (probe.meeting(mesh.triangles[g]) == predicates::TriangleOverlap::crossing) {
          expected.push_back({f, g});
        }
      }
    }
    const auto crossings =
        find_self_intersections(mesh.points, mesh.triangles, {.closed = true}).pairs;
    ASSERT_EQ(crossings, expected) << round;
    found += expected.size();
  }
  EXPECT_GT(found, 1000);
}

// With faces left out, which makes patches end where they did not.
TEST(MonotonePatches, are_apart_where_only_the_rim_is_open) {
  std::mt19937 random(11);
  std::size_t pairs = 0, inner = 0;
  for (int round = 0; round < 100; ++round) {
    TriMesh mesh = torus(8 + round % 5, 12 + round % 7, 2, 1);
    shake(mesh, 0.01 * (round % 30), random);
    std::vector<std::uint8_t> rim(mesh.points.size());
    std::erase_if(mesh.triangles, [&](const Triangle& triangle) {
      const bool is_left_out = random() % 10 == 0;
      for (const std::uint32_t corner : triangle) {
        rim[corner] |= is_left_out ? 1 : 0;
      }
      return is_left_out;
    });
    const HeightFieldPatches patches =
        height_field_patches(mesh.points, mesh.triangles, {.closed = true, .rim = rim});
    pairs += expect_apart(mesh, patches);
    for (std::size_t point = 0; point < rim.size(); ++point) {
      EXPECT_TRUE(rim[point] == 0 || patches.is_inner[point] == 0);
      inner += patches.is_inner[point];
    }
  }
  EXPECT_GT(pairs, 10000);
  EXPECT_GT(inner, 100);
}

}  // namespace
}  // namespace dupin::checking
