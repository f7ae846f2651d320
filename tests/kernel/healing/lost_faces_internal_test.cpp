#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "dupin/kernel/solid.h"
#include "healing/lost_faces.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

using test::box;
using test::joined;

PolygonSoup soup_of(const TriMesh& mesh) { return merge_duplicate_points(mesh).soup; }

// Of the mesh, only the first box is in the solid.
void look_for_lost(const TriMesh& mesh, std::size_t cavity_begin = 1000) {
  KnownFaces known{std::vector<std::uint8_t>(mesh.triangles.size(), 0), false};
  for (std::size_t i = cavity_begin; i < known.is_of_cavity.size(); ++i) {
    known.is_of_cavity[i] = 1;
  }
  const TriMesh kept = box({0, 0, 0}, {2, 2, 2});
  PolygonSoup settled = soup_of(kept);
  (void)add_or_refuse_lost(soup_of(mesh), settled, Solid::from(kept).exact(), known, false);
}

TEST(LostFaces, a_body_outside_is_lost_and_one_inside_is_not) {
  const TriMesh kept = box({0, 0, 0}, {2, 2, 2});
  const TriMesh outside = box({3, 0, 0}, {4, 1, 1}), flush = box({2, 0, 0}, {3, 1, 1});
  EXPECT_NO_THROW(look_for_lost(joined({kept, kept, box({0, 0, 0}, {1, 1, 1})})));
  for (const TriMesh& lost : {outside, flush}) {
    EXPECT_THROW(look_for_lost(joined({kept, lost})), Error);
    EXPECT_THROW(look_for_lost(joined({kept, lost, lost})), Error);
  }
  EXPECT_NO_THROW(look_for_lost(joined({kept, outside}), 12));
}

TEST(LostFaces, sheets_bound_nothing) {
  TriMesh sheet;
  sheet.points = {{5, 0, 0}, {6, 0, 0}, {6, 1, 0}, {5, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}};
  EXPECT_NO_THROW(look_for_lost(joined({box({0, 0, 0}, {2, 2, 2}), sheet})));
}

TEST(LostFaces, are_named) {
  try {
    look_for_lost(joined({box({0, 0, 0}, {2, 2, 2}), box({3, 0, 0}, {4, 1, 1})}));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::not_oriented);
    EXPECT_NE(std::string(error.what()).find("12 faces"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace dupin::healing
