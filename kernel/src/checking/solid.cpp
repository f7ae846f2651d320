#include "dupin/kernel/solid.h"

#include <algorithm>
#include <utility>

#include "checking/inspection.h"
#include "checking/plain_solid.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "exact/exact_numbers.h"
#include "mesh/edge_table.h"
#include "mesh/exact_mesh.h"
#include "mesh/measure.h"
#include "mesh/united_names.h"
#include "mesh/used_points.h"
#include "support/sequences.h"

namespace dupin {
namespace {

Errc code_of(Defect defect) {
  switch (defect) {
    case Defect::boundary_edge:
      return Errc::not_closed;
    case Defect::non_manifold_edge:
    case Defect::non_manifold_vertex:
      return Errc::not_manifold;
    case Defect::inconsistent_orientation:
    case Defect::inside_out_component:
      return Errc::not_oriented;
    case Defect::self_intersection:
      return Errc::self_intersecting;
    default:
      return Errc::invalid_argument;
  }
}

std::string remedy(Defect defect) {
  switch (defect) {
    case Defect::non_finite_point:
      return "coordinates must be finite";
    case Defect::point_out_of_range:
      return "use another unit of length, or write 0 for what is nearly 0";
    case Defect::bad_index:
      return "indices must be below the number of points";
    case Defect::degenerate_face:
      return "faces of a solid must have an area";
    case Defect::duplicate_face:
      return "keep one of them, or none if they face each other";
    case Defect::boundary_edge:
      return "a solid needs two faces at every edge";
    case Defect::non_manifold_edge:
      return "a solid needs exactly two faces at every edge; where two sheets touch, each needs "
             "vertices of its own";
    case Defect::non_manifold_vertex:
      return "where two sheets touch, each needs a vertex of its own";
    case Defect::inconsistent_orientation:
      return "reverse the corners of one side";
    case Defect::self_intersection:
      return "unite the parts as separate solids instead";
    case Defect::inside_out_component:
      return "reverse the corners of its faces: they must run counter-clockwise seen from outside "
             "the material";
    default:
      return {};
  }
}

void refuse_faults(const Report& report, const TriMesh& mesh) {
  for (const Finding& finding : report.findings) {
    if (is_fatal(finding.defect)) {
      const std::size_t count = report.count(finding.defect);
      const std::string others =
          count > 1 ? " (the first of " + std::to_string(count) + " such places)" : "";
      throw Error(code_of(finding.defect),
                  describe(finding, mesh) + others + "; " + remedy(finding.defect));
    }
  }
}

void refuse_bad_labels(const TriMesh& mesh) {
  if (mesh.labels.empty()) {
    return;
  }
  if (mesh.labels.size() != mesh.triangles.size()) {
    throw Error(Errc::invalid_argument, "a mesh of " + std::to_string(mesh.triangles.size()) +
                                            " faces has " + std::to_string(mesh.labels.size()) +
                                            " labels; there must be one for each face, or none");
  }
  for (std::size_t i = 0; i < mesh.labels.size(); ++i) {
    if (mesh.labels[i] >= mesh.names.size()) {
      throw Error(Errc::invalid_argument,
                  "face " + std::to_string(i) + " has label " + std::to_string(mesh.labels[i]) +
                      ", but there are only " + std::to_string(mesh.names.size()) + " names");
    }
  }
}

// Copies the points that faces use.
void copy_surface(const TriMesh& mesh, bool uses_all_points, mesh::ExactMesh& exact) {
  if (uses_all_points) {
    exact.points = mesh.points;
    exact.triangles = mesh.triangles;
    return;
  }
  const mesh::UsedPoints used = mesh::used_points(mesh.triangles, mesh.points.size());
  exact.points = support::selected(std::span<const Vec3>(mesh.points), used.points);
  exact.triangles = mesh.triangles;
  for (Triangle& corners : exact.triangles) {
    corners = used.renumbered(corners);
  }
}

// In absolute value.
double largest_coordinate(const TriMesh& mesh) {
  double largest = 0;
  for (const Vec3& point : mesh.points) {
    largest = std::max(largest, point.allFinite() ? point.cwiseAbs().maxCoeff() : 0);
  }
  return largest;
}

struct Pieces {
  explicit Pieces(const mesh::ExactMesh& mesh)
      : edges(mesh.triangles, mesh.points.size()),
        shells(mesh::shells(mesh.triangles.size(), edges)) {}
  mesh::EdgeTable edges;
  mesh::Shells shells;
};

}  // namespace

Solid::Solid() : mesh_(std::make_shared<const mesh::ExactMesh>()) {}

Solid::Solid(std::shared_ptr<const mesh::ExactMesh> mesh) : mesh_(std::move(mesh)) {}

Solid Solid::from(const TriMesh& mesh) {
  const UsualArithmetic usual;
  refuse_bad_labels(mesh);
  const double largest = largest_coordinate(mesh), margin = mesh::reach_of_binary32(largest);
  auto exact = std::make_shared<mesh::ExactMesh>();
  if (const auto plain = checking::plain_solid(mesh, margin)) {
    copy_surface(mesh, plain->uses_all_points, *exact);
    exact->stable = mesh::one_group(plain->stable, largest);
  } else {
    // It has faults, or touches itself, so that no triangles are known to be stable.
    const checking::Inspection inspection = checking::inspect(mesh, {.limit = 1});
    refuse_faults(inspection.report, mesh);
    copy_surface(mesh, false, *exact);
    for (const mesh::ContactPlace& place : inspection.contacts) {
      exact->contacts.push_back(
          mesh::to_contact(place, {mesh.points, mesh.triangles}, mesh.labels, mesh.names));
    }
  }
  exact->labels = mesh.labels;
  exact->names = mesh.names;
  mesh::unite_names(exact->names, exact->labels);
  exact->sources.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    exact->sources.push_back({0, i});
  }
  return Solid(std::move(exact));
}

