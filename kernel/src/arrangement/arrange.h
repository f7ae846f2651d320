#pragma once

#include <span>

#include "arrangement/input.h"
#include "dupin/kernel/boolean.h"

namespace dupin::arrangement {

/// The boundary of the set that `rule` makes of the operands: one exact arrangement of all their
/// surfaces, each part of them kept where the rule tells its two sides apart.
///
/// Operands are closed and oriented and do not intersect themselves (contacts apart). Deterministic
/// whatever the number of threads. `memory_limit` is in bytes, 0 for the machine's. Throws
/// Error{limit_exceeded | cancelled | boolean_failed}.
[[nodiscard]] mesh::ExactMesh arrange(std::span<const mesh::ExactMesh* const> operands,
                                      const BooleanRule& rule, const Progress& progress = {},
                                      std::uint64_t memory_limit = 0);

/// The same for solids, with the policies of the options. Throws Error{contact} besides, where
/// these refuse contacts.
[[nodiscard]] mesh::ExactMesh arrange(std::span<const Solid> operands, const BooleanRule& rule,
                                      const BooleanOptions& options);

/// The boundary of the points that a surface winds around a positive number of times. It is closed
/// (each edge is run along as often one way as the other) and has no degenerate or duplicate
/// triangles, but may cross and cover itself. Throws like arrange().
[[nodiscard]] mesh::ExactMesh positive_winding_boundary(const mesh::ExactMesh& surface,
                                                        const Progress& progress = {});

/// Inside any, inside all, inside the first but none of the others.
[[nodiscard]] BooleanRule union_rule(std::size_t operands);
[[nodiscard]] BooleanRule intersection_rule(std::size_t operands);
[[nodiscard]] BooleanRule difference_rule(std::size_t operands);

}  // namespace dupin::arrangement
