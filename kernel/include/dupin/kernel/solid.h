#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <gmpxx.h>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/source.h"

namespace dupin {

namespace mesh {
struct ExactMesh;
}

/// A bounded regularised point set with a triangulated boundary: closed, 2-manifold, oriented
/// outward, free of self-intersection (contacts apart), with exact coordinates. Nothing but
/// functions that establish this can make one. Immutable; O(1) to copy, which a move is, too.
class Solid {
 public:
  /// The empty set.
  Solid();
  // No moves: they would leave a solid without a mesh behind.
  Solid(const Solid&) = default;
  Solid& operator=(const Solid&) = default;
  ~Solid() = default;

  /// Establishes the invariant or throws Error{not_closed | not_manifold | not_oriented |
  /// self_intersecting | invalid_argument} naming the faces. O(n log n) for meshes whose triangles
  /// overlap boxes O(1) others.
  [[nodiscard]] static Solid from(const TriMesh& mesh);

  [[nodiscard]] bool empty() const;
  [[nodiscard]] std::size_t point_count() const;
  [[nodiscard]] std::size_t triangle_count() const;
  [[nodiscard]] const std::vector<Triangle>& triangles() const;
  /// The coordinates rounded to the nearest doubles, for display and measuring: the surface through
  /// them may cross itself (see to_mesh).
  [[nodiscard]] const std::vector<Vec3>& nearest_points() const;
  /// The very coordinates of a point; throws std::out_of_range.
  [[nodiscard]] std::array<mpq_class, 3> exact_point(std::uint32_t index) const;
  [[nodiscard]] mpq_class exact_volume() const;
  [[nodiscard]] double volume() const;       ///< the double nearest to exact_volume()
  [[nodiscard]] double area() const;         ///< relative error below 1e-12
  [[nodiscard]] std::size_t shells() const;  ///< connected pieces of the boundary
  [[nodiscard]] std::size_t components()
      const;  ///< connected pieces of the set: shells that bound from outside
  [[nodiscard]] std::int64_t euler_number() const;  ///< V - E + F of the whole boundary
  [[nodiscard]] std::int64_t genus() const;         ///< sum over the shells
  [[nodiscard]] const std::vector<Contact>& contacts() const;
  /// One entry per triangle; {0, i} for a solid made by `from`.
  [[nodiscard]] const std::vector<Source>& sources() const;
  /// One entry per triangle, an index into names(); empty when nothing is labelled.
  [[nodiscard]] const std::vector<std::uint32_t>& labels() const;
  [[nodiscard]] const std::vector<std::string>& names() const;  ///< each once

  /// For the kernel itself.
  explicit Solid(std::shared_ptr<const mesh::ExactMesh> mesh);
  [[nodiscard]] const mesh::ExactMesh& exact() const { return *mesh_; }

 private:
  std::shared_ptr<const mesh::ExactMesh> mesh_;
};

}  // namespace dupin
