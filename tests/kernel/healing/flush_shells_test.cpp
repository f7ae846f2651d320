#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/repair.h"
#include "dupin/kernel/solid.h"
#include "support/shapes.h"

// Closed shells side by side, whose common walls are divided otherwise on each side, some of them
// inside out: none of what they bound is lost.
namespace dupin {
namespace {

using test::joined;
using test::reversed;

using Random = std::mt19937;

std::uint32_t below(Random& random, std::size_t count) {
  return static_cast<std::uint32_t>(random() % count);
}

mpq_class repaired_volume(const TriMesh& mesh) { return repair(mesh).solid.exact_volume(); }

// A polygon of points of a mesh, by random diagonals.
void add_polygon(TriMesh& mesh, const std::vector<std::uint32_t>& corners, Random& random) {
  if (corners.size() < 3) {
    return;
  }
  const auto apex = corners.begin() + 1 + below(random, corners.size() - 2);
  mesh.triangles.push_back({corners.front(), *apex, corners.back()});
  add_polygon(mesh, {corners.begin(), apex + 1}, random);
  add_polygon(mesh, {apex, corners.end()}, random);
}

TriMesh random_box(const Vec3& low, const Vec3& high, Random& random) {
  TriMesh mesh = test::box(low, high);
  mesh.triangles.clear();
  for (const auto& side : std::vector<std::vector<std::uint32_t>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    add_polygon(mesh, side, random);
  }
  return mesh;
}

/// Whole unit cubes from the low corner on up to the high one.
struct Block {
  std::array<int, 3> low, high;
  [[nodiscard]] int volume() const {
    return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
  }
  [[nodiscard]] bool overlaps(const Block& other) const {
    return std::ranges::equal(low, other.high, std::less()) &&
           std::ranges::equal(other.low, high, std::less());
  }
};

constexpr int kSide = 4;

Block random_block(Random& random) {
  Block block{};
  for (std::size_t k = 0; k < 3; ++k) {
    block.low[k] = static_cast<int>(below(random, kSide));
    block.high[k] = block.low[k] + 1 + static_cast<int>(below(random, kSide - block.low[k]));
  }
  return block;
}

// The sides in unit squares, each by a random diagonal.
TriMesh surface_of(const Block& block, Random& random) {
  TriMesh mesh;
  for (int i = 0; i < (kSide + 1) * (kSide + 1) * (kSide + 1); ++i) {
    mesh.points.emplace_back(i % (kSide + 1), i / (kSide + 1) % (kSide + 1),
                             i / (kSide + 1) / (kSide + 1));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    for (const bool is_high : {false, true}) {
      std::array<int, 3> at{};
      at[k] = is_high ? block.high[k] : block.low[k];
      for (at[l] = block.low[l]; at[l] < block.high[l]; ++at[l]) {
        for (at[m] = block.low[m]; at[m] < block.high[m]; ++at[m]) {
          const std::array<int, 3> step{1, kSide + 1, (kSide + 1) * (kSide + 1)};
          const auto a = static_cast<std::uint32_t>(at[0] + at[1] * step[1] + at[2] * step[2]);
          const std::uint32_t b = a + step[is_high ? l : m], d = a + step[is_high ? m : l];
          add_polygon(mesh, {a, b, b + d - a, d}, random);
        }
      }
    }
  }
  return mesh;
}

// None has anything inside in common with another one.
std::vector<Block> random_blocks(Random& random) {
  std::vector<Block> blocks;
  for (std::size_t n = 2 + below(random, 20); n > 0; --n) {
    const Block block = random_block(random);
    if (std::ranges::none_of(blocks, [&](const Block& other) { return block.overlaps(other); })) {
      blocks.push_back(block);
    }
  }
  return blocks;
}

std::vector<TriMesh> random_cells(Random& random, std::size_t most) {
  std::set<std::array<std::uint32_t, 3>> places;
  const std::size_t side = 2 + below(random, 2);
  for (std::size_t n = 2 + below(random, most - 1); n > 0; --n) {
    places.insert({below(random, side), below(random, side), below(random, side)});
  }
  std::vector<TriMesh> cells;
  for (const auto& [x, y, z] : places) {
    cells.push_back(random_box(Vec3(x, y, z), Vec3(x + 1, y + 1, z + 1), random));
  }
  return cells;
}

TriMesh some_reversed(std::vector<TriMesh> meshes, Random& random) {
  for (TriMesh& mesh : meshes) {
    mesh = random() % 2 == 0 ? mesh : reversed(mesh);
  }
  return joined(meshes);
}

// Every face by itself turned or not.
TriMesh some_faces_turned(TriMesh mesh, Random& random) {
  for (Triangle& t : mesh.triangles) {
    if (random() % 2 == 0) {
      std::swap(t[1], t[2]);
    }
  }
  return mesh;
}

TriMesh random_prism(std::uint32_t segments, double low, Random& random) {
  TriMesh mesh = test::tube(2, low, low + 1, segments);
  mesh.triangles.clear();
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t next = (i + 1) % segments;
    add_polygon(mesh, {i, next, segments + next, segments + i}, random);
    bottom.push_back(segments - 1 - i);
    top.push_back(segments + i);
  }
  add_polygon(mesh, bottom, random);
  add_polygon(mesh, top, random);
  return mesh;
}

TEST(FlushShells, boxes_with_other_diagonals_in_their_common_wall_all_count) {
  TriMesh first = test::box({0, 0, 0}, {1, 1, 1}), second = test::box({1, 0, 0}, {2, 1, 1});
  for (const TriMesh& mesh :
       {joined({first, second}), joined({first, reversed(second)}),
        joined({first, reversed(test::cut_otherwise(second))}),
        joined({reversed(first), test::cut_otherwise(second)}),
        joined({first, reversed(test::cut_otherwise(second)), test::box({2, 0, 0}, {3, 1, 1})})}) {
    EXPECT_EQ(repaired_volume(mesh) * 12, mesh.triangles.size());
  }
}

TEST(FlushShells, cells_of_a_grid_all_count_whichever_are_inside_out) {
  Random random(27);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    const std::vector<TriMesh> cells = random_cells(random, round % 10 == 0 ? 20 : 5);
    EXPECT_EQ(repaired_volume(some_reversed(cells, random)), cells.size());
  }
}

