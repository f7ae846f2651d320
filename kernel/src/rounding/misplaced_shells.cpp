#include "rounding/misplaced_shells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "mesh/shell_nesting.h"
#include "rounding/shell_sums.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

/// Sums over the triangles of a shell.
struct Measures {
  double volume = 0, magnitude = 0;  // six times, bounds of the terms
  double area = 0, perimeters = 0;   // two times or more, as much or more
  std::uint32_t face = 0;            // one of them
  std::size_t faces = 0;

  void add(const Measures& other) {
    volume += other.volume;
    magnitude += other.magnitude;
    area += other.area;
    perimeters += other.perimeters;
    face = other.face;
    faces += other.faces;
  }

  /// Of six times the volume: the terms, n in number, are summed with errors below n 2^-52 of what
  /// they are made of.
  [[nodiscard]] double error() const {
    return magnitude * static_cast<double>(faces + 10) * 0x1p-52;
  }
  /// 0 if that is in doubt.
  [[nodiscard]] int certain_sign() const {
    return !(std::abs(volume) > error()) ? 0 : volume > 0 ? 1 : -1;
  }
  /// Six times the volume, or more, of what is within `radius` of the triangles: half a cylinder
  /// around each edge and parts of a ball around each corner, beside what lies above and below.
  [[nodiscard]] double tube(double radius) const {
    constexpr double kHalfCylinder = 1.5708, kBall = 4.18880;  // pi / 2, 4 pi / 3, or more
    const double sum = radius * area + kHalfCylinder * radius * radius * perimeters +
                       kBall * radius * radius * radius * static_cast<double>(faces);
    return 6 * sum * (1 + 0x1p-20);
  }
};

Measures measured(const mesh::MeshView& mesh, std::uint32_t face, const Vec3& origin) {
  const Triangle& t = mesh.triangles[face];
  const Vec3 a = mesh.points[t[0]] - origin, u = mesh.points[t[1]] - mesh.points[t[0]],
             v = mesh.points[t[2]] - mesh.points[t[0]];
  const Vec3 normal = u.cross(v);
  const double along_u = u.lpNorm<1>(), along_v = v.lpNorm<1>();
  return {a.dot(normal),
          a.lpNorm<1>() * along_u * along_v,
          normal.lpNorm<1>(),
          2 * (along_u + along_v),
          face,
          1};
}

using MeasuresOfShells = std::map<std::uint32_t, Measures>;  // by lowest point

