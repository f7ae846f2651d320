#include "dupin/kernel/interior_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/edge_table.h"
#include "mesh/point_winding.h"
#include "mesh/shell_nesting.h"

namespace dupin {
namespace {

using mesh::MeshView;

constexpr int kTries = 16;

Vec3 corner(const MeshView& mesh, std::uint32_t face, std::size_t i) {
  return mesh.points[mesh.triangles[face][i]];
}

// Twice the area long, outward.
Vec3 normal(const MeshView& mesh, std::uint32_t face) {
  const Vec3 a = corner(mesh, face, 0);
  return (corner(mesh, face, 1) - a).cross(corner(mesh, face, 2) - a);
}

// Where a ray leaves the solid through the face, in lengths of its direction [MT97]; infinity if it
// does not.
double exit(const MeshView& mesh, std::uint32_t face, const Vec3& start, const Vec3& direction) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Vec3 a = corner(mesh, face, 0), u = corner(mesh, face, 1) - a,
             v = corner(mesh, face, 2) - a, across = direction.cross(v);
  const double determinant = u.dot(across);
  if (!(determinant < 0)) {
    return kNever;
  }
  const Vec3 from = start - a, along = from.cross(u);
  const double s = from.dot(across) / determinant, t = direction.dot(along) / determinant;
  const double distance = v.dot(along) / determinant;
  return s >= 0 && t >= 0 && s + t <= 1 && distance > 0 ? distance : kNever;
}

double squared_distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double length = way.squaredNorm();
  const double at = length > 0 ? std::clamp((point - from).dot(way) / length, 0.0, 1.0) : 0;
  return (point - from - at * way).squaredNorm();
}

double squared_distance(const MeshView& mesh, std::uint32_t face, const Vec3& point) {
  const Vec3 across = normal(mesh, face);
  double nearest = std::numeric_limits<double>::infinity();
  bool is_over = across.squaredNorm() > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = corner(mesh, face, i), b = corner(mesh, face, (i + 1) % 3);
    nearest = std::min(nearest, squared_distance_to_segment(point, a, b));
    is_over = is_over && across.cross(b - a).dot(point - a) >= 0;
  }
  if (!is_over) {
    return nearest;
  }
  const double height = across.dot(point - corner(mesh, face, 0));
  return height * height / across.squaredNorm();
}

// A component's boundary: its outer shell and those of its voids.
class Component {
 public:
  Component(const MeshView& mesh, std::span<const std::uint32_t> outer,
            std::vector<std::uint32_t> faces)
      : mesh_(mesh), outer_(outer), faces_(std::move(faces)) {}

  [[nodiscard]] std::optional<InteriorPoint> interior_point() const {
    std::optional<InteriorPoint> best;
    for (const std::uint32_t face : tried_faces()) {
      const auto place = halfway_from(face);
      if (!place || !has_inside(*place)) {
        continue;
      }
      const double clearance = distance_from(*place);
      if (!best || clearance > best->clearance) {
        best = InteriorPoint{*place, clearance};
      }
    }
    return best;
  }

 private:
  // Of the outer shell, after equal shares of its area.
  [[nodiscard]] std::vector<std::uint32_t> tried_faces() const {
    double total = 0;
    for (const std::uint32_t face : outer_) {
      total += normal(mesh_, face).norm();
    }
    std::vector<std::uint32_t> result;
    result.reserve(kTries);
    double seen = 0;
    for (const std::uint32_t face : outer_) {
      seen += normal(mesh_, face).norm();
      if (seen > (static_cast<double>(result.size()) + 0.5) * total / kTries) {
        result.push_back(face);
      }
    }
    return result;
  }

  // The middle of the way through the solid that begins in the middle of the face; none if rounding
  // leaves no such way.
  [[nodiscard]] std::optional<Vec3> halfway_from(std::uint32_t face) const {
    const Vec3 start =
        (corner(mesh_, face, 0) + corner(mesh_, face, 1) + corner(mesh_, face, 2)) / 3;
    const Vec3 direction = -normal(mesh_, face).normalized();
    double way = std::numeric_limits<double>::infinity();
    for (const std::uint32_t other : faces_) {
      if (other != face) {
        way = std::min(way, exit(mesh_, other, start, direction));
      }
    }
    return std::isfinite(way) ? std::optional<Vec3>(start + way / 2 * direction) : std::nullopt;
  }

  [[nodiscard]] bool has_inside(const Vec3& place) const {
    const bool is_clear = std::ranges::none_of(
        faces_, [&](std::uint32_t face) { return mesh::may_touch(mesh_, face, place); });
    return is_clear && mesh::winding_number(
                           mesh_, faces_,
                           {exact::exact_vector(place), 1, Eigen::AlignedBox3d(place, place)}) == 1;
  }

  [[nodiscard]] double distance_from(const Vec3& place) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t face : faces_) {
      nearest = std::min(nearest, squared_distance(mesh_, face, place));
    }
    return std::sqrt(nearest);
  }

  const MeshView& mesh_;
  std::span<const std::uint32_t> outer_;
  std::vector<std::uint32_t> faces_;
};

}  // namespace

std::vector<std::optional<InteriorPoint>> interior_points(const Rounded& solid) {
  const MeshView mesh(solid.mesh().points, solid.mesh().triangles);
  const mesh::Shells shells =
      mesh::shells(mesh.triangles.size(), mesh::EdgeTable(mesh.triangles, mesh.points.size()));
  const std::vector<int> depths = mesh::nesting_depths(mesh, shells);
  const mesh::ShellNest nest(mesh, shells);
  std::vector<std::optional<InteriorPoint>> result;
  for (std::size_t outer = 0; outer < shells.count; ++outer) {
    if (depths[outer] % 2 != 0) {
      continue;
    }
    std::vector<std::uint32_t> faces;
    for (std::size_t shell = 0; shell < shells.count; ++shell) {
      if (shell == outer || (depths[shell] == depths[outer] + 1 && nest.encloses(outer, shell))) {
        const auto own = shells.faces_of(shell);
        faces.insert(faces.end(), own.begin(), own.end());
      }
    }
    result.push_back(Component(mesh, shells.faces_of(outer), std::move(faces)).interior_point());
  }
  return result;
}

}  // namespace dupin