TEST(FlushShells, blocks_with_parts_of_their_sides_in_common_all_count_whichever_are_inside_out) {
  Random random(29);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    std::vector<TriMesh> meshes;
    int volume = 0;
    for (const Block& block : random_blocks(random)) {
      meshes.push_back(surface_of(block, random));
      volume += block.volume();
    }
    EXPECT_EQ(repaired_volume(some_reversed(meshes, random)), volume);
    EXPECT_EQ(repaired_volume(some_faces_turned(joined(meshes), random)), volume);
  }
}

TEST(FlushShells, prisms_end_to_end_all_count_whichever_are_inside_out) {
  Random random(28);
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE(round);
    std::vector<TriMesh> prisms;
    mpq_class volume = 0;
    const std::uint32_t segments = 3 + below(random, 12);
    for (int i = 0; i < 2 + round % 3; ++i) {
      prisms.push_back(random_prism(segments, i, random));
      volume += Solid::from(prisms.back()).exact_volume();
    }
    EXPECT_EQ(repaired_volume(some_reversed(prisms, random)), volume);
  }
}

TEST(FlushShells, cells_of_a_grid_all_count_whichever_faces_are_turned) {
  Random random(30);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    const std::vector<TriMesh> cells = random_cells(random, round % 10 == 0 ? 20 : 5);
    EXPECT_EQ(repaired_volume(some_faces_turned(joined(cells), random)), cells.size());
  }
}

}  // namespace
}  // namespace dupin
