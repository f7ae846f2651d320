#include "shell_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <Eigen/Geometry>

#include "contact.h"
#include "measure.h"

namespace dupin::detail {
namespace {

/// For each point the lowest one of its shell: points that triangles connect.
std::vector<std::uint32_t> shell_of_points(const ExactMesh& exact) {
  std::vector<std::uint32_t> parent(exact.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) {
      v = parent[v] = parent[parent[v]];
    }
    return v;
  };
  for (const Triangle& t : exact.triangles) {
    for (const std::uint32_t v : {t[1], t[2]}) {
      const std::uint32_t a = root(t[0]), b = root(v);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::uint32_t& v : parent) {
    v = parent[v];  // parents come first and are roots by now
  }
  return parent;
}

struct Measures {
  double volume = 0, magnitude = 0, area = 0;  // six times, the terms without sign, two times
  std::uint32_t face = 0;
  std::size_t faces = 0;
};

/// The sign of the volume of the triangles whose points belong to a shell, exactly.
int sign_of_shell(MeshView view, const std::vector<std::uint32_t>& shell_of, std::uint32_t shell) {
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

std::vector<std::uint32_t> turned_shells(const ExactMesh& exact, const RepairMesh& mesh,
                                         double largest_move) {
  const std::vector<std::uint32_t> shell_of = shell_of_points(exact);
  std::vector<Measures> measures(exact.points.size());
  std::vector<Triangle> triangles;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.alive(f)) {
      const Triangle& t = mesh.triangle(f);
      triangles.push_back(t);
      const std::uint32_t shell = shell_of[t[0]];
      const Vec3& origin = mesh.point(shell);
      const Vec3 a = mesh.point(t[0]) - origin, b = mesh.point(t[1]) - origin,
                 c = mesh.point(t[2]) - origin;
      Measures& sums = measures[shell];
      const double term = a.cross(b).dot(c);
      sums.volume += term;
      sums.magnitude += a.norm() * b.norm() * c.norm();
      sums.area += (b - a).cross(c - a).norm();
      sums.face = f;
      ++sums.faces;
    }
  }
  std::vector<std::uint32_t> turned;
  for (std::uint32_t shell = 0; shell < measures.size(); ++shell) {
    const Measures& sums = measures[shell];
    // The volume has changed by at most the area times the move, doubled for the area's own change;
    // n terms are summed with relative errors below n 2^-52 of what they are made of.
    const double doubt = 6 * sums.area * largest_move +
                         sums.magnitude * static_cast<double>(sums.faces + 10) * 0x1p-52;
    if (sums.faces > 0 && std::abs(sums.volume) <= doubt &&
        sign_of_shell(MeshView(mesh.points(), triangles), shell_of, shell) !=
            sign_of_shell(MeshView(exact), shell_of, shell)) {
      turned.push_back(sums.face);
    }
  }
  return turned;
}

std::vector<std::uint32_t> crossed_contacts(const RepairMesh& mesh,
                                            std::span<const std::uint32_t> twins) {
  std::vector<std::uint32_t> faces, crossed;
  std::vector<Triangle> triangles;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.alive(f)) {
      faces.push_back(f);
      triangles.push_back(mesh.triangle(f));
    }
  }
  for (const ContactPlace& place : find_contacts(MeshView(mesh.points(), triangles), twins)) {
    for (const std::uint32_t i : place.faces) {
      if (!place.alternating) {
        crossed.push_back(faces[i]);
      }
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
