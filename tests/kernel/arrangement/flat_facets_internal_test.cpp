#include <array>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "arrangement/flat_facets.h"
#include "arrangement/intersection_points.h"
#include "kernel/arrangement/stages_internal.h"
#include "kernel/exact_validity_internal.h"
#include "support/grid_solids.h"

namespace dupin::arrangement {
namespace {

// Of a bar's four sides, which stand on a triangulated square, one by one.
FlatFacets facets_of(test::Stages& stages) {
  return create_intersection_points(stages.input, stages.intersections()).facets;
}

std::size_t count(const test::Stages& stages, const FlatFacets& facets) {
  std::size_t pairs = 0;
  for (std::uint32_t t = 0; t < stages.input.triangles.size(); ++t) {
    pairs += facets.mate(t) != kNone && t < facets.mate(t) ? 1 : 0;
  }
  return pairs;
}

// A plate on the plane z = 0 with corners 0 to 3 above, in two triangles, the first by `diagonal`.
TriMesh plate(const std::array<Vec3, 4>& top, std::size_t diagonal) {
  TriMesh mesh;
  for (const Vec3& p : top) {
    mesh.points.push_back(p);
  }
  for (const Vec3& p : top) {
    mesh.points.emplace_back(p.x(), p.y(), -8);
  }
  const auto corner = [diagonal](std::size_t i) {
    return static_cast<std::uint32_t>((diagonal + i) % 4);
  };
  mesh.triangles = {{corner(0), corner(1), corner(2)},
                    {corner(0), corner(2), corner(3)},
                    {corner(2) + 4, corner(1) + 4, corner(0) + 4},
                    {corner(3) + 4, corner(2) + 4, corner(0) + 4}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    mesh.triangles.push_back({i + 4, next + 4, next});
    mesh.triangles.push_back({i + 4, next, i});
  }
  return mesh;
}

const std::array<Vec3, 4> kSquare{Vec3(0, 0, 0), Vec3(8, 0, 0), Vec3(8, 8, 0), Vec3(0, 8, 0)};
// It crosses both diagonals of the square, and nothing else.
const TriMesh kBar = test::box({3, 3, -1}, {5, 5.5, 1});

TEST(FlatFacets, are_joined_where_others_cross_the_edge_between) {
  for (const std::size_t diagonal : {0U, 1U}) {
    test::Stages stages({plate(kSquare, diagonal), kBar});
    const FlatFacets facets = facets_of(stages);
    ASSERT_FALSE(facets.empty());
    EXPECT_EQ(facets.mate(0), 1U);
    EXPECT_EQ(facets.of(1), 0U);
    const FlatFacets::Corners corners = facets.corners(stages.input, 0);
    ASSERT_EQ(corners.count, 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto turned = stages.area_vector(
          {corners[i], corners[corners.after(i)], corners[corners.after(corners.after(i))]});
      EXPECT_GT(turned[2], 0);
      EXPECT_EQ(corners.before(corners.after(i)), i);
    }
    EXPECT_EQ(facets.mate(4), kNone) << "nothing meets this side";
    EXPECT_EQ(facets.corners(stages.input, 4).count, 3U);
  }
}

TEST(FlatFacets, leave_nothing_of_the_edge_between) {
  const std::vector<Solid> solids = test::solids_of({plate(kSquare, 0), kBar});
  const Solid united = test::arranged(solids, union_rule(2));
  // The rectangle of the bar's sides, and no place on the diagonal.
  EXPECT_EQ(united.exact().points.size(), 8U + 8U + 4U - 4U)
      << "the bar's lower corners are inside";
  EXPECT_TRUE(test::is_closed_manifold(united.exact()));
}

TEST(FlatFacets, are_in_one_plane_about_their_longest_edge_and_under_one_label) {
  const auto joins = [](const TriMesh& mesh, const TriMesh& other = kBar) {
    test::Stages stages({mesh, other});
    return facets_of(stages).mate(0) != kNone;
  };
  const auto with_corner = [](const Vec3& corner) {
    std::array<Vec3, 4> corners = kSquare;
    corners[2] = corner;
    return plate(corners, 1);  // from corner 1 to 3
  };
  EXPECT_TRUE(joins(with_corner({8, 8, 0})));
  EXPECT_FALSE(joins(with_corner({8, 8, 0x1p-190}))) << "a little out of the plane";
  EXPECT_FALSE(joins(with_corner({16, 8, 0}))) << "another edge is longer";
  EXPECT_FALSE(joins(with_corner({8, 16, 0})));
  EXPECT_TRUE(joins(with_corner({8.5, 7, 0})));

  TriMesh labelled = plate(kSquare, 0);
  labelled.names = {"one", "two"};
  labelled.labels.assign(labelled.triangles.size(), 1);
  EXPECT_TRUE(joins(labelled));
  labelled.labels[0] = 0;
  EXPECT_FALSE(joins(labelled));

  EXPECT_TRUE(joins(plate(kSquare, 0), test::box({3, 3, 0}, {5, 5.5, 1})))
      << "it stands on the plane";
  EXPECT_FALSE(joins(plate(kSquare, 0), plate(kSquare, 0))) << "copies";
  EXPECT_FALSE(joins(plate(kSquare, 0), test::box({3, 0.25, -1}, {5, 1, 1})))
      << "the edge between is not met";
}

// Whatever stands at the edge between: corners and edges of the other on it, or along it.
TEST(FlatFacets, make_no_difference) {
  // With a label for each triangle no two are joined.
  const auto apart = [](TriMesh mesh) {
    mesh.labels.clear();
    mesh.names.clear();
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      mesh.labels.push_back(t);
      mesh.names.push_back("t" + std::to_string(t));
    }
    return mesh;
  };
  std::size_t joined = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(777 + seed);
    std::vector<TriMesh> meshes;
    for (int i = 0; i < 3; ++i) {
      const Solid solid = test::random_grid_solid(random);
      meshes.push_back({solid.exact().points, solid.exact().triangles, {}, {}});
    }
    test::Stages stages(meshes);
    joined += count(stages, facets_of(stages));
    std::vector<TriMesh> triangles;
    for (const TriMesh& mesh : meshes) {
      triangles.push_back(apart(mesh));
    }
    const BooleanRule odd{{0, 1, 2}, 3, [](std::span<const int> counts) {
                            return (counts[0] + counts[1] + counts[2]) % 2 == 1;
                          }};
    for (const BooleanRule& rule : {union_rule(3), difference_rule(3), odd}) {
      const Solid one = test::arranged(test::solids_of(meshes), rule);
      const Solid other = test::arranged(test::solids_of(triangles), rule);
      EXPECT_TRUE(test::is_closed_manifold(one.exact()));
      EXPECT_EQ(test::self_intersections(one.exact()), 0U);
      EXPECT_LE(one.exact().triangles.size(), other.exact().triangles.size());
      EXPECT_EQ(one.exact_volume(), other.exact_volume());
      EXPECT_EQ(test::arranged({one, other}, difference_rule(2)).exact_volume(), 0);
      EXPECT_EQ(test::arranged({other, one}, difference_rule(2)).exact_volume(), 0);
    }
  }
  EXPECT_GT(joined, 600U);
}

}  // namespace
}  // namespace dupin::arrangement
