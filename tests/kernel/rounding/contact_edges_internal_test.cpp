#include <vector>

#include <gtest/gtest.h>

#include "mesh/coincident_points.h"
#include "rounding/contact_edges.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

constexpr std::uint32_t kSide = 2, kOther = 3, kTip = 4;  // 0 and 1 are ends of the edge

/// With an edge from (0, 0, 0) to (0, 0, 1) between (-2, 0) and (0, -2), and that tip behind it.
TriMesh wedge(const Vec3& tip) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 1}, {-2, 0, 0.5}, {0, -2, 0.5}, tip};
  mesh.triangles = {{0, 1, kSide},  {1, kTip, kSide},  {0, kSide, kTip},
                    {1, 0, kOther}, {0, kTip, kOther}, {1, kOther, kTip}};
  return mesh;
}

TriMesh across() {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 1}, {2, 1, 0.5}, {1, 2, 0.5}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {1, 3, 2}};
  return mesh;
}

bool stays(const TriMesh& mesh, std::uint32_t from, std::uint32_t to) {
  const std::vector<std::uint32_t> representatives = mesh::coincident_representatives(mesh.points);
  const EditedMesh edited(mesh.points, mesh.triangles, {}, representatives);
  return ContactEdges(representatives).stay(edited, from, to);
}

TEST(ContactEdges, stay_where_sheets_keep_beside_each_other) {
  EXPECT_TRUE(stays(test::joined({wedge({-2, -2, 0.5}), across()}), kSide, kTip));
  // The sheet that ends in (-2, 0) would then be between both of the other tetrahedron.
  EXPECT_FALSE(stays(test::joined({wedge({3, 3, 0.5}), across()}), kSide, kTip));
  EXPECT_TRUE(stays(wedge({3, 3, 0.5}), kSide, kTip)) << "nothing touches there";
}

TEST(ContactEdges, stay_where_their_ends_do) {
  EXPECT_FALSE(stays(test::joined({wedge({-2, -2, 0.5}), across()}), 0, kTip));
}

}  // namespace
}  // namespace dupin::rounding
