#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/solid.h"
#include "support/shapes.h"

// Shells that overlap and have the faces in common where they do, some of them inside out: none of
// what they bound is lost.
namespace dupin {
namespace {

using test::box;
using test::joined;
using test::reversed;

mpq_class repaired_volume(const TriMesh& mesh) { return repair(mesh).solid.exact_volume(); }

/// From one cross section to another, both whole numbers; its sides are divided at those between.
struct Beam {
  std::uint32_t from, to;
};

// Sides have the same triangles in all beams that have them.
TriMesh surface_of(const Beam& beam) {
  TriMesh mesh;
  for (std::uint32_t x = beam.from; x <= beam.to; ++x) {
    for (const auto& [y, z] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      mesh.points.emplace_back(x, y, z);
    }
  }
  const std::uint32_t last = 4 * (beam.to - beam.from);
  for (std::uint32_t at = 0; at < last; at += 4) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t a = at + k, b = at + (k + 1) % 4;
      mesh.triangles.push_back({a, b, b + 4});
      mesh.triangles.push_back({a, b + 4, a + 4});
    }
  }
  mesh.triangles.push_back({0, 2, 1});
  mesh.triangles.push_back({0, 3, 2});
  mesh.triangles.push_back({last, last + 1, last + 2});
  mesh.triangles.push_back({last, last + 2, last + 3});
  return mesh;
}

std::uint32_t length_of_union(const std::vector<Beam>& beams) {
  std::uint32_t length = 0;
  for (std::uint32_t x = 0; x < 16; ++x) {
    length += std::ranges::any_of(beams, [&](const Beam& b) { return b.from <= x && x < b.to; });
  }
  return length;
}

// Those whose bits are set inside out.
TriMesh soup_of(const std::vector<Beam>& beams, std::uint32_t inside_out) {
  std::vector<TriMesh> meshes;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const TriMesh mesh = surface_of(beams[i]);
    meshes.push_back((inside_out >> i & 1) != 0 ? reversed(mesh) : mesh);
  }
  return joined(meshes);
}

// None is within another one: that could be the wall of a cavity.
const std::vector<std::vector<Beam>> kChains = {
    {{0, 2}, {1, 3}},         {{0, 3}, {1, 4}},
    {{0, 3}, {2, 5}},         {{0, 2}, {1, 3}, {2, 4}},
    {{0, 2}, {1, 3}, {3, 4}}, {{0, 2}, {1, 3}, {4, 6}},
    {{0, 2}, {1, 4}, {3, 5}}, {{0, 3}, {2, 5}, {4, 7}, {6, 8}}};
const std::vector<std::vector<Beam>> kHeaps = {{{0, 3}, {1, 4}, {2, 5}},
                                               {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};

TEST(OverlappingShells, beams_that_overlap_all_count_where_all_or_none_are_inside_out) {
  std::vector<std::vector<Beam>> both = kChains;
  both.insert(both.end(), kHeaps.begin(), kHeaps.end());
  for (const std::vector<Beam>& beams : both) {
    const std::uint32_t volume = length_of_union(beams), all = (1U << beams.size()) - 1;
    for (const std::uint32_t inside_out : {0U, all}) {
      SCOPED_TRACE(testing::Message() << (&beams - both.data()) << "," << inside_out);
      const TriMesh mesh = soup_of(beams, inside_out);
      EXPECT_EQ(repaired_volume(mesh), volume);
      EXPECT_EQ(repaired_volume(joined({mesh, box({0, 5, 0}, {1, 6, 1})})), volume + 1);
    }
  }
}

TEST(OverlappingShells, beams_that_overlap_all_count_whichever_are_inside_out) {
  for (const std::vector<Beam>& beams : kChains) {
    const std::uint32_t volume = length_of_union(beams);
    for (std::uint32_t inside_out = 0; inside_out < 1U << beams.size(); ++inside_out) {
      SCOPED_TRACE(testing::Message() << (&beams - kChains.data()) << "," << inside_out);
      const TriMesh mesh = soup_of(beams, inside_out);
      EXPECT_EQ(repaired_volume(mesh), volume);
      EXPECT_EQ(repaired_volume(joined({mesh, box({0, 5, 0}, {1, 6, 1})})), volume + 1);
    }
  }
}

// It has edges in common with the other: so a cavity at its end only if it faces the other way.
TEST(OverlappingShells, of_beams_with_one_end_in_common_the_short_one_may_be_a_cavity) {
  const std::vector<Beam> beams = {{0, 2}, {0, 1}};
  for (const std::uint32_t inside_out : {0U, 3U}) {
    EXPECT_EQ(repaired_volume(soup_of(beams, inside_out)), 2);
  }
  for (const std::uint32_t inside_out : {1U, 2U}) {
    EXPECT_EQ(repaired_volume(soup_of(beams, inside_out)), 1);
  }
}

TriMesh with_random_faces_turned(TriMesh mesh, std::mt19937& random) {
  for (Triangle& t : mesh.triangles) {
    if (random() % 2 == 0) {
      std::swap(t[1], t[2]);
    }
  }
  return mesh;
}

// What is left of both, or nothing where repair() says that it would lose something.
std::optional<mpq_class> volume_unless_refused(const TriMesh& mesh) {
  try {
    return repaired_volume(mesh);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::not_oriented);
    EXPECT_NE(std::string(error.what()).find("would be lost"), std::string::npos) << error.what();
    return std::nullopt;
  }
}

// Their ends are copies, their sides are not: without the ends, sides that face opposite ways close
// each other around nothing.
TEST(OverlappingShells, of_beams_in_one_place_whose_sides_are_divided_otherwise_one_is_left) {
  std::mt19937 random(34);
  const TriMesh whole = surface_of({0, 1}), divided = surface_of({0, 3});
  TriMesh stretched = whole;
  for (Vec3& point : stretched.points) {
    point.x() *= 3;
  }
  int refused = 0;
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    const auto volume = volume_unless_refused(joined(
        {with_random_faces_turned(stretched, random), with_random_faces_turned(divided, random)}));
    EXPECT_EQ(volume.value_or(3), 3);
    refused += volume ? 0 : 1;
  }
  EXPECT_LT(refused, 20);
}

// In whichever way the three agree, and one is inside out.
TEST(OverlappingShells, a_body_that_is_there_twice_beside_another_is_no_cavity) {
  const TriMesh one = surface_of({0, 2}), beside = surface_of({2, 3});
  for (std::uint32_t turns = 0; turns < 16; ++turns) {
    SCOPED_TRACE(turns);
    std::vector<TriMesh> bodies;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const TriMesh& body = i < 3 ? one : beside;
      bodies.push_back((turns >> i & 1) != 0 ? reversed(body) : body);
    }
    EXPECT_EQ(repaired_volume(joined(bodies)), 3);
  }
}

}  // namespace
}  // namespace dupin
