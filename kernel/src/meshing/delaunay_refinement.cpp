#include "meshing/delaunay_refinement.h"

#include <array>
#include <numbers>
#include <sstream>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>

#include "dupin/kernel/error.h"
#include "dupin/kernel/solver_mesh.h"

namespace dupin::meshing {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, Surface, CGAL::Default, int>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index,
                                                        Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

Point point_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
Vec3 vector_of(const Point& p) { return {p.x(), p.y(), p.z()}; }

/// The mesh, with the number of its region, from 1 on, at each face.
Surface surface_of(const TriMesh& mesh, const Features& features) {
  Surface surface;
  for (const Vec3& point : mesh.points) {
    surface.add_vertex(point_of(point));
  }
  auto regions = get(CGAL::face_patch_id_t<int>(), surface);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const Surface::Face_index face = surface.add_face(
        Surface::Vertex_index(a), Surface::Vertex_index(b), Surface::Vertex_index(c));
    if (face == Surface::null_face()) {
      throw Error(Errc::internal, "internal error, please report it: a face of a solid is refused");
    }
    put(regions, face, static_cast<int>(features.regions[f]) + 1);
  }
  return surface;
}

/// A polyline with the regions beside it, as the domain takes it.
struct Polyline {
  std::vector<Point> points;
  std::vector<int> regions;
};

/// A member of polylines as a property map of theirs.
template <auto Member>
struct Part {
  using key_type = const Polyline&;
  using reference = decltype(std::declval<key_type>().*Member);
  using value_type = std::remove_cvref_t<reference>;
  using category = boost::readable_property_map_tag;
  friend reference get(const Part&, key_type line) { return line.*Member; }
};

