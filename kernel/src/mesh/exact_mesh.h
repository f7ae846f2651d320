#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <CGAL/Mpzf.h>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/source.h"
#include "mesh/exact_points.h"
#include "mesh/stable_face_groups.h"
#include "support/none.h"

/// Surfaces of triangles as the kernel keeps and reads them. A point is a double, or implicit:
/// exact in homogeneous coordinates (X, Y, Z, W), with its nearest double beside it. A half-edge 3f
/// + k runs from corner k of face f to the next; a fan is the faces around a point that hang
/// together by edges, a shell those that hang together at all; a contact is where a shell touches
/// itself or another (edge_table.h, self_contact.h). Volumes are sums of determinants over shells
/// (measure.h; ball_mesh.h, of what is thin), nesting is by rays (shell_nesting.h). Two tools ask
/// whoever holds the points for exact signs, and so serve the arrangement too: radial_order.h and
/// ray_crossing.h.
namespace dupin::mesh {

/// The boundary of a Solid. Points that doubles hold exactly come first; each of the rest is
/// followed up in `implicit`. Every point is a corner of a triangle.
struct ExactMesh {
  std::vector<Vec3>
      points;            ///< exact below double_count(), nearest doubles of the exact value above
  ExactPoints implicit;  ///< of points[double_count() + i]
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> labels;  ///< empty, or one per triangle, into names
  std::vector<std::string> names;
  std::vector<Source> sources;  ///< one per triangle
  std::vector<Contact> contacts;
  /// Triangles of the first operands, by corners, in whose planes triangles with implicit corners
  /// lie. New points are cut out by these planes, so that coordinates do not grow from one boolean
  /// operation to the next.
  std::vector<std::array<Vec3, 3>> planes;
  std::vector<std::uint32_t>
      plane_of;  ///< empty, or per triangle an index into planes or kOwnPlane
  StableFaceGroups stable;

  static constexpr std::uint32_t kOwnPlane = support::kNone;  ///< the plane through its corners

  [[nodiscard]] std::uint32_t double_count() const {
    return static_cast<std::uint32_t>(points.size() - implicit.size());
  }
};

/// What the measurements and the topology read of a mesh, whoever owns it. Indices are in range.
struct MeshView {
  std::span<const Vec3> points;
  std::span<const Triangle> triangles;
  const ExactPoints* implicit = nullptr;  ///< of the last points, if there are any

  MeshView(std::span<const Vec3> all_points, std::span<const Triangle> all_triangles)
      : points(all_points), triangles(all_triangles) {}
  explicit MeshView(const ExactMesh& mesh)
      : points(mesh.points),
        triangles(mesh.triangles),
        implicit(mesh.implicit.empty() ? nullptr : &mesh.implicit) {}

  [[nodiscard]] std::size_t double_count() const {
    return points.size() - (implicit != nullptr ? implicit->size() : 0);
  }
  [[nodiscard]] ExactPoint exact(std::uint32_t index) const {
    if (index >= double_count()) {
      return (*implicit)[index - double_count()];
    }
    return {points[index].x(), points[index].y(), points[index].z(), 1};
  }
  /// To about 100 bits; needs rounding upward in the calling thread.
  [[nodiscard]] exact::BallPoint ball(std::uint32_t index) const {
    if (index >= double_count()) {
      return ball_point(exact(index));
    }
    return {points[index].x(), points[index].y(), points[index].z()};
  }
};

/// The exact coordinates of a point of the mesh.
[[nodiscard]] ExactPoint exact_point(const ExactMesh& mesh, std::uint32_t index);

/// The double nearest to numerator / denominator (ties to even); denominator > 0.
[[nodiscard]] double nearest_double(const CGAL::Mpzf& numerator, const CGAL::Mpzf& denominator);

}  // namespace dupin::mesh
