#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/exact_mesh.h"
#include "rounding/edits/fault_tracker.h"
#include "support/bulk_vector.h"

namespace dupin::rounding {

/// Steps of the lattice by which what fills a slit goes on behind the sheet that it meets.
inline constexpr double kSlitOverlap = 4;

/// Tells which triangles of a solid show their fronts to each other, as those do that open slits
/// are between.
class FacingTriangles {
 public:
  FacingTriangles(const mesh::ExactMesh& solid, double step);
  [[nodiscard]] bool operator()(std::uint32_t first, std::uint32_t second) const;

 private:
  support::BulkVector<Vec3> normals_;  // of length 1; 0 of triangles lower than a step
};

/// A solid together with some of its open slits.
struct FilledSlits {
  mesh::ExactMesh mesh;
  std::vector<Vec3> places;  ///< a point in each
  double reach = 0;          ///< no place that was filled is farther from the solid
};

/// Fills narrow free spaces that are open to the outside, where two flat pieces of the surface face
/// each other so closely that rounding makes them cross: between parts whose ends were meant to
/// meet. One of the two, the smaller, is extended straight to a little behind the other, as if its
/// part were that much longer: a prism over the very triangles is united with the solid, exactly.
/// So nothing moves, and no two sheets are left nearly in one plane.
///
/// `faults` are those of the rounded mesh, at least of triangles that face each other, `step` is
/// the distance of neighbouring numbers. Slits are filled only where they are narrower than
/// `widest`. None if there are no such. Costs as much as a union with a few triangles.
[[nodiscard]] std::optional<FilledSlits> fill_open_slits(const mesh::ExactMesh& solid,
                                                         std::span<const Fault> faults, double step,
                                                         double widest);

}  // namespace dupin::rounding
