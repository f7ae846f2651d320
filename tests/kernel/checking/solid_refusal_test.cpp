#include <algorithm>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "dupin/kernel/solid.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::box;
using test::joined;
using test::labelled;
using test::reversed;
using test::tetrahedron;

using Change = std::function<void(TriMesh&)>;

TriMesh changed(TriMesh mesh, const Change& change) {
  change(mesh);
  return mesh;
}

struct Refused {
  const char* description;
  TriMesh mesh;
  Errc code;
  std::string message;
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const TriMesh kTetrahedron = tetrahedron();
const TriMesh kNamed = labelled(tetrahedron(), "elbow");

std::vector<Refused> not_meshes() {
  return {
      {"NaN", changed(kTetrahedron, [](TriMesh& m) { m.points[1].x() = kNaN; }),
       Errc::invalid_argument,
       "point 1 has coordinates that are not finite numbers: (nan, 0, 0); coordinates must be "
       "finite"},
      {"infinity", changed(kTetrahedron, [](TriMesh& m) { m.points[2].z() = -kInfinity; }),
       Errc::invalid_argument,
       "point 2 has coordinates that are not finite numbers: (0, 1, -inf); coordinates must be "
       "finite"},
      {"two bad points",
       changed(kTetrahedron,
               [](TriMesh& m) {
                 m.points[0].x() = kNaN;
                 m.points[3].y() = kInfinity;
               }),
       Errc::invalid_argument,
       "point 0 has coordinates that are not finite numbers: (nan, 0, 0) (the first of 2 such "
       "places); coordinates must be finite"},
      {"index past the end", changed(kTetrahedron, [](TriMesh& m) { m.triangles[2][1] = 4; }),
       Errc::invalid_argument,
       "face 2 refers to point 4, but there are only 4 points; indices must be below the number of "
       "points"},
      {"largest index, labelled",
       changed(kNamed, [](TriMesh& m) { m.triangles[0][0] = 0xffffffff; }), Errc::invalid_argument,
       "face 0 ('elbow') refers to point 4294967295, but there are only 4 points; indices must be "
       "below the number of points"},
      {"no points", changed(kTetrahedron, [](TriMesh& m) { m.points.clear(); }),
       Errc::invalid_argument,
       "face 0 refers to point 0, but there are only 0 points (the first of 4 such places); "
       "indices must be below the number of points"},
      {"too few labels", changed(kNamed, [](TriMesh& m) { m.labels.pop_back(); }),
       Errc::invalid_argument,
       "a mesh of 4 faces has 3 labels; there must be one for each face, or none"},
      {"label without a name", changed(kNamed, [](TriMesh& m) { m.labels[3] = 1; }),
       Errc::invalid_argument, "face 3 has label 1, but there are only 1 names"},
      {"corner given twice", changed(kTetrahedron, [](TriMesh& m) { m.triangles[1][2] = 0; }),
       Errc::invalid_argument,
       "face 1 at (0, 0, 0) has no area: its corners lie on one line; faces of a solid must have "
       "an area"},
      {"corners on one line",
       changed(kTetrahedron, [](TriMesh& m) { m.points[3] = Vec3(2, 0, 0); }),
       Errc::invalid_argument,
       "face 1 at (0, 0, 0) has no area: its corners lie on one line; faces of a solid must have "
       "an area"},
      {"corners in one place",
       changed(kTetrahedron, [](TriMesh& m) { m.points.assign(4, Vec3(1, 2, 3)); }),
       Errc::invalid_argument,
       "face 0 at (1, 2, 3) has no area: its corners lie on one line (the first of 4 such places); "
       "faces of a solid must have an area"},
      {"flat", changed(kTetrahedron, [](TriMesh& m) { m.points[3] = Vec3(1, 1, 0); }),
       Errc::self_intersecting,
       "faces 0 and 1 intersect near (0.5, 0.5, 0) (the first of 4 such places); unite the parts "
       "as separate solids instead"},
      {"the same face twice",
       changed(kNamed,
               [](TriMesh& m) {
                 m.triangles.push_back(m.triangles[1]);
                 m.labels.push_back(0);
               }),
       Errc::invalid_argument,
       "faces 1 ('elbow') and 4 ('elbow') at (0, 0, 0) have the same three corners; keep one of "
       "them, or none if they face each other"},
      {"the same mesh twice", joined({kTetrahedron, kTetrahedron}), Errc::invalid_argument,
       "faces 0 and 4 at (0, 0, 0) have the same three corners (the first of 4 such places); keep "
       "one of them, or none if they face each other"},
      {"parts glued by a face",
       joined({kTetrahedron,
               reversed(changed(kTetrahedron, [](TriMesh& m) { m.points[3].z() = -1; }))}),
       Errc::invalid_argument,
       "faces 0 and 4 at (0, 0, 0) have the same three corners; keep one of them, or none if they "
       "face each other"},
  };
}

std::vector<Refused> no_surfaces() {
  return {
      {"one face", changed(kTetrahedron, [](TriMesh& m) { m.triangles.resize(1); }),
       Errc::not_closed,
       "the edge from (0, 0, 0) to (1, 0, 0) belongs to face 0 only (the first of 3 such places); "
       "a solid needs two faces at every edge"},
      {"a face is missing",
       labelled(changed(kTetrahedron, [](TriMesh& m) { m.triangles.erase(m.triangles.begin()); }),
                "cap"),
       Errc::not_closed,
       "the edge from (0, 0, 0) to (1, 0, 0) belongs to face 0 ('cap') only (the first of 3 such "
       "places); a solid needs two faces at every edge"},
      {"a face for itself",
       joined({kTetrahedron,
               changed(tetrahedron(Vec3(5, 5, 5)), [](TriMesh& m) { m.triangles.resize(1); })}),
       Errc::not_closed,
       "the edge from (5, 5, 5) to (6, 5, 5) belongs to face 4 only (the first of 3 such places); "
       "a solid needs two faces at every edge"},
      {"a fin",
       changed(kTetrahedron,
               [](TriMesh& m) {
                 m.points.emplace_back(0, -1, -1);
                 m.triangles.push_back({0, 1, 4});
               }),
       Errc::not_closed,
       "the edge from (0, 0, 0) to (0, -1, -1) belongs to face 4 only (the first of 2 such "
       "places); a solid needs two faces at every edge"},
      {"two tetrahedra share an edge",
       changed(
           kTetrahedron,
           [](TriMesh& m) {
             m.points.insert(m.points.end(), {Vec3(-1, 0, 0), Vec3(0, -1, 0)});
             m.triangles.insert(m.triangles.end(), {{0, 5, 4}, {0, 4, 3}, {4, 5, 3}, {5, 0, 3}});
           }),
       Errc::not_manifold,
       "the edge from (0, 0, 0) to (0, 0, 1) is shared by faces 1, 3, 5 and 7; a solid needs "
       "exactly two faces at every edge; where two sheets touch, each needs vertices of its own"},
      {"two tetrahedra share a point",
       changed(joined({kTetrahedron, reversed(tetrahedron(Vec3::Zero(), -1))}),
               [](TriMesh& m) {
                 for (Triangle& corners : m.triangles) {
                   std::replace(corners.begin(), corners.end(), 4U, 0U);
                 }
               }),
       Errc::not_manifold,
       "faces 0, 1, 3, 4, 5 and 7 meet in point 0 at (0, 0, 0) but do not hang together by edges "
       "there; where two sheets touch, each needs a vertex of its own"},
      {"a face is turned",
       changed(kTetrahedron, [](TriMesh& m) { std::swap(m.triangles[2][0], m.triangles[2][1]); }),
       Errc::not_oriented,
       "faces 0 and 2 run along the edge from (1, 0, 0) to (0, 1, 0) in the same direction (the "
       "first of 3 such places); reverse the corners of one side"},
  };
}

// A tetrahedron and a double pyramid over its face in the plane x = 0, with one apex inside the
// tetrahedron: the surfaces meet in the edges of that face only, and yet cross there.
TriMesh overlap_between_edges() {
  TriMesh pyramids;
  pyramids.points = {Vec3(0, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 3), Vec3(0.5, 0.5, 0.5),
                     Vec3(-1, 1, 1)};
  pyramids.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}};
  return joined({tetrahedron(Vec3::Zero(), 3), pyramids});
}

