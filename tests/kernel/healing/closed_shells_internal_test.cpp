#include <gtest/gtest.h>

#include "healing/closed_shells.h"
#include "kernel/healing/soups_internal.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

using test::joined;
using test::reversed;

std::size_t shells_of(const TriMesh& mesh) {
  const PolygonSoup soup = merge_duplicate_points(mesh).soup;
  return closed_shells(soup.points, soup.triangles).shells.count;
}

// Over and under one base, and two over it of which one is within the other.
const TriMesh kOver = test::tetrahedron({0, 0, 0}, 2);
TriMesh with_apex(const Vec3& apex) {
  TriMesh mesh = kOver;
  mesh.points[3] = apex;
  return mesh;
}
const TriMesh kUnder = reversed(with_apex({0, 0, -2})), kWithin = with_apex({0, 0, 1});

TEST(ClosedShells, a_shared_face_belongs_to_both) {
  EXPECT_EQ(shells_of(kOver), 1U);
  for (const TriMesh& other : {kUnder, kWithin}) {
    EXPECT_EQ(shells_of(joined({kOver, other})), 2U);
    EXPECT_EQ(shells_of(joined({kOver, reversed(other)})), 2U);
  }
}

TEST(ClosedShells, boxes_around_an_edge_are_apart_whichever_is_inside_out) {
  const TriMesh first = test::box({0, 0, 0}, {1, 1, 1}), second = test::box({1, 1, 0}, {2, 2, 1});
  EXPECT_EQ(shells_of(joined({first, second})), 2U);
  EXPECT_EQ(shells_of(joined({first, reversed(second)})), 2U);
  EXPECT_EQ(shells_of(joined({reversed(first), reversed(second)})), 2U);
}

TEST(ClosedShells, frames_that_touch_in_an_edge_are_two) {
  TriMesh mesh = test::frame();
  EXPECT_EQ(shells_of(mesh), 1U);
  EXPECT_EQ(shells_of(joined({mesh, test::moved(mesh, Vec3(6, 6, 0))})), 2U);
}

}  // namespace
}  // namespace dupin::healing