/// A triangle of each shell at a depth that its sign does not belong to. No shell has turned.
class DepthCheck {
 public:
  DepthCheck(const mesh::MeshView& mesh, const mesh::Shells& shells, const MeasuresOfShells& sums,
             double largest_move)
      : mesh_(mesh),
        shells_(shells),
        nest_(mesh, shells),
        measures_(shells.count),
        reach_(2 * largest_move * (1 + 0x1p-48)) {
    for (const auto& [point, of_shell] : sums) {
      measures_[shells.of_face[of_shell.face]] = of_shell;
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> misplaced() const {
    const std::vector<std::uint8_t> thin = thin_ones();
    std::vector<std::uint32_t> faces;
    for (std::size_t shell = 0; shell < measures_.size(); ++shell) {
      bool is_in_doubt = thin[shell] != 0;
      nest_.visit_boxes_around(
          shell, reach_, [&](std::size_t outer) { is_in_doubt = is_in_doubt || thin[outer] != 0; });
      if (is_in_doubt && sign(shell) != mesh::sign_at(nest_.depth(shell))) {
        faces.push_back(measures_[shell].face);
      }
    }
    return faces;
  }

 private:
  [[nodiscard]] int sign(std::size_t shell) const {
    if (const int certain = measures_[shell].certain_sign(); certain != 0) {
      return certain;
    }
    return mesh::volume_sign(
        {mesh_.points, support::selected(mesh_.triangles, shells_.faces_of(shell))});
  }

  /// Per shell 1 if it is not certain that right inside of it there was a place farther than the
  /// move from it, and from those shells that bounded the same region, which are of the other sign.
  /// What was inside then and is not now, or was that near, is now within twice the move of them.
  [[nodiscard]] std::vector<std::uint8_t> thin_ones() const {
    std::vector<double> rooms;
    for (std::size_t shell = 0; shell < measures_.size(); ++shell) {
      rooms.push_back(std::abs(measures_[shell].volume) - taken_by(shell));
    }
    for (std::size_t inner = 0; inner < measures_.size(); ++inner) {
      const double taken = std::abs(measures_[inner].volume) + taken_by(inner);
      nest_.visit_boxes_around(inner, reach_, [&](std::size_t outer) {
        if (measures_[inner].certain_sign() * measures_[outer].certain_sign() <= 0) {
          rooms[outer] -= taken;
        }
      });
    }
    std::vector<std::uint8_t> thin;
    std::ranges::transform(rooms, std::back_inserter(thin),
                           [](double room) { return room > 0 ? 0 : 1; });
    return thin;
  }
  [[nodiscard]] double taken_by(std::size_t shell) const {
    return measures_[shell].error() + measures_[shell].tube(reach_);
  }

  mesh::MeshView mesh_;
  const mesh::Shells& shells_;
  mesh::ShellNest nest_;
  std::vector<Measures> measures_;
  double reach_;
};

/// The signs of the volumes of some shells, which are given by their lowest points, ascending.
std::vector<int> volume_signs(const mesh::MeshView& mesh, std::span<const std::uint32_t> shell_of,
                              const std::vector<std::uint32_t>& shells) {
  std::vector<std::vector<Triangle>> triangles(shells.size());
  for (const Triangle& t : mesh.triangles) {
    const auto shell = std::ranges::lower_bound(shells, shell_of[t[0]]);
    if (shell != shells.end() && *shell == shell_of[t[0]]) {
      triangles[static_cast<std::size_t>(shell - shells.begin())].push_back(t);
    }
  }
  std::vector<int> signs;
  for (const std::vector<Triangle>& of_shell : triangles) {
    mesh::MeshView view = mesh;
    view.triangles = of_shell;
    signs.push_back(mesh::volume_sign(view));
  }
  return signs;
}

}  // namespace

std::vector<std::uint32_t> misplaced_shells(const mesh::MeshView& before,
                                            std::span<const std::uint32_t> shell_of,
                                            const mesh::MeshView& mesh, double largest_move) {
  const auto sums = sums_of_shells<Measures>(mesh.triangles, shell_of,
                                             [&](std::uint32_t face, std::uint32_t shell) {
                                               return measured(mesh, face, mesh.points[shell]);
                                             });
  std::vector<std::uint32_t> doubtful;  // that may be inside out
  for (const auto& [shell, measures] : sums) {
    // The volume has changed by at most the area times the move, doubled for the area's own change.
    const double doubt = 6 * measures.area * largest_move + measures.error();
    if (!(std::abs(measures.volume) > doubt)) {
      doubtful.push_back(shell);
    }
  }
  std::vector<std::uint32_t> turned;
  if (!doubtful.empty()) {
    const std::vector<int> signs_before = volume_signs(before, shell_of, doubtful),
                           signs = volume_signs(mesh, shell_of, doubtful);
    for (std::size_t i = 0; i < doubtful.size(); ++i) {
      if (signs[i] != signs_before[i]) {
        turned.push_back(sums.at(doubtful[i]).face);
      }
    }
  }
  if (!turned.empty() || sums.size() < 2) {
    return turned;
  }
  const mesh::Shells shells = mesh::shells_by_points(mesh.triangles, shell_of);
  return DepthCheck(mesh, shells, sums, largest_move).misplaced();
}

}  // namespace dupin::rounding
