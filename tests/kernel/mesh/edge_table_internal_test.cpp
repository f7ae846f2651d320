#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "mesh/edge_table.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

using Ends = std::array<std::uint32_t, 2>;

std::vector<Triangle> random_triangles(std::mt19937& random, std::uint32_t points, int count) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    std::set<std::uint32_t> corners;
    while (corners.size() < 3) {
      corners.insert(static_cast<std::uint32_t>(random() % points));
    }
    Triangle t;
    std::copy(corners.begin(), corners.end(), t.begin());
    std::shuffle(t.begin(), t.end(), random);
    triangles.push_back(t);
  }
  return triangles;
}

std::map<Ends, std::vector<std::uint32_t>> edges_of(const std::vector<Triangle>& triangles) {
  std::map<Ends, std::vector<std::uint32_t>> edges;
  for (std::uint32_t h = 0; h < 3 * triangles.size(); ++h) {
    const std::uint32_t from = triangles[h / 3][h % 3], to = triangles[h / 3][(h + 1) % 3];
    edges[{std::min(from, to), std::max(from, to)}].push_back(h);
  }
  return edges;
}

TEST(EdgeTable, lists_all_half_edges_by_their_ends) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    const std::vector<Triangle> triangles = random_triangles(random, 9, round);
    const EdgeTable table(triangles, 9);
    const auto expected = edges_of(triangles);
    ASSERT_EQ(table.size(), expected.size());
    std::size_t i = 0;
    for (const auto& [ends, half_edges] : expected) {
      const Edge edge = table[i++];
      EXPECT_EQ((Ends{edge.low, edge.high}), ends);
      EXPECT_TRUE(std::ranges::equal(edge.half_edges, half_edges));
      for (const std::uint32_t h : edge.half_edges) {
        EXPECT_EQ(table.origin(h), triangles[h / 3][h % 3]);
        EXPECT_EQ(table.target(h), triangles[h / 3][(h + 1) % 3]);
      }
    }
  }
}

// The lowest item that a chain of relations leads to, by spreading it.
template <class Related>
std::vector<std::uint32_t> lowest_related(std::uint32_t count, const Related& related) {
  std::vector<std::uint32_t> lowest(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    lowest[i] = i;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t k = 0; k < count; ++k) {
        if (lowest[k] < lowest[i] && related(i, k)) {
          lowest[i] = lowest[k];
          changed = true;
        }
      }
    }
  }
  return lowest;
}

TEST(EdgeTable, fans_and_shells_hang_together_by_edges) {
  std::mt19937 random(2);
  for (int round = 0; round < 30; ++round) {
    const std::vector<Triangle> triangles = random_triangles(random, 14, 3 + round % 12);
    const auto count = static_cast<std::uint32_t>(triangles.size());
    const auto common = [&](std::uint32_t f, std::uint32_t g) {
      return std::ranges::count_if(triangles[f], [&](std::uint32_t p) {
        return std::ranges::find(triangles[g], p) != triangles[g].end();
      });
    };
    const EdgeTable table(triangles, 14);
    const auto same_fan = [&](std::uint32_t c, std::uint32_t d) {
      return triangles[c / 3][c % 3] == triangles[d / 3][d % 3] && common(c / 3, d / 3) >= 2;
    };
    EXPECT_EQ(corner_fans(triangles, table), lowest_related(3 * count, same_fan));
    const std::vector<std::uint32_t> lowest =
        lowest_related(count, [&](std::uint32_t f, std::uint32_t g) { return common(f, g) >= 2; });
    const Shells found = shells(count, table);
    EXPECT_EQ(found.count, std::set(lowest.begin(), lowest.end()).size());
    for (std::uint32_t f = 0; f < count; ++f) {
      const auto faces = found.faces_of(found.of_face[f]);
      EXPECT_EQ(faces.front(), lowest[f]);
      EXPECT_TRUE(std::ranges::binary_search(faces, f));
    }
  }
}

TEST(EdgeTable, euler_numbers_tell_the_genus) {
  const TriMesh both = test::joined({test::frame(), test::tetrahedron({9, 9, 9})});
  const EdgeTable table(both.triangles, both.points.size());
  const Shells found = shells(both.triangles.size(), table);
  EXPECT_EQ(euler_numbers(found, table, corner_fans(both.triangles, table)),
            (std::vector<std::int64_t>{0, 2}));
}

TEST(EdgeTable, euler_numbers_count_a_point_of_two_fans_twice) {
  TriMesh mesh = test::joined({test::tetrahedron(), test::tetrahedron({0, 0, 0}, -1)});
  for (Triangle& t : mesh.triangles) {
    std::ranges::replace(t, 4U, 0U);
  }
  const EdgeTable table(mesh.triangles, mesh.points.size());
  const Shells found = shells(mesh.triangles.size(), table);
  EXPECT_EQ(found.count, 2U);
  EXPECT_EQ(euler_numbers(found, table, corner_fans(mesh.triangles, table)),
            (std::vector<std::int64_t>{2, 2}));
}

}  // namespace
}  // namespace dupin::mesh
