#include "meshing/delaunay_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <string>
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

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/solver_mesh.h"
#include "meshing/edge_lengths.h"
#include "meshing/unit_scale.h"

namespace dupin::meshing {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, Surface, CGAL::Default, int>;

/// Exudation pumps up a vertex until it is as far from the sphere orthogonal to a cell as this
/// says. CGAL's own, a quotient of differences of determinants, is no number for a flat cell, and
/// ends the program then, in GMP.
class ExudationTraits : public CGAL::Kernel_traits<Domain>::Kernel {
 public:
  struct Compute_power_distance_to_power_sphere_3 {
    using result_type = double;
    double operator()(const Weighted_point_3& p, const Weighted_point_3& q,
                      const Weighted_point_3& r, const Weighted_point_3& s,
                      const Weighted_point_3& t) const {
      const Point& origin = p.point();
      const Vector_3 a = q.point() - origin, b = r.point() - origin, c = s.point() - origin;
      const Vector_3 to = t.point() - origin;
      const auto half_power = [&p](const Vector_3& v, const Weighted_point_3& end) {
        return (v.squared_length() - end.weight() + p.weight()) / 2;
      };
      const Vector_3 bc = cross_product(b, c);
      const Vector_3 centre = (half_power(a, q) * bc + half_power(b, r) * cross_product(c, a) +
                               half_power(c, s) * cross_product(a, b)) /
                              (a * bc);
      const double distance = to.squared_length() - 2 * (to * centre) + p.weight();
      // It ends before a vertex of the cell.
      return std::isfinite(distance)
                 ? distance
                 : std::min({to.squared_length(), (to - a).squared_length(),
                             (to - b).squared_length(), (to - c).squared_length()});
    }
  };
  [[nodiscard]] Compute_power_distance_to_power_sphere_3
  compute_power_distance_to_power_sphere_3_object() const {
    return {};
  }
};

using Triangulation = CGAL::Mesh_triangulation_3<Domain, ExudationTraits>::type;

/// What is made. Where the generator looks at simplices again and again, and adds no point, as it
/// does for ever where the one that it wants cannot be, or more points than are of use, that is
/// found out: it throws Stalled.
class Complex : public CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index,
                                                               Domain::Curve_index> {
  using Base = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index,
                                                       Domain::Curve_index>;

 public:
  struct Stalled {};
  void watch(std::size_t most_points) {
    is_watched_ = true;
    most_points_ = most_points;
    looked_ = 0;
  }
  void watch_no_more() { is_watched_ = false; }

  template <class... Simplex>
  [[nodiscard]] bool is_in_complex(const Simplex&... simplex) const {
    constexpr std::size_t kOften = 64, kAtLeast = 1 << 20;
    if (is_watched_) {
      const std::size_t points = triangulation().number_of_vertices();
      if (points > most_points_) {
        throw Stalled();
      }
      if (++looked_ > kAtLeast + kOften * triangulation().number_of_cells()) {
        if (points_ == points) {
          throw Stalled();
        }
        points_ = points;
        looked_ = 0;
      }
    }
    return Base::is_in_complex(simplex...);
  }

 private:
  bool is_watched_ = false;
  std::size_t most_points_ = 0;
  mutable std::size_t looked_ = 0;  // how often since it was last asked how many points there are
  mutable std::size_t points_ = 0;  // how many there were then
};

}  // namespace
}  // namespace dupin::meshing

// Before it throws, the generator would write all it has into files of the working folder, and say
// so on standard error.
template <>
struct CGAL::Dump_c3t3<dupin::meshing::Complex, true> {
  void dump_c3t3(const dupin::meshing::Complex&, const std::string&) const {}
};

