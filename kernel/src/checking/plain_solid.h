#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dupin/kernel/check.h"
#include "dupin/kernel/mesh.h"

namespace dupin::checking {

/// What is learnt on the way of a mesh without any fault or contact.
struct PlainSolid {
  std::vector<std::uint8_t> stable;  ///< see SelfIntersections
  bool uses_all_points = false;
};

/// Whether a mesh is a solid that does not touch itself; none says that it is not, or that it has
/// to be looked at closely. Far quicker than inspect(), which names faults and measures. `margin`
/// is that of SelfIntersectionOptions. O(n log n) where boxes overlap O(1) others.
[[nodiscard]] std::optional<PlainSolid> plain_solid(const TriMesh& mesh, double margin);

/// The report of inspect() on a plain solid without loose points, if its triangles do not cross or
/// touch, which the caller knows. None says that it is not closed, not a manifold, turned the wrong
/// way, out of range or has loose points. All but O(n).
[[nodiscard]] std::optional<Report> plain_report(const TriMesh& mesh);

}  // namespace dupin::checking
