#include "rounding/shell_check.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>

#include "dupin/kernel/connected_components.h"
#include "mesh/measure.h"
#include "mesh/self_contact.h"
#include "rounding/fault_tracker.h"
#include "rounding/shell_sums.h"
#include "support/blocks.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

struct Measures {
  double volume = 0, magnitude = 0, area = 0;  // six times, bounds of the terms, two times or more
  std::uint32_t face = 0;
  std::size_t faces = 0;

  void add(const Measures& other) {
    volume += other.volume;
    magnitude += other.magnitude;
    area += other.area;
    face = other.face;
    faces += other.faces;
  }
};

Measures measured(const mesh::MeshView& mesh, std::uint32_t face, const Vec3& origin) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 a = mesh.points[t[0]] - origin, u = mesh.points[t[1]] - mesh.points[t[0]],
             v = mesh.points[t[2]] - mesh.points[t[0]];
  const Vec3 normal = u.cross(v);
  return {a.dot(normal), a.lpNorm<1>() * u.lpNorm<1>() * v.lpNorm<1>(), normal.lpNorm<1>(), face,
          1};
}

/// The sign of the volume of the triangles whose points belong to a shell, exactly.
int sign_of_shell(mesh::MeshView view, std::span<const std::uint32_t> shell_of,
                  std::uint32_t shell) {
  std::vector<Triangle> triangles;
  for (const Triangle& t : view.triangles) {
    if (shell_of[t[0]] == shell) {
      triangles.push_back(t);
    }
  }
  view.triangles = triangles;
  return mesh::volume_sign(view);
}

}  // namespace

std::vector<std::uint32_t> shell_of_points(const mesh::ExactMesh& exact) {
  return connected_components(exact.triangles, exact.points.size());
}

std::vector<std::uint32_t> turned_shells(const mesh::MeshView& before,
                                         std::span<const std::uint32_t> shell_of,
                                         const mesh::MeshView& mesh, double largest_move) {
  std::vector<std::uint32_t> turned;
  const auto of_shells = sums_of_shells<Measures>(mesh.triangles, shell_of,
                                                  [&](std::uint32_t face, std::uint32_t shell) {
                                                    return measured(mesh, face, mesh.points[shell]);
                                                  });
  for (const auto& [shell, sums] : of_shells) {
    // The volume has changed by at most the area times the move, doubled for the area's own change.
    // The terms, n in number, are summed with errors below n 2^-52 of what they are made of.
    const double doubt = 6 * sums.area * largest_move +
                         sums.magnitude * static_cast<double>(sums.faces + 10) * 0x1p-52;
    if (!(std::abs(sums.volume) > doubt) &&
        sign_of_shell(mesh, shell_of, shell) != sign_of_shell(before, shell_of, shell)) {
      turned.push_back(sums.face);
    }
  }
  return turned;
}

std::vector<std::uint32_t> crossed_contacts(const mesh::MeshView& mesh,
                                            std::span<const std::uint32_t> representatives) {
  std::vector<std::uint8_t> is_shared(representatives.size(), 0);
  for (std::uint32_t point = 0; point < representatives.size(); ++point) {
    if (representatives[point] != point) {
      is_shared[point] = is_shared[representatives[point]] = 1;
    }
  }
  // More than two faces have an edge only where one of its ends is where others are.
  const auto marked = marked_faces(mesh.triangles, is_shared);
  const auto touching =
      support::indices_where(marked.size(), [&](std::uint32_t face) { return marked[face] != 0; });
  const auto triangles = support::selected(mesh.triangles, touching);
  mesh::MeshView view = mesh;
  view.triangles = triangles;
  std::vector<std::uint32_t> crossed;
  for (const mesh::ContactPlace& place : mesh::find_contacts(view, representatives)) {
    if (!place.alternating) {
      for (const std::uint32_t face : place.faces) {
        crossed.push_back(touching[face]);
      }
    }
  }
  return crossed;
}

std::size_t remove_small_shells(EditedMesh& mesh, const std::vector<std::uint32_t>& faces,
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

}  // namespace dupin::rounding
