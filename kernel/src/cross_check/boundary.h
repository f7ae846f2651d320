#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <gmpxx.h>

#include "dupin/kernel/vec.h"
#include "mesh/exact_mesh.h"

// This folder: the same operation by CGAL's own engines, Nef polyhedra and corefinement, and an
// exact comparison of what came out. It is the only one that sees CGAL's GPL packages, and is left
// out by -D DUPIN_CROSS_CHECK=OFF; nothing includes it but dupin/kernel/cross_check.h's
// implementation. Engines take an expression in reverse Polish notation (postfix.h), and give a
// boundary: of rational points, cut up as the engine likes, so that results are compared as sets
// and not as meshes.

namespace dupin::cross_check {

using RationalPoint = std::array<mpq_class, 3>;
using DirectedEdge = std::array<std::uint32_t, 2>;

/// The boundary of a bounded regularised set, whatever engine made it: flat facets that may have
/// holes and be cut up in any way. It need not be a 2-manifold.
struct Boundary {
  std::vector<RationalPoint> points;  ///< may hold the same place more than once
  /// The directed edges around each facet, counter-clockwise seen from outside, around holes
  /// clockwise.
  std::vector<std::vector<DirectedEdge>> facets;
};

[[nodiscard]] Boundary boundary_of(const mesh::ExactMesh& mesh);

[[nodiscard]] mpq_class volume(const Boundary& boundary);

/// A corner of the symmetric difference of two sets, the first in the order of coordinates; nothing
/// if they are the same. Exact, O(n log n).
///
/// Take the facets of a and those of b with the opposite sign, as a chain with integer
/// coefficients. The sets are the same exactly if it is zero. A chain of facets is zero if it is in
/// each plane; in a plane (or on a line) a bounded chain is zero if its boundary is, because a
/// function without jumps is constant, and far away it is zero. So it is zero exactly if, on each
/// line in each plane, as many edges end in each point as start there. Where they do not, both sets
/// differ in any neighbourhood of the point. No facet is ever cut, no angle sorted, and neither
/// engine's code is used.
[[nodiscard]] std::optional<RationalPoint> corner_of_difference(const Boundary& a,
                                                                const Boundary& b);

}  // namespace dupin::cross_check