namespace dupin::meshing {
namespace {

using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

Point point_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
Vec3 vector_of(const Point& p) { return {p.x(), p.y(), p.z()}; }

/// The mesh, in the unit, with the number of its region, from 1 on, at each face.
Surface surface_of(const TriMesh& mesh, const Features& features, double unit) {
  Surface surface;
  for (const Vec3& point : mesh.points) {
    surface.add_vertex(point_of(point / unit));
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

/// Triangles without neighbours: those of a region need not be a manifold.
Surface soup_of(const TriMesh& mesh, double unit) {
  Surface surface;
  auto regions = get(CGAL::face_patch_id_t<int>(), surface);
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto corner = [&](std::uint32_t v) {
      return surface.add_vertex(point_of(mesh.points[v] / unit));
    };
    const Surface::Vertex_index p = corner(a), q = corner(b), r = corner(c);
    put(regions, surface.add_face(p, q, r), 1);
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

std::vector<Polyline> polylines_of(const Features& features, double unit) {
  std::vector<Polyline> lines;
  for (const Curve& curve : features.curves) {
    Polyline line;
    for (const Vec3& point : curve.points) {
      line.points.push_back(point_of(point / unit));
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
    double unit;
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
      const Vec3 place = watch_->unit * vector_of(point);
      throw Error(Errc::limit_exceeded,
                  "a mesh with these lengths and distances gets too many points, the last ones "
                  "near " +
                      decimal(place) + "; sharp edges or borders may be too near each other there");
    }
    return (*size_)(vector_of(point));
  }

 private:
  Watch* watch_;
  const std::function<double(const Vec3&)>* size_;
};

/// Those that are needed, and all where no triangle has come of curves alone.
void insert_seeds(Complex& complex, const Domain& domain, const Refinement& wanted) {
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

/// What the generator asks for and is told.
class Generation {
 public:
  /// What is wanted is so in the unit.
  Generation(const Refinement& wanted, double unit, const Progress& progress)
      : wanted_(wanted),
        watch_{progress, unit, kQuestions * wanted.most_points},
        radius_([this](const Vec3&) { return wanted_.radius; }) {
    CGAL::get_default_random() = CGAL::Random(0);
  }
  Generation(const Generation&) = delete;
  Generation& operator=(const Generation&) = delete;

  [[nodiscard]] Criteria criteria() {
    namespace given = CGAL::parameters;
    constexpr double kRadiusToEdge = 2;  // CGAL's refinement ends for this, and not for much less
    return {given::edge_size = Sizes(watch_, wanted_.edge_length),
            given::facet_angle = wanted_.smallest_angle * 180 / std::numbers::pi,
            given::facet_size = Sizes(watch_, radius_),
            given::facet_distance = wanted_.distance,
            given::facet_topology = CGAL::FACET_VERTICES_ON_SAME_SURFACE_PATCH_WITH_ADJACENCY_CHECK,
            given::cell_radius_edge_ratio = wanted_.fill ? kRadiusToEdge : 0.0,
            given::cell_size = wanted_.fill ? wanted_.radius : 0.0};
  }

  /// Balls along curves.
  void protect(Complex& complex, const Domain& domain, const Criteria& criteria) {
    CGAL::Mesh_3::internal::init_c3t3_with_features(complex, domain, criteria, false,
                                                    wanted_.most_points, &code_);
    require_room();
  }

  void refine(Complex& complex, const Domain& domain, const Criteria& criteria) {
    namespace given = CGAL::parameters;
    const auto options =
        given::mesh_3_options(given::maximal_number_of_vertices = wanted_.most_points,
                              given::pointer_to_error_code = &code_);
    const auto topology = wanted_.fill ? given::manifold() : given::manifold_with_boundary();
    complex.watch(wanted_.most_useful_points);
    CGAL::refine_mesh_3(complex, domain, criteria, given::no_reset_c3t3(), given::no_exude(),
                        given::no_perturb(), given::no_odt(), given::no_lloyd(), options, topology);
    complex.watch_no_more();
    require_room();
    if (wanted_.fill) {  // as long as it takes: what is left out would depend on how fast that is
      CGAL::exude_mesh_3(complex, given::time_limit = 0);
    }
  }

 private:
  static constexpr std::size_t kQuestions = 64;  // per point, far more than there are usually

  void require_room() const {
    if (code_ != CGAL::CGAL_MESH_3_NO_ERROR) {
      throw too_many(wanted_.most_points);
    }
  }

  const Refinement& wanted_;
  Sizes::Watch watch_;
  std::function<double(const Vec3&)> radius_;
  CGAL::Mesh_error_code code_ = CGAL::CGAL_MESH_3_NO_ERROR;
};

Complex generated(const Domain& domain, const Refinement& wanted, double unit,
                  const Progress& progress) {
  Generation generation(wanted, unit, progress);
  const Criteria criteria = generation.criteria();
  Complex complex;
  generation.protect(complex, domain, criteria);
  insert_seeds(complex, domain, wanted);
  if (complex.triangulation().dimension() == 3) {
    generation.refine(complex, domain, criteria);
  }
  return complex;
}

using VertexHandle = Complex::Vertex_handle;

/// Corners of a cube far around, so that points of a plane have tetrahedra, too. Triangles with
/// such a corner count as poor.
void insert_far_points(Complex& complex, const Domain& domain) {
  const CGAL::Bbox_3 box = domain.bbox();
  const Vec3 low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
  const Vec3 middle = (low + high) / 2;
  const double reach = 4 * (high - low).norm();
  for (const double x : {-reach, reach}) {
    for (const double y : {-reach, reach}) {
      for (const double z : {-reach, reach}) {
        const VertexHandle vertex = complex.triangulation().insert(
            Triangulation::Weighted_point(point_of(middle + Vec3(x, y, z))));
        complex.set_dimension(vertex, 3);
        complex.set_index(vertex, domain.index_from_subdomain_index(1));
      }
    }
  }
}

/// Their vertices, or none if one is hidden by others, or neighbours have no edge.
std::vector<VertexHandle> insert_balls(Complex& complex, const Domain& domain,
                                       const CurvePoints& balls) {
  Triangulation& triangulation = complex.triangulation();
  std::vector<VertexHandle> vertices;
  VertexHandle beside;  // from where it is looked for the next: all the way would be quadratic
  for (const CurvePoint& ball : balls.points) {
    vertices.push_back(triangulation.insert(
        Triangulation::Weighted_point(point_of(ball.place), ball.radius * ball.radius), beside));
    beside = vertices.back() == VertexHandle() ? beside : vertices.back();
  }
  if (std::ranges::any_of(vertices, [](VertexHandle v) { return v == VertexHandle(); }) ||
      triangulation.number_of_vertices() < vertices.size()) {
    return {};
  }
  std::vector<std::pair<Domain::Corner_index, Point>> corners;
  domain.get_corners(std::back_inserter(corners));
  std::map<Point, Domain::Corner_index> corner_at;
  for (const auto& [index, point] : corners) {
    corner_at.emplace(point, index);
  }
  for (std::size_t c = 0; c < balls.chains.size(); ++c) {
    const std::vector<std::uint32_t>& chain = balls.chains[c];
    const auto curve = static_cast<Domain::Curve_index>(c) + 1;
    for (const std::uint32_t i : chain) {
      complex.set_dimension(vertices[i], 1);
      complex.set_index(vertices[i], domain.index_from_curve_index(curve));
    }
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const VertexHandle from = vertices[chain[i - 1]], to = vertices[chain[i]];
      Complex::Cell_handle cell;
      int a = 0, b = 0;
      if (!triangulation.is_edge(from, to, cell, a, b)) {
        return {};
      }
      complex.add_to_complex(from, to, curve);
    }
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (balls.points[i].is_corner) {
      const auto corner = corner_at.find(point_of(balls.points[i].place));
      if (corner == corner_at.end()) {
        return {};
      }
      complex.set_dimension(vertices[i], 0);
      complex.set_index(vertices[i], domain.index_from_corner_index(corner->second));
      complex.add_to_complex(vertices[i], corner->second);
    }
  }
  return vertices;
}

/// The triangles, and the points, those of balls first.
Tetrahedra triangles_of(const Complex& complex, const std::vector<VertexHandle>& balls) {
  Tetrahedra result;
  std::unordered_map<VertexHandle, std::uint32_t, CGAL::Handle_hash_function> numbers;
  const auto add = [&](VertexHandle vertex, Freedom freedom) {
    const auto [at, is_new] =
        numbers.emplace(vertex, static_cast<std::uint32_t>(result.points.size()));
    if (is_new) {
      result.points.push_back(vector_of(vertex->point().point()));
      result.freedoms.push_back(freedom);
    }
    return at->second;
  };
  for (const VertexHandle ball : balls) {
    add(ball, Freedom::none);
  }
  for (auto facet = complex.facets_in_complex_begin(); facet != complex.facets_in_complex_end();
       ++facet) {
    const auto& [cell, opposite] = *facet;
    Triangle corners{};
    for (int k = 0; k < 3; ++k) {
      corners[static_cast<std::size_t>(k)] =
          add(cell->vertex((opposite + 1 + k) % 4), Freedom::region);
    }
    result.triangles.push_back(corners);
    result.regions.push_back(0);
  }
  return result;
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

/// Warnings go to whoever reads what is made, not to standard error.
class QuietWarnings {
 public:
  QuietWarnings() : before_(CGAL::set_warning_handler(&ignore)) {}
  ~QuietWarnings() { CGAL::set_warning_handler(before_); }
  QuietWarnings(const QuietWarnings&) = delete;
  QuietWarnings& operator=(const QuietWarnings&) = delete;

 private:
  static void ignore(const char*, const char*, const char*, int, const char*) {}
  CGAL::Failure_function before_;
};

/// What the generator makes, in the unit, or nothing where it gives up.
template <class Make>
Tetrahedra unless_failed(double unit, const Make& make) {
  const QuietWarnings quiet;
  try {
    Tetrahedra made = make();
    for (Vec3& point : made.points) {
      point *= unit;
    }
    return made;
  } catch (const CGAL::Failure_exception&) {
    return {};  // an assumption of it on a point that it has computed does not hold
  } catch (const Complex::Stalled&) {
    return {};
  }
}

}  // namespace

Tetrahedra refine(const TriMesh& mesh, const Features& features, const Refinement& wanted,
                  const Progress& progress) {
  const double unit = unit_for(mesh);
  CGAL::Random random(0);
  Domain domain(surface_of(mesh, features, unit), &random);
  const std::vector<Polyline> lines = polylines_of(features, unit);
  domain.add_features_and_incidences(lines.begin(), lines.end(), Part<&Polyline::points>(),
                                     Part<&Polyline::regions>());
  return unless_failed(unit, [&] {
    return tetrahedra_of(generated(domain, in_unit(wanted, unit), unit, progress));
  });
}

Tetrahedra refine_surface(const TriMesh& mesh, const Features& features, const CurvePoints& balls,
                          const Refinement& wanted, const Progress& progress) {
  const double unit = unit_for(mesh);
  CGAL::Random random(0);
  const Surface surface = soup_of(mesh, unit);
  const std::array<const Surface*, 1> surfaces = {&surface};
  Domain domain(surfaces.begin(), surfaces.end(), &random);
  const std::vector<Polyline> lines = polylines_of(features, unit);
  domain.add_features_and_incidences(lines.begin(), lines.end(), Part<&Polyline::points>(),
                                     Part<&Polyline::regions>());
  return unless_failed(unit, [&]() -> Tetrahedra {
    const Refinement scaled = in_unit(wanted, unit);
    Generation generation(scaled, unit, progress);
    const Criteria criteria = generation.criteria();
    Complex complex;
    insert_far_points(complex, domain);
    const std::vector<VertexHandle> vertices = insert_balls(complex, domain, in_unit(balls, unit));
    if (vertices.size() < balls.points.size()) {
      return {};
    }
    insert_seeds(complex, domain, scaled);
    generation.refine(complex, domain, criteria);
    return triangles_of(complex, vertices);
  });
}

}  // namespace dupin::meshing

namespace dupin {

bool has_mesh_generator() { return true; }

}  // namespace dupin
