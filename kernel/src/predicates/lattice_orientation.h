#pragma once

#include <optional>

#include "dupin/kernel/vec.h"

namespace dupin::predicates {

/// The sign of det(b - a, c - a, p - a), by integers of fixed width: a few products, and no memory.
/// None if coordinates along some axis are no multiples of one power of two below 2^60 of them.
///
/// Lemma: scaling an axis by a positive power of two leaves the sign as it is, so each axis has a
/// unit of its own, the lowest bit set in its four coordinates, and differences are below 2^61 (see
/// exact::cross and exact::dot).
[[nodiscard]] std::optional<int> lattice_orientation(const Vec3& a, const Vec3& b, const Vec3& c,
                                                     const Vec3& p);

}  // namespace dupin::predicates
