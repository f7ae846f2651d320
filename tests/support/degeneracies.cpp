#include "support/degeneracies.h"

#include <algorithm>

#include "support/shapes.h"

namespace dupin::test {
namespace {

const ExpectedSolid kNothing{"0", 0, 0, 0};

TriMesh cube(double x, double y, double z, double size) {
  return box({x, y, z}, {x + size, y + size, z + size});
}

// A prism along z over a convex polygon; each end a fan about its corner `apex`, or about `middle`
// if there is one.
TriMesh prism(const std::vector<Vec3>& outline, double low, double high, std::uint32_t apex,
              const Vec3* middle = nullptr) {
  TriMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const double z : {low, high}) {
    for (const Vec3& p : outline) {
      mesh.points.emplace_back(p.x(), p.y(), z);
    }
  }
  if (middle != nullptr) {
    mesh.points.emplace_back(middle->x(), middle->y(), low);
    mesh.points.emplace_back(middle->x(), middle->y(), high);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
    if (middle != nullptr) {
      mesh.triangles.push_back({2 * n, j, i});
      mesh.triangles.push_back({2 * n + 1, n + i, n + j});
    } else if (i != apex && j != apex) {
      mesh.triangles.push_back({apex, j, i});
      mesh.triangles.push_back({n + apex, n + i, n + j});
    }
  }
  return mesh;
}

// |y| + |z| <= 1 along x from -3 to 3.
TriMesh diamond_bar() {
  TriMesh mesh = prism({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, -3, 3, 0);
  for (Vec3& p : mesh.points) {
    p = Vec3(p.z(), p.x(), p.y());
  }
  return mesh;
}

TriMesh turned_about_z(TriMesh mesh) {
  for (Vec3& p : mesh.points) {
    p = Vec3(-p.y(), p.x(), p.z());
  }
  return mesh;
}

// Upside down: half as wide as high above its tip in the origin, 3 high.
TriMesh funnel() {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {3, 3, 3}, {-3, 3, 3}, {-3, -3, 3}, {3, -3, 3}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {1, 2, 3}, {1, 3, 4}};
  return mesh;
}

// An edge from (0, 0, 0) to (4, 0, 0) and a roof upside down above it.
TriMesh keel() {
  TriMesh mesh = prism({{0, 0, 0}, {1, 2, 0}, {-1, 2, 0}}, 0, 4, 0);
  for (Vec3& p : mesh.points) {
    p = Vec3(p.z(), p.x(), p.y());
  }
  return mesh;
}

const std::vector<Vec3> kOctagon = {{3, 1, 0},   {1, 3, 0},   {-1, 3, 0}, {-3, 1, 0},
                                    {-3, -1, 0}, {-1, -3, 0}, {1, -3, 0}, {3, -1, 0}};

// Pyramids over the squares of a checkerboard, all with their tips in the origin: `count`^2 / 2.
std::vector<TriMesh> pyramids_with_one_tip(int count) {
  std::vector<TriMesh> all;
  for (int i = 0; i < count; ++i) {
    for (int j = i % 2; j < count; j += 2) {
      TriMesh mesh;
      mesh.points = {{0, 0, 0},
                     Vec3(i, j, count),
                     Vec3(i + 1, j, count),
                     Vec3(i + 1, j + 1, count),
                     Vec3(i, j + 1, count)};
      mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {1, 2, 3}, {1, 3, 4}};
      all.push_back(mesh);
    }
  }
  return all;
}

Degeneracy row(std::string name, const std::vector<TriMesh>& meshes, ExpectedSolid united,
               ExpectedSolid common, ExpectedSolid difference, std::size_t points,
               std::size_t triangles) {
  std::vector<Solid> operands;
  for (const TriMesh& mesh : meshes) {
    operands.push_back(Solid::from(mesh));
  }
  return {std::move(name),   std::move(operands),   std::move(united),
          std::move(common), std::move(difference), points,
          triangles};
}

}  // namespace

