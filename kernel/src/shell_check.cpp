#include "shell_check.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>

#include "contact.h"
#include "disjoint_sets.h"
#include "measure.h"

namespace dupin::detail {
namespace {

struct Measures {
  double volume = 0, magnitude = 0, area = 0;  // six times, bounds of the terms, two times or more
  std::uint32_t face = 0;
  std::size_t faces = 0;
};

/// Per shell, at its lowest point.
std::vector<Measures> measured(const MeshView& mesh, std::span<const std::uint32_t> shell_of) {
  std::vector<Measures> measures(mesh.points.size());
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    const std::uint32_t shell = shell_of[t[0]];
    const Vec3& origin = mesh.points[shell];
    const Vec3 a = mesh.points[t[0]] - origin, u = mesh.points[t[1]] - mesh.points[t[0]],
               v = mesh.points[t[2]] - mesh.points[t[0]];
    const Vec3 normal = u.cross(v);
    Measures& sums = measures[shell];
    sums.volume += a.dot(normal);
    sums.magnitude += a.lpNorm<1>() * u.lpNorm<1>() * v.lpNorm<1>();
    sums.area += normal.lpNorm<1>();
    sums.face = f;
    ++sums.faces;
  }
  return measures;
}

/// The sign of the volume of the triangles whose points belong to a shell, exactly.
int sign_of_shell(MeshView view, std::span<const std::uint32_t> shell_of, std::uint32_t shell) {
  std::vector<Triangle> triangles;
  for (const Triangle& t : view.triangles) {
    if (shell_of[t[0]] == shell) {
      triangles.push_back(t);
    }
  }
  view.triangles = triangles;
  return volume_sign(view);
}

}  // namespace

std::vector<std::uint32_t> shell_of_points(const ExactMesh& exact) {
  DisjointSets sets(exact.points.size());
  for (const Triangle& t : exact.triangles) {
    sets.unite(t[0], t[1]);
    sets.unite(t[0], t[2]);
  }
  return sets.representatives();
}

std::vector<std::uint32_t> turned_shells(const ExactMesh& exact,
                                         std::span<const std::uint32_t> shell_of,
                                         const MeshView& mesh, double largest_move) {
  const std::vector<Measures> measures = measured(mesh, shell_of);
  std::vector<std::uint32_t> turned;
  for (std::uint32_t shell = 0; shell < measures.size(); ++shell) {
    const Measures& sums = measures[shell];
    // The volume has changed by at most the area times the move, doubled for the area's own change.
    // The terms, n in number, are summed with errors below n 2^-52 of what they are made of.
    const double doubt = 6 * sums.area * largest_move +
                         sums.magnitude * static_cast<double>(sums.faces + 10) * 0x1p-52;
    if (sums.faces > 0 && !(std::abs(sums.volume) > doubt) &&
        sign_of_shell(mesh, shell_of, shell) != sign_of_shell(MeshView(exact), shell_of, shell)) {
      turned.push_back(sums.face);
    }
  }
  return turned;
}

std::vector<std::uint32_t> crossed_contacts(const MeshView& mesh,
                                            std::span<const std::uint32_t> twins) {
  std::vector<std::uint32_t> crossed;
  for (const ContactPlace& place : find_contacts(mesh, twins)) {
    if (!place.alternating) {
      crossed.insert(crossed.end(), place.faces.begin(), place.faces.end());
    }
  }
  return crossed;
}

std::size_t remove_small_shells(RepairMesh& mesh, const std::vector<std::uint32_t>& faces,
                                double reach) {
  std::size_t removed = 0;
  std::set<std::uint32_t> seen;  // faces of shells that have been looked at
  for (const std::uint32_t first : faces) {
    if (!mesh.alive(first) || seen.contains(first)) {
      continue;
    }
    const Vec3 centre = mesh.point(mesh.triangle(first)[0]);
    std::vector<std::uint32_t> shell = {first};
    std::set<std::uint32_t> in_shell = {first};
    bool small = true;
    for (std::size_t i = 0; small && i < shell.size(); ++i) {
      for (const std::uint32_t v : mesh.triangle(shell[i])) {
        small = small && (mesh.point(v) - centre).norm() <= reach;
        for (const std::uint32_t f : mesh.faces(v)) {
          if (in_shell.insert(f).second) {
            shell.push_back(f);
          }
        }
      }
    }
    seen.insert(in_shell.begin(), in_shell.end());
    if (small) {
      mesh.remove(shell);
      ++removed;
    }
  }
  return removed;
}

}  // namespace dupin::detail
