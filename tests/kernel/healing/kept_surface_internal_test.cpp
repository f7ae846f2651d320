#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/mesh.h"
#include "healing/kept_surface.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

using test::box;
using test::joined;
using test::reversed;

TriMesh cube(double low, double high) { return box(Vec3::Constant(low), Vec3::Constant(high)); }

TriMesh tetrahedron(std::vector<Vec3> points) {
  return {std::move(points), {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, {}, {}};
}

struct Row {
  const char* name;
  TriMesh mesh;
  bool is_kept;
};

std::vector<Row> rows() {
  const TriMesh whole = cube(0, 2);
  return {
      {"nothing", {}, true},
      {"alone", whole, true},
      {"apart", joined({whole, cube(4, 5)}), true},
      {"a void", joined({cube(0, 5), reversed(cube(1, 2))}), true},
      {"a common point", joined({whole, cube(2, 3)}), true},
      {"a common edge", joined({whole, box({2, 2, 0}, {3, 3, 2})}), true},
      {"a part of an edge in common", joined({whole, box({2, 2, 0.25}, {3, 3, 1.75})}), true},
      {"a corner on a face",
       joined({whole, tetrahedron({{1, 1, 2}, {2, 1, 3}, {1, 2, 3}, {1, 1, 3}})}), true},
      {"edges across each other, in a place that no double is",
       joined({whole, tetrahedron({{1, 5, 0.1}, {2.5, 0.5, 0.9}, {5, 5, 0}, {5, 5, 2}})}), true},
      {"one in the other", joined({cube(0, 5), cube(1, 2)}), false},
      {"through each other", joined({whole, cube(1, 3)}), false},
      {"through each other by 1e-13", joined({whole, cube(2 - 0x1p-43, 3)}), false},
      {"walls in common", joined({whole, box({2, 0.5, 0.5}, {3, 1, 1})}), false},
      {"the same twice", joined({whole, whole}), false},
      {"inside out", reversed(whole), false},
  };
}

TEST(KeptSurface, is_what_crosses_covers_and_encloses_nothing) {
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.name);
    const PolygonSoup soup = merge_duplicate_points(row.mesh).soup;
    EXPECT_EQ(keeps_surface(wound_around(soup, row.mesh), soup), row.is_kept);
  }
}

}  // namespace
}  // namespace dupin::healing
