#include "dupin/io/volume_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmpxx.h>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using Tetrahedron = std::array<std::uint32_t, 4>;

constexpr double kFlat = 5 * std::numbers::pi / 180;

/// The faces of a tetrahedron, seen from outside counter-clockwise.
constexpr std::array<std::array<int, 3>, 4> kFaces = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

[[noreturn]] void refuse(const std::string& what) {
  throw Error(Errc::boolean_failed, "the tetrahedra do not fill the solid: " + what);
}

/// The sign of the volume, exactly.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double volume = u.cross(v).dot(w);
  const Vec3 p = u.cwiseAbs(), q = v.cwiseAbs(), r = w.cwiseAbs();
  const double permanent = (p.y() * q.z() + p.z() * q.y()) * r.x() +
                           (p.z() * q.x() + p.x() * q.z()) * r.y() +
                           (p.x() * q.y() + p.y() * q.x()) * r.z();
  const double bound = 1e-14 * permanent;  // ten times what rounding can do
  if (std::abs(volume) > bound) {
    return volume > 0 ? 1 : -1;
  }
  const auto difference = [](const Vec3& to, const Vec3& from) {
    return std::array<mpq_class, 3>{mpq_class(to.x()) - mpq_class(from.x()),
                                    mpq_class(to.y()) - mpq_class(from.y()),
                                    mpq_class(to.z()) - mpq_class(from.z())};
  };
  const auto x = difference(b, a), y = difference(c, a), z = difference(d, a);
  const mpq_class exact = (x[1] * y[2] - x[2] * y[1]) * z[0] + (x[2] * y[0] - x[0] * y[2]) * z[1] +
                          (x[0] * y[1] - x[1] * y[0]) * z[2];
  return sgn(exact);
}

double smallest_dihedral_angle(const std::array<Vec3, 4>& t) {
  std::array<Vec3, 4> normals;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [a, b, c] = kFaces[i];
    normals[i] = (t[b] - t[a]).cross(t[c] - t[a]);
  }
  double least = std::numbers::pi;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i + 1; k < 4; ++k) {
      const double outer =
          std::atan2(normals[i].cross(normals[k]).norm(), normals[i].dot(normals[k]));
      least = std::min(least, std::numbers::pi - outer);
    }
  }
  return least;
}

/// A triangle with its lowest corner first, and whether it is the other way round.
struct Facet {
  Triangle corners;  // ascending
  bool is_odd;
  bool is_surface;
};

Facet facet(const Triangle& t, bool is_surface) {
  Facet made{t, false, is_surface};
  for (const auto& [i, k] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)}) {
    if (made.corners[i] > made.corners[k]) {
      std::swap(made.corners[i], made.corners[k]);
      made.is_odd = !made.is_odd;
    }
  }
  return made;
}

/// Whether all facets come in pairs: two of tetrahedra from opposite sides, or one of them with a
/// triangle of the surface, from the same side.
void check_facets(const VolumeMesh& mesh) {
  std::vector<Facet> facets;
  facets.reserve(4 * mesh.tetrahedra.size() + mesh.surface.triangles.size());
  for (const Tetrahedron& t : mesh.tetrahedra) {
    for (const auto& [a, b, c] : kFaces) {
      facets.push_back(facet({t[a], t[b], t[c]}, false));
    }
  }
  for (const Triangle& t : mesh.surface.triangles) {
    facets.push_back(facet(t, true));
  }
  std::ranges::sort(facets, {}, [](const Facet& f) { return f.corners; });
  for (std::size_t i = 0; i < facets.size(); i += 2) {
    if (i + 1 == facets.size() || facets[i].corners != facets[i + 1].corners ||
        (i + 2 < facets.size() && facets[i + 2].corners == facets[i].corners)) {
      refuse("a face of theirs is not that of two, or of one and the surface");
    }
    const Facet &first = facets[i], &second = facets[i + 1];
    const bool is_border = first.is_surface != second.is_surface;
    if ((first.is_surface && second.is_surface) || is_border != (first.is_odd == second.is_odd)) {
      refuse("two of them lie on one side of a face");
    }
  }
}

}  // namespace

VolumeMeshReport check_volume_mesh(const VolumeMesh& mesh) {
  VolumeMeshReport report;
  report.points = mesh.points.size();
  report.tetrahedra = mesh.tetrahedra.size();
  report.triangles = mesh.surface.triangles.size();
  report.smallest_dihedral_angle = std::numbers::pi;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    if (std::ranges::any_of(t, [&](std::uint32_t v) { return v >= mesh.points.size(); })) {
      refuse("one has a corner that is none");
    }
    const std::array<Vec3, 4> p = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                                   mesh.points[t[3]]};
    if (orientation(p[0], p[1], p[2], p[3]) <= 0) {
      refuse("one is flat or inside out");
    }
    report.volume += (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]) / 6;
    const double angle = smallest_dihedral_angle(p);
    report.smallest_dihedral_angle = std::min(report.smallest_dihedral_angle, angle);
    report.flat_tetrahedra += angle < kFlat ? 1 : 0;
  }
  check_facets(mesh);
  return report;
}

}  // namespace dupin
