#include "cross_check/surface_mesh.h"

#include <algorithm>
#include <string>

#include "dupin/interop/cgal.h"
#include "exact/exact_numbers.h"
#include "mesh/edge_table.h"
#include "mesh/self_contact.h"

namespace dupin::cross_check {
namespace {

mesh::ExactPoint homogeneous(const std::array<mpq_class, 3>& point) {
  mpz_class weight = lcm(lcm(point[0].get_den(), point[1].get_den()), point[2].get_den());
  const auto scaled = [&](const mpq_class& x) {
    return exact::integer(x.get_num() * (weight / x.get_den()));
  };
  return {scaled(point[0]), scaled(point[1]), scaled(point[2]), exact::integer(weight)};
}

bool is_double(const mpq_class& value) { return mpq_class(exact::nearest_double(value)) == value; }

// Points of doubles first, the order kept otherwise; `indices` are by vertex.
void take_points(const Surface& surface, mesh::ExactMesh& mesh,
                 std::vector<std::uint32_t>& indices) {
  indices.resize(surface.number_of_vertices() + surface.number_of_removed_vertices());
  std::vector<Surface::Vertex_index> implicit;
  for (const Surface::Vertex_index vertex : surface.vertices()) {
    const auto point = interop::rational_coordinates(surface.point(vertex));
    if (std::all_of(point.begin(), point.end(), is_double)) {
      indices[vertex] = static_cast<std::uint32_t>(mesh.points.size());
      mesh.points.emplace_back(point[0].get_d(), point[1].get_d(), point[2].get_d());
    } else {
      implicit.push_back(vertex);
    }
  }
  for (const Surface::Vertex_index vertex : implicit) {
    const auto point = interop::rational_coordinates(surface.point(vertex));
    indices[vertex] = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.emplace_back(exact::nearest_double(point[0]), exact::nearest_double(point[1]),
                             exact::nearest_double(point[2]));
    mesh.implicit.push_back(homogeneous(point));
  }
}

bool has_two_faces_at_each_edge(const mesh::ExactMesh& mesh) {
  const mesh::EdgeTable edges(mesh.triangles, mesh.points.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto along = edges[i].half_edges;
    if (along.size() != 2 || edges.origin(along[0]) == edges.origin(along[1])) {
      return false;
    }
  }
  return true;
}

}  // namespace

Surface surface_mesh(const mesh::ExactMesh& mesh) {
  const mesh::MeshView view(mesh);
  Surface surface;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    const mesh::ExactPoint point = view.exact(i);
    const mpq_class weight = exact::rational(point[3]);
    const auto coordinate = [&](std::size_t k) {
      return interop::number<Kernel::FT>(exact::rational(point[k]) / weight);
    };
    const Vec3& nearest = mesh.points[i];
    surface.add_vertex(i < mesh.double_count()
                           ? Kernel::Point_3(nearest.x(), nearest.y(), nearest.z())
                           : Kernel::Point_3(coordinate(0), coordinate(1), coordinate(2)));
  }
  for (const Triangle& t : mesh.triangles) {
    surface.add_face(Surface::Vertex_index(t[0]), Surface::Vertex_index(t[1]),
                     Surface::Vertex_index(t[2]));
  }
  return surface;
}

mesh::ExactMesh exact_mesh(const Surface& surface, const std::string& what) {
  mesh::ExactMesh mesh;
  std::vector<std::uint32_t> indices;
  take_points(surface, mesh, indices);
  for (const Surface::Face_index face : surface.faces()) {
    const auto first = surface.halfedge(face);
    const auto second = surface.next(first), third = surface.next(second);
    mesh.sources.push_back({0, static_cast<std::uint32_t>(mesh.triangles.size())});
    mesh.triangles.push_back({indices[surface.target(first)], indices[surface.target(second)],
                              indices[surface.target(third)]});
  }
  if (!has_two_faces_at_each_edge(mesh)) {
    throw Error(Errc::boolean_failed, what + " left a surface that is not closed");
  }
  mesh::separate_contacts(mesh);
  return mesh;
}

}  // namespace dupin::cross_check
