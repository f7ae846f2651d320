#pragma once

#include <string>
#include <vector>

#include "dupin/io/streamed_format.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/solid.h"
#include "support/shapes.h"

namespace dupin::test {

/// Solids in boxes of their own, rounded, and with labels where a name is not empty.
struct Pieces {
  explicit Pieces(const std::vector<std::string>& names, Coordinates coordinates) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Vec3 place(10.0 * static_cast<double>(i), .1, .2);
      const TriMesh mesh = i % 2 == 0 ? tetrahedron(place, 1) : box(place, place + Vec3::Ones());
      rounded.push_back(
          to_mesh(Solid::from(names[i].empty() ? mesh : labelled(mesh, names[i])), coordinates));
      boxes.push_back({{place - Vec3::Ones(), place + Vec3::Constant(2)}});
    }
  }
  [[nodiscard]] TriMesh all() const { return joined(rounded, boxes).mesh(); }

  std::vector<Rounded> rounded;
  std::vector<Boxes> boxes;
};

/// A bar along x, of square section, whose side has the name; the end at one of its ends is "end".
inline TriMesh bar(double from, double to, const std::string& name, bool ends_at_start) {
  TriMesh mesh;
  mesh.names = {name, "end"};
  for (const double x : {from, to}) {
    for (const Vec3& corner : {Vec3(x, 0, 0), Vec3(x, 1, 0), Vec3(x, 1, 1), Vec3(x, 0, 1)}) {
      mesh.points.push_back(corner);
    }
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    mesh.triangles.insert(mesh.triangles.end(), {{i, j, j + 4}, {i, j + 4, i + 4}});
  }
  mesh.triangles.insert(mesh.triangles.end(), {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}});
  mesh.labels.assign(12, 0);
  const std::size_t end = ends_at_start ? 8 : 10;
  mesh.labels[end] = mesh.labels[end + 1] = 1;
  return mesh;
}

/// Two of them, without the ends between them.
inline TriMesh two_bars() {
  TriMesh whole = bar(0, 1, "a", false);
  const TriMesh other = bar(1, 3, "b", true);
  whole.names = {"a", "b"};
  whole.points.insert(whole.points.end(), other.points.begin() + 4, other.points.end());
  whole.triangles.resize(10);
  whole.labels.resize(10);
  for (std::size_t i = 0; i < other.triangles.size(); ++i) {
    if (other.labels[i] == 0) {
      const auto& [a, b, c] = other.triangles[i];
      whole.triangles.push_back({a + 4, b + 4, c + 4});
      whole.labels.push_back(1);
    }
  }
  return whole;
}

/// Names of labels, for all kinds of company.
inline const std::vector<std::vector<std::string>> kCompanies = {
    {"a", "b", "c"}, {"a"}, {"a", "a"}, {}, {"", ""}, {"a", "", "b.start", "a"}, {""}};

}  // namespace dupin::test
