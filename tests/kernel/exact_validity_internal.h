#pragma once

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <CGAL/box_intersection_d.h>

#include "arrangement/arrange.h"
#include "arrangement/triangle_intersection.h"
#include "mesh/exact_mesh.h"

namespace dupin::test {

// Triangles of the mesh that meet outside of common corners, on exact coordinates.
inline std::size_t self_intersections(const mesh::ExactMesh& mesh) {
  const arrangement::UpwardRounding rounding;
  const mesh::ExactMesh* operand = &mesh;
  const arrangement::ArrangementInput input =
      arrangement::load_operands({&operand, 1}, arrangement::union_rule(1));
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
  std::vector<Box> boxes;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    CGAL::Bbox_3 box;
    for (const std::uint32_t corner : mesh.triangles[t]) {
      const Vec3& p = mesh.points[corner];
      box += CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
    }
    boxes.emplace_back(box, t);
  }
  std::vector<arrangement::TriangleIntersection> intersections;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    arrangement::intersect(input, a.info(), b.info(), intersections);
  });
  return intersections.size();
}

// Every directed edge once, and its reverse once.
inline bool is_closed_manifold(const mesh::ExactMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!edges.emplace(t[i], t[(i + 1) % 3]).second) {
        return false;
      }
    }
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.count({e.second, e.first}) == 1;
  });
}

}  // namespace dupin::test