std::vector<Polyline> polylines_of(const Features& features) {
  std::vector<Polyline> lines;
  for (const Curve& curve : features.curves) {
    Polyline line;
    for (const Vec3& point : curve.points) {
      line.points.push_back(point_of(point));
    }
    for (const std::uint32_t region : curve.regions) {
      line.regions.push_back(static_cast<int>(region) + 1);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// A field of sizes that also ends a generator which asks for too many of them.
class Sizes {
 public:
  using FT = Kernel::FT;
  using Point_3 = Point;
  using Index = Domain::Index;

  struct Watch {
    const Progress& progress;
    std::size_t most;  // questions
    std::size_t asked = 0;
  };
  Sizes(Watch& watch, const std::function<double(const Vec3&)>& size)
      : watch_(&watch), size_(&size) {}

  FT operator()(const Point& point, int /*dimension*/, const Index& /*index*/) const {
    constexpr std::size_t kSome = 1024;
    if (++watch_->asked % kSome == 0) {
      tell(watch_->progress, "mesh");
    }
    if (watch_->asked > watch_->most) {
      std::ostringstream text;
      text << "a mesh with these lengths and distances gets too many points, the last ones near "
           << point.x() << " " << point.y() << " " << point.z()
           << "; sharp edges or borders may be too near each other there";
      throw Error(Errc::limit_exceeded, text.str());
    }
    return (*size_)(vector_of(point));
  }

 private:
  Watch* watch_;
  const std::function<double(const Vec3&)>* size_;
};

/// Balls along curves; then the seeds of regions without any, and of all where no triangle has come
/// of curves alone.
void begin(Complex& complex, const Domain& domain, const Criteria& criteria,
           const Refinement& wanted, CGAL::Mesh_error_code& code) {
  CGAL::Mesh_3::internal::init_c3t3_with_features(complex, domain, criteria, false,
                                                  wanted.most_points, &code);
  Triangulation& triangulation = complex.triangulation();
  bool has_triangles = triangulation.dimension() == 3;
  if (has_triangles) {
    CGAL::Mesh_3::C3T3_helpers<Complex, Domain>(complex, domain).update_restricted_facets();
    has_triangles = complex.number_of_facets() > 0;
  }
  for (const Seed& seed : wanted.seeds) {
    if (seed.is_needed || !has_triangles) {
      const auto vertex = triangulation.insert(Triangulation::Weighted_point(point_of(seed.point)));
      if (vertex != Triangulation::Vertex_handle()) {
        complex.set_dimension(vertex, 2);
        complex.set_index(vertex,
                          domain.index_from_surface_patch_index(static_cast<int>(seed.region) + 1));
      }
    }
  }
}

Complex generated(const Domain& domain, const Refinement& wanted, const Progress& progress) {
  namespace given = CGAL::parameters;
  constexpr std::size_t kQuestions = 64;  // for each point, far more than there are usually
  Sizes::Watch watch{progress, kQuestions * wanted.most_points};
  const std::function<double(const Vec3&)> radius = [&](const Vec3&) { return wanted.radius; };
  constexpr double kRadiusToEdge = 2;  // CGAL's refinement ends for this, and not for much less
  const Criteria criteria(
      given::edge_size = Sizes(watch, wanted.edge_length),
      given::facet_angle = wanted.smallest_angle * 180 / std::numbers::pi,
      given::facet_size = Sizes(watch, radius), given::facet_distance = wanted.distance,
      given::facet_topology = CGAL::FACET_VERTICES_ON_SAME_SURFACE_PATCH_WITH_ADJACENCY_CHECK,
      given::cell_radius_edge_ratio = wanted.fill ? kRadiusToEdge : 0.0,
      given::cell_size = wanted.fill ? wanted.radius : 0.0);
  CGAL::get_default_random() = CGAL::Random(0);
  CGAL::Mesh_error_code code = CGAL::CGAL_MESH_3_NO_ERROR;
  const auto options = given::mesh_3_options(given::maximal_number_of_vertices = wanted.most_points,
                                             given::pointer_to_error_code = &code);
  Complex complex;
  begin(complex, domain, criteria, wanted, code);
  if (code == CGAL::CGAL_MESH_3_NO_ERROR && complex.triangulation().dimension() == 3) {
    CGAL::refine_mesh_3(complex, domain, criteria, given::no_reset_c3t3(),
                        wanted.fill ? given::exude() : given::no_exude(), given::no_perturb(),
                        given::no_odt(), given::no_lloyd(), options, given::manifold());
  }
  if (code != CGAL::CGAL_MESH_3_NO_ERROR) {
    throw Error(Errc::limit_exceeded, "a mesh with these lengths and distances gets more than " +
                                          std::to_string(wanted.most_points) +
                                          " points; allow longer edges or a larger distance");
  }
  return complex;
}

Tetrahedra tetrahedra_of(const Complex& complex) {
  Tetrahedra result;
  std::unordered_map<Complex::Vertex_handle, std::uint32_t, CGAL::Handle_hash_function> numbers;
  const auto number = [&](Complex::Vertex_handle vertex) {
    const auto [at, is_new] =
        numbers.emplace(vertex, static_cast<std::uint32_t>(result.points.size()));
    if (is_new) {
      result.points.push_back(vector_of(vertex->point().point()));
      result.freedoms.push_back(vertex->in_dimension() == 2   ? Freedom::region
                                : vertex->in_dimension() == 3 ? Freedom::inside
                                                              : Freedom::none);
    }
    return at->second;
  };
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end();
       ++cell) {
    Tetrahedron corners{};
    for (int k = 0; k < 4; ++k) {
      corners[static_cast<std::size_t>(k)] = number(cell->vertex(k));
    }
    result.tetrahedra.push_back(corners);
    for (int k = 0; k < 4; ++k) {
      if (complex.is_in_complex(cell->neighbor(k))) {
        continue;
      }
      result.triangles.push_back(faces_of(corners)[static_cast<std::size_t>(k)]);
      result.regions.push_back(
          static_cast<std::uint32_t>(complex.surface_patch_index(cell, k) - 1));
    }
  }
  return result;
}

}  // namespace

Tetrahedra refine(const TriMesh& mesh, const Features& features, const Refinement& wanted,
                  const Progress& progress) {
  CGAL::Random random(0);
  Domain domain(surface_of(mesh, features), &random);
  const std::vector<Polyline> lines = polylines_of(features);
  domain.add_features_and_incidences(lines.begin(), lines.end(), Part<&Polyline::points>(),
                                     Part<&Polyline::regions>());
  try {
    return tetrahedra_of(generated(domain, wanted, progress));
  } catch (const CGAL::Failure_exception&) {
    return {};  // an assumption of it on a point that it has computed does not hold
  }
}

}  // namespace dupin::meshing

namespace dupin {

bool has_mesh_generator() { return true; }

}  // namespace dupin
