#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "support/bulk_vector.h"

namespace dupin::rounding {

/// A fault of the embedding: two triangles that meet where they should not, or, with first ==
/// second, a degenerate triangle.
struct Fault {
  std::uint32_t first = 0, second = 0;
  friend auto operator<=>(const Fault&, const Fault&) = default;
};

/// A mesh whose triangles should meet in common corners and edges only.
struct Embedding {
  std::span<const Vec3> points;
  std::span<const Triangle> triangles;
  std::span<const std::uint32_t> twins;  ///< per point the first of those it may coincide with
  std::span<const std::uint32_t> classes = {};  ///< see SelfIntersectionOptions
};

[[nodiscard]] bool is_degenerate(const Embedding& mesh, std::uint32_t face);

/// Whether two triangles, none of them degenerate, are a bad item.
[[nodiscard]] bool is_faulty_pair(const Embedding& mesh, std::uint32_t f, std::uint32_t g);

/// A mark per triangle: whether it has a marked point.
[[nodiscard]] support::BulkVector<std::uint8_t> marked_faces(
    std::span<const Triangle> triangles, std::span<const std::uint8_t> marked_points);

/// All bad items that involve a marked face. Twins must coincide.
[[nodiscard]] std::vector<Fault> find_faults(const Embedding& mesh,
                                             std::span<const std::uint8_t> marked);

}  // namespace dupin::rounding
