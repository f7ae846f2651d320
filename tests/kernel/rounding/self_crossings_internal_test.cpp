#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "dupin/kernel/solid.h"
#include "rounding/self_crossings.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

std::vector<Source> sources_of(const TriMesh& mesh) {
  std::vector<Source> sources;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    sources.push_back({7, t});
  }
  return sources;
}

Solid solid(mesh::ExactMesh mesh) {
  return Solid(std::make_shared<const mesh::ExactMesh>(std::move(mesh)));
}

/// Two boxes that cross each other, and one by itself.
const TriMesh kCrossing =
    test::joined({test::box(Vec3(0, 0, 0), Vec3(2, 2, 2)), test::box(Vec3(1, 1, 1), Vec3(3, 3, 3)),
                  test::box(Vec3(8, 0, 0), Vec3(9, 1, 1))});

TEST(SelfCrossings, are_cut_away) {
  std::vector<Fault> faults;
  for (std::uint32_t f = 0; f < 12; ++f) {
    for (std::uint32_t g = 12; g < 24; ++g) {
      faults.push_back({f, g});
    }
  }
  const auto cut = without_self_crossings(kCrossing, sources_of(kCrossing), faults, .1, 1);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->lost, 0);
  EXPECT_EQ(cut->lost_shells, 0);
  for (const Source& source : cut->solid.sources) {
    EXPECT_EQ(source.operand, 7);
    EXPECT_LT(source.triangle, kCrossing.triangles.size());
  }
  const Solid united = solid(cut->solid);
  EXPECT_EQ(united.exact_volume(), 16);
  EXPECT_EQ(united.components(), 2);
}

TEST(SelfCrossings, go_with_triangles_without_area_and_points_that_coincide) {
  TriMesh mesh = test::box(Vec3(0, 0, 0), Vec3(2, 2, 2));
  // One edge becomes two, with a triangle on the line between them, and a copy of a point.
  const auto [a, b, c] = mesh.triangles.front();
  const auto middle = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back((mesh.points[a] + mesh.points[b]) / 2);
  mesh.points.push_back(mesh.points[c]);
  mesh.triangles.front() = {a, middle, middle + 1};
  mesh.triangles.push_back({middle, b, c});
  mesh.triangles.push_back({a, b, middle});
  const std::uint32_t flat = 13;
  const auto closed =
      without_self_crossings(mesh, sources_of(mesh), std::vector<Fault>{{flat, flat}}, .1, 1);
  ASSERT_TRUE(closed);
  const Solid box = solid(closed->solid);
  EXPECT_EQ(box.exact_volume(), 8);
  EXPECT_EQ(box.components(), 1);
}

std::vector<Fault> all_pairs(const TriMesh& mesh) {
  std::vector<Fault> faults;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::uint32_t g = f + 1; g < mesh.triangles.size(); ++g) {
      faults.push_back({f, g});
    }
  }
  return faults;
}

/// Beside a box of 2, something that has no inside, or that is inside out.
void expect_lost(const TriMesh& beside, double distance) {
  const TriMesh mesh = test::joined({test::box(Vec3(0, 0, 0), Vec3(2, 2, 2)), beside});
  const std::vector<Fault> faults = all_pairs(mesh);
  EXPECT_FALSE(without_self_crossings(mesh, sources_of(mesh), faults, .01, .99 * distance));
  const auto cut = without_self_crossings(mesh, sources_of(mesh), faults, .01, 1.01 * distance);
  ASSERT_TRUE(cut);
  EXPECT_GE(cut->lost, distance);
  EXPECT_LE(cut->lost, 1.01 * distance);
  EXPECT_EQ(cut->lost_shells, 1);
  EXPECT_EQ(solid(cut->solid).exact_volume(), 8);
}

TEST(SelfCrossings, tell_how_far_what_is_lost_was_from_what_is_left) {
  const double farthest = std::sqrt(49 + 4);
  TriMesh plate = test::box(Vec3(5, 0, 1), Vec3(9, 4, 2));
  for (Vec3& point : plate.points) {
    point.z() = 1;
  }
  {
    SCOPED_TRACE("sheets that became one");
    expect_lost(plate, farthest);
  }
  {
    SCOPED_TRACE("one divided otherwise than the other");
    const TriMesh thick = test::box(Vec3(5, 0, 1), Vec3(9, 4, 2)),
                  other = test::cut_otherwise(thick);
    TriMesh mixed = thick;
    mixed.triangles.clear();
    const auto add = [&](const TriMesh& from, bool is_top) {
      for (Triangle t : from.triangles) {
        const auto is_high = [&](std::uint32_t corner) { return from.points[corner].z() == 2; };
        if (std::ranges::all_of(t, is_high) == is_top) {
          for (std::uint32_t& corner : t) {
            const auto there = std::ranges::find(thick.points, from.points[corner]);
            corner = static_cast<std::uint32_t>(there - thick.points.begin());
          }
          mixed.triangles.push_back(t);
        }
      }
    };
    add(thick, false);
    add(other, true);
    for (Vec3& point : mixed.points) {
      point.z() = 1;
    }
    expect_lost(mixed, farthest);
  }
  {
    SCOPED_TRACE("one that is inside out");
    expect_lost(test::reversed(test::box(Vec3(5, 0, 0), Vec3(9, 4, .125))), farthest);
  }
}

TEST(SelfCrossings, lose_nothing_of_what_lies_within) {
  // Two boxes that meet in a face, and a sheet in one of them.
  TriMesh sheet = test::box(Vec3(.5, .5, .5), Vec3(1.5, 1.5, 1));
  for (Vec3& point : sheet.points) {
    point.z() = .5;
  }
  const TriMesh mesh =
      test::joined({test::box(Vec3(0, 0, 0), Vec3(2, 2, 2)),
                    test::cut_otherwise(test::box(Vec3(2, 0, 0), Vec3(4, 2, 2))), sheet});
  const auto cut = without_self_crossings(mesh, sources_of(mesh), all_pairs(mesh), 1e-9, 1e-8);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->lost, 0);
  EXPECT_EQ(cut->lost_shells, 0);
  EXPECT_EQ(solid(cut->solid).exact_volume(), 16);
  EXPECT_EQ(solid(cut->solid).components(), 1);
}

TEST(SelfCrossings, leave_nothing_of_what_is_inside_out) {
  const TriMesh mesh = test::reversed(test::box(Vec3(0, 0, 0), Vec3(2, 2, 2)));
  EXPECT_FALSE(without_self_crossings(mesh, sources_of(mesh), {}, .1, 1));
}

}  // namespace
}  // namespace dupin::rounding