std::vector<Degeneracy> degeneracies() {
  const Vec3 centre(0, 0, 0), aside(1, -1, 0);
  const TriMesh octagon = prism(kOctagon, 0, 4, 0);
  return {
      row("same", {cube(0, 0, 0, 2), cube(0, 0, 0, 2)}, {"8"}, {"8"}, kNothing, 8, 12),
      row("same_cut_otherwise", {cube(0, 0, 0, 2), cut_otherwise(cube(0, 0, 0, 2))}, {"8"}, {"8"},
          kNothing, 8, 12),
      row("nested", {cube(0, 0, 0, 4), cube(1, 1, 1, 2)}, {"64"}, {"8"}, {"56"}, 8, 12),
      row("face_on_face_cut_otherwise", {cube(0, 0, 0, 2), cut_otherwise(cube(2, 0, 0, 2))}, {"16"},
          kNothing, {"8"}, 12, 20),
      row("face_in_face", {cube(0, 0, 0, 4), cube(4, 1, 1, 2)}, {"72"}, kNothing, {"64"}, 16, 28),
      row("face_across_face", {cube(0, 0, 0, 2), cube(2, 1, 1, 2)}, {"16"}, kNothing, {"8"}, 18,
          32),
      row("face_under_face", {cube(0, 0, 0, 4), cube(2, 1, 1, 2)}, {"64"}, {"8"}, {"56"}, 12, 20),
      row("faces_in_one_plane", {cube(0, 0, 0, 2), cut_otherwise(cube(1, 1, 0, 2))}, {"14"}, {"2"},
          {"6"}, 20, 36),
      row("vertex_on_face", {box({-2, -2, -2}, {2, 2, 0}), funnel()}, {"68", 2, 0, 1}, kNothing,
          {"32"}, 14, 20),
      row("vertex_on_edge", {box({-2, 0, -2}, {2, 2, 0}), moved(funnel(), Vec3(0, 0, 0))},
          {"52", 2, 0, 1}, kNothing, {"16"}, 14, 20),
      row("vertex_on_vertex", {cube(0, 0, 0, 2), cube(2, 2, 2, 2)}, {"16", 2, 0, 1}, kNothing,
          {"8"}, 16, 24),
      row("vertex_on_face_from_inside", {box({-4, -4, 0}, {4, 4, 4}), funnel()}, {"256"}, {"36"},
          {"220", 1, 0, 1}, 9, 14),
      row("edge_on_face", {box({-1, -3, -2}, {5, 3, 0}), keel()}, {"80", 2, 0, 1}, kNothing, {"72"},
          16, 24),
      row("edge_across_face", {box({1, -3, -2}, {3, 3, 0}), keel()}, {"32", 2, 0, 1}, kNothing,
          {"24"}, 18, 28),
      row("edge_on_edge", {cube(0, 0, 0, 2), cube(2, 2, 0, 2)}, {"16", 2, 0, 1}, kNothing, {"8"},
          16, 24),
      row("edges_overlapping", {cube(0, 0, 0, 2), cube(2, 2, 1, 2)}, {"16", 2, 0, 1}, kNothing,
          {"8"}, 18, 28),
      row("edge_through_edge", {diamond_bar(), turned_about_z(diamond_bar())}, {"64/3"}, {"8/3"},
          {"28/3", 2, 0, 2}, 22, 40),
      row("edges_through_edges_in_one_plane",
          {box({-3, -1, -1}, {3, 1, 1}), box({-1, -3, -1}, {1, 3, 1})}, {"40"}, {"8"},
          {"16", 2, 0, 0}, 24, 44),
      row("touching_along_a_curve", {frame(), funnel()}, {"100", 2, 1, 4}, kNothing,
          {"64", 1, 1, 0}, 25, 46),
      row("coaxial_prisms", {octagon, prism(kOctagon, 2, 7, 0)}, {"196"}, {"56"}, {"56"}, 32, 60),
      row("coaxial_prisms_cut_otherwise", {octagon, prism(kOctagon, 2, 7, 3)}, {"196"}, {"56"},
          {"56"}, 32, 60),
      row("ends_cut_otherwise",
          {prism(kOctagon, 0, 4, 0, &centre), prism(kOctagon, 4, 7, 0, &aside)}, {"196"}, kNothing,
          {"112"}, 26, 48),
      row("one_end_inside_the_other", {octagon, prism({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, 4, 6, 0)},
          {"114"}, kNothing, {"112"}, 22, 40),
      row("hundreds_with_one_tip", pyramids_with_one_tip(20), {"4000/3", 200, 0, 361}, kNothing,
          {"20/3"}, 1000, 1200),
  };
}

}  // namespace dupin::test
