#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh.h>
#include <gmpxx.h>

#include "dupin/interop/cgal_numbers.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"

/// To and from CGAL::Surface_mesh<P>, for points P of any Cartesian CGAL kernel whose numbers are
/// doubles, rationals (mpq_class, Gmpq, boost's gmp_rational) or lazy ones. Header only: the caller
/// brings CGAL. A face property map "f:label" (std::uint32_t) carries the labels where there are
/// any; their names stay with the caller.
namespace dupin::interop {

namespace interop {

// Surfaces test what they are given by assertions, if at all.
inline void require_faces(const std::vector<Triangle>& triangles,
                          const std::vector<std::uint32_t>& labels, std::size_t points) {
  if (!labels.empty() && labels.size() != triangles.size()) {
    refuse("there are " + std::to_string(labels.size()) + " labels for " +
           std::to_string(triangles.size()) + " triangles; give one for each, or none");
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    if (std::max({a, b, c}) >= points) {
      refuse("face " + std::to_string(i) + " has the corner " +
             std::to_string(std::max({a, b, c})) + ", but there are " + std::to_string(points) +
             " points");
    }
    if (a == b || b == c || c == a) {
      refuse("face " + std::to_string(i) + " has a corner twice; leave such faces out");
    }
  }
}

template <class Point>
void add_faces(CGAL::Surface_mesh<Point>& surface, const std::vector<Triangle>& triangles,
               const std::vector<std::uint32_t>& labels) {
  using Surface = CGAL::Surface_mesh<Point>;
  using Vertex = typename Surface::Vertex_index;
  require_faces(triangles, labels, surface.number_of_vertices());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    if (surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) == Surface::null_face()) {
      throw Error(Errc::not_manifold,
                  "face " + std::to_string(i) +
                      " cannot be part of a CGAL::Surface_mesh: it would make an edge of more than "
                      "two faces, or of two that disagree in orientation");
    }
  }
  if (!labels.empty()) {
    auto map =
        surface.template add_property_map<typename Surface::Face_index, std::uint32_t>("f:label")
            .first;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      map[typename Surface::Face_index(static_cast<std::uint32_t>(i))] = labels[i];
    }
  }
}

}  // namespace interop

/// Vertex i and face i are point i and triangle i. Throws Error{not_manifold} where a halfedge
/// structure cannot hold the mesh, and Error{invalid_argument} for coordinates that are not finite,
/// corners of no point, triangles with a corner twice, and labels that are not one for each.
template <class Point>
[[nodiscard]] CGAL::Surface_mesh<Point> to_surface_mesh(const TriMesh& mesh) {
  CGAL::Surface_mesh<Point> surface;
  for (const Vec3& point : mesh.points) {
    if (!point.allFinite()) {
      refuse("point " + std::to_string(surface.number_of_vertices()) +
             " has a coordinate that is not finite");
    }
    surface.add_vertex(Point(point.x(), point.y(), point.z()));
  }
  interop::add_faces(surface, mesh.triangles, mesh.labels);
  return surface;
}

/// With exact coordinates where the kernel's numbers are exact; otherwise with the nearest doubles,
/// through which the surface may cross itself (see to_mesh for a rounding that cannot).
template <class Point>
[[nodiscard]] CGAL::Surface_mesh<Point> to_surface_mesh(const Solid& solid) {
  using Number = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  CGAL::Surface_mesh<Point> surface;
  for (std::uint32_t i = 0; i < solid.point_count(); ++i) {
    if constexpr (std::is_floating_point_v<Number>) {
      const Vec3& point = solid.nearest_points()[i];
      surface.add_vertex(Point(point.x(), point.y(), point.z()));
    } else {
      const auto [x, y, z] = solid.exact_point(i);
      surface.add_vertex(Point(number<Number>(x), number<Number>(y), number<Number>(z)));
    }
  }
  interop::add_faces(surface, solid.triangles(), solid.labels());
  return surface;
}

/// The vertices and faces in the surface's order, removed ones skipped; give it to Solid::from for
/// a solid. Labels are taken if there are `names`. Throws Error{invalid_argument} where a
/// coordinate is no double, a face no triangle, or a label has no name.
template <class Point>
[[nodiscard]] TriMesh to_tri_mesh(const CGAL::Surface_mesh<Point>& surface,
                                  const std::vector<std::string>& names = {}) {
  using Surface = CGAL::Surface_mesh<Point>;
  TriMesh mesh;
  mesh.names = names;
  std::vector<std::uint32_t> indices(surface.num_vertices());
  for (const auto vertex : surface.vertices()) {
    indices[vertex] = static_cast<std::uint32_t>(mesh.points.size());
    Vec3& point = mesh.points.emplace_back();
    const auto& place = surface.point(vertex);
    if (!has_value(place.x()) || !has_value(place.y()) || !has_value(place.z())) {
      refuse("vertex " + std::to_string(indices[vertex]) + " has a coordinate that is not finite");
    }
    const auto exact = rational_coordinates(place);
    for (int k = 0; k < 3; ++k) {
      point[k] = exact[k].get_d();
      if (mpq_class(point[k]) != exact[k]) {
        refuse("vertex " + std::to_string(indices[vertex]) +
               " has a coordinate that no double holds; round the surface first");
      }
    }
  }
  const auto labels =
      surface.template property_map<typename Surface::Face_index, std::uint32_t>("f:label");
  for (const auto face : surface.faces()) {
    const auto first = surface.halfedge(face);
    const auto second = surface.next(first), third = surface.next(second);
    if (surface.next(third) != first) {
      refuse("face " + std::to_string(mesh.triangles.size()) + " is not a triangle");
    }
    mesh.triangles.push_back({indices[surface.source(first)], indices[surface.source(second)],
                              indices[surface.source(third)]});
    if (labels.second && !names.empty()) {
      if (labels.first[face] >= names.size()) {
        refuse("face " + std::to_string(mesh.triangles.size() - 1) + " has the label " +
               std::to_string(labels.first[face]) + ", but there are " +
               std::to_string(names.size()) + " names");
      }
      mesh.labels.push_back(labels.first[face]);
    }
  }
  return mesh;
}

}  // namespace dupin::interop