std::vector<Refused> no_solids() {
  const std::string reverse =
      " is inside out; reverse the corners of its faces: they must run counter-clockwise seen from "
      "outside the material";
  return {
      {"inside out", reversed(kTetrahedron), Errc::not_oriented,
       "the shell of faces 0, 1, 2 and 3 at (0, 0, 0)" + reverse},
      {"inside out, labelled", labelled(reversed(kTetrahedron), "bend"), Errc::not_oriented,
       "the shell of faces 0 ('bend'), 1 ('bend'), 2 ('bend') and 3 ('bend') at (0, 0, 0)" +
           reverse},
      {"a void that is not one",
       joined({box(Vec3::Zero(), Vec3::Constant(5)), box(Vec3::Constant(1), Vec3::Constant(2))}),
       Errc::not_oriented,
       "the shell of faces 12, 13, 14, 15, 16, 17 and 6 more at (1, 1, 1)" + reverse},
      {"a void in a void",
       joined({box(Vec3::Zero(), Vec3::Constant(9)),
               reversed(box(Vec3::Constant(1), Vec3::Constant(8))),
               reversed(box(Vec3::Constant(2), Vec3::Constant(3)))}),
       Errc::not_oriented,
       "the shell of faces 24, 25, 26, 27, 28, 29 and 6 more at (2, 2, 2)" + reverse},
      {"a corner pokes through a face",
       joined({labelled(kTetrahedron, "tee"), labelled(tetrahedron(Vec3::Constant(0.25)), "run")}),
       Errc::self_intersecting,
       "faces 2 ('tee') and 4 ('run') intersect near (0.625, 0.625, 0.25) (the first of 3 such "
       "places); unite the parts as separate solids instead"},
      {"a vertex on a face",
       joined({box(Vec3::Zero(), Vec3::Constant(4)),
               changed(tetrahedron(Vec3(1, 2, 5)), [](TriMesh& m) { m.points[0].z() = 4; })}),
       Errc::self_intersecting,
       "faces 3 and 12 intersect near (1.5, 2.5, 4) (the first of 3 such places); unite the parts "
       "as separate solids instead"},
      {"an overlap whose border runs along edges of both", overlap_between_edges(),
       Errc::self_intersecting,
       "faces 0, 3, 4 and 7 intersect near (0, 1.5, 0) (the first of 3 such places); unite the "
       "parts as separate solids instead"},
  };
}

TEST(SolidFrom, refuses_with_one_clear_message) {
  std::size_t rows = 0;
  for (const auto& table : {not_meshes(), no_surfaces(), no_solids()}) {
    for (const Refused& row : table) {
      SCOPED_TRACE(row.description);
      ++rows;
      try {
        (void)Solid::from(row.mesh);
        ADD_FAILURE() << "should have thrown";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), row.code) << error.what();
        EXPECT_EQ(error.what(), row.message);
      }
    }
  }
  EXPECT_GE(rows, 20U);
}

}  // namespace
}  // namespace dupin