bool Solid::empty() const { return mesh_->triangles.empty(); }

std::size_t Solid::point_count() const { return mesh_->points.size(); }

std::size_t Solid::triangle_count() const { return mesh_->triangles.size(); }

const std::vector<Triangle>& Solid::triangles() const { return mesh_->triangles; }

const std::vector<Vec3>& Solid::nearest_points() const { return mesh_->points; }

std::array<mpq_class, 3> Solid::exact_point(std::uint32_t index) const {
  (void)mesh_->points.at(index);
  const mesh::ExactPoint point = mesh::exact_point(*mesh_, index);
  const mpq_class weight = exact::rational(point[3]);
  return {exact::rational(point[0]) / weight, exact::rational(point[1]) / weight,
          exact::rational(point[2]) / weight};
}

mpq_class Solid::exact_volume() const { return mesh::exact_volume(mesh::MeshView(*mesh_)); }

double Solid::volume() const { return mesh::nearest_volume(mesh::MeshView(*mesh_)); }

double Solid::area() const { return mesh::area(mesh::MeshView(*mesh_)); }

std::size_t Solid::shells() const { return Pieces(*mesh_).shells.count; }

// Shells around material enclose a positive volume, shells around voids a negative one.
std::size_t Solid::components() const {
  const mesh::Shells shells = Pieces(*mesh_).shells;
  std::size_t count = 0;
  for (std::size_t i = 0; i < shells.count; ++i) {
    const auto faces =
        support::selected(std::span<const Triangle>(mesh_->triangles), shells.faces_of(i));
    mesh::MeshView shell(*mesh_);
    shell.triangles = faces;
    count += mesh::volume_sign(shell) > 0 ? 1 : 0;
  }
  return count;
}

std::int64_t Solid::euler_number() const {
  const auto edge_count = static_cast<std::int64_t>(3 * triangle_count() / 2);
  return static_cast<std::int64_t>(point_count() + triangle_count()) - edge_count;
}

std::int64_t Solid::genus() const {
  return static_cast<std::int64_t>(shells()) - euler_number() / 2;
}

const std::vector<Contact>& Solid::contacts() const { return mesh_->contacts; }

const std::vector<Source>& Solid::sources() const { return mesh_->sources; }

const std::vector<std::uint32_t>& Solid::labels() const { return mesh_->labels; }

const std::vector<std::string>& Solid::names() const { return mesh_->names; }

}  // namespace dupin
