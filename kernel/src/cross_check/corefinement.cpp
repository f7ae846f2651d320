#include "cross_check/corefinement.h"

#include <algorithm>
#include <array>
#include <string>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include "dupin/interop/cgal.h"
#include "exact/exact_numbers.h"
#include "mesh/edge_table.h"
#include "mesh/self_contact.h"

namespace dupin::cross_check {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Origins = Surface::Property_map<Surface::Face_index, std::uint32_t>;

// A surface whose faces know the operands' faces they are parts of: those of a first, then b's.
struct Traced {
  explicit Traced(std::uint32_t first_origin = 0)
      : origins(surface.add_property_map<Surface::Face_index, std::uint32_t>("f:origin").first),
        next_origin(first_origin) {}
  Traced(const Traced&) = delete;

  Surface surface;
  Origins origins;
  std::uint32_t next_origin;
};

class Tracer : public CGAL::Polygon_mesh_processing::Corefinement::Default_visitor<Surface> {
 public:
  Tracer(Traced& a, Traced& b, Traced& result) : meshes_{&a, &b, &result} {}

  void before_subface_creations(Surface::Face_index face, Surface& surface) {
    split_ = origins(surface)[face];
  }
  void after_subface_created(Surface::Face_index face, Surface& surface) {
    origins(surface)[face] = split_;
  }
  void after_face_copy(Surface::Face_index from, const Surface& source, Surface::Face_index to,
                       Surface& target) {
    origins(target)[to] = origins(source)[from];
  }

 private:
  [[nodiscard]] Origins& origins(const Surface& surface) const {
    return (*std::find_if(meshes_.begin(), meshes_.end(),
                          [&](const Traced* mesh) { return &mesh->surface == &surface; }))
        ->origins;
  }

  std::array<Traced*, 3> meshes_;
  std::uint32_t split_ = 0;
};

void fill(Traced& traced, const mesh::ExactMesh& mesh) {
  const mesh::MeshView view(mesh);
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (i < mesh.double_count()) {
      const Vec3& point = mesh.points[i];
      traced.surface.add_vertex({point.x(), point.y(), point.z()});
    } else {
      const mesh::ExactPoint point = view.exact(i);
      const mpq_class weight = exact::rational(point[3]);
      const auto coordinate = [&](std::size_t k) {
        return interop::number<Kernel::FT>(exact::rational(point[k]) / weight);
      };
      traced.surface.add_vertex({coordinate(0), coordinate(1), coordinate(2)});
    }
  }
  for (const Triangle& t : mesh.triangles) {
    using Vertex = Surface::Vertex_index;
    const auto face = traced.surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
    traced.origins[face] = traced.next_origin++;
  }
}

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

mesh::ExactMesh taken(const Traced& traced, const mesh::ExactMesh& a, const mesh::ExactMesh& b) {
  const Surface& surface = traced.surface;
  mesh::ExactMesh mesh;
  std::vector<std::uint32_t> indices;
  take_points(surface, mesh, indices);
  std::vector<std::pair<std::uint32_t, Surface::Face_index>> faces;  // by origin
  for (const Surface::Face_index face : surface.faces()) {
    faces.emplace_back(traced.origins[face], face);
  }
  std::sort(faces.begin(), faces.end());
  mesh.names = a.names;
  for (const auto& [origin, face] : faces) {
    const auto first = surface.halfedge(face);
    const auto second = surface.next(first), third = surface.next(second);
    mesh.triangles.push_back({indices[surface.target(first)], indices[surface.target(second)],
                              indices[surface.target(third)]});
    const auto count = static_cast<std::uint32_t>(a.triangles.size());
    const mesh::ExactMesh& operand = origin < count ? a : b;
    const std::uint32_t triangle = origin < count ? origin : origin - count;
    mesh.sources.push_back(operand.sources[triangle]);
    if (!operand.labels.empty()) {
      mesh.labels.push_back(operand.labels[triangle]);
    }
  }
  return mesh;
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

bool compute(SetOperation operation, Traced& a, Traced& b, Traced& result) {
  namespace processing = CGAL::Polygon_mesh_processing;
  const auto visitor = CGAL::parameters::visitor(Tracer(a, b, result));
  switch (operation) {
    case SetOperation::unite:
      return processing::corefine_and_compute_union(a.surface, b.surface, result.surface, visitor);
    case SetOperation::intersect:
      return processing::corefine_and_compute_intersection(a.surface, b.surface, result.surface,
                                                           visitor);
    case SetOperation::subtract:
      return processing::corefine_and_compute_difference(a.surface, b.surface, result.surface,
                                                         visitor);
  }
  return false;
}

}  // namespace

mesh::ExactMesh corefine(SetOperation operation, const mesh::ExactMesh& a,
                         const mesh::ExactMesh& b) {
  const std::string what = "'" + std::string(name(operation)) + "' by corefinement";
  for (const mesh::ExactMesh* operand : {&a, &b}) {
    if (!operand->contacts.empty()) {
      throw Error(Errc::boolean_failed, what + " takes no operand whose surface touches itself");
    }
  }
  return exact::guarded(what, [&] {
    Traced left, right(static_cast<std::uint32_t>(a.triangles.size())), result;
    fill(left, a);
    fill(right, b);
    if (!compute(operation, left, right, result)) {
      throw Error(Errc::boolean_failed,
                  what + " refuses a result that touches itself along an edge");
    }
    mesh::ExactMesh mesh = taken(result, a, b);
    if (!has_two_faces_at_each_edge(mesh)) {
      throw Error(Errc::boolean_failed, what + " left a surface that is not closed");
    }
    mesh::separate_contacts(mesh);
    return mesh;
  });
}

}  // namespace dupin::cross_check
