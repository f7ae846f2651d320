#pragma once

#include <optional>
#include <span>

#include "dupin/kernel/boolean.h"

namespace dupin::booleans {

/// The union of at least one solid by unions of few at a time, of neighbours first; of more where
/// all lie about axes in a plane through one point, around by angle. Each drops what lies inside of
/// it before the next looks at it, and merges what it leaves of one triangle of the operands
/// (arrangement/piece_merging.h), so that k solids that all meet each other cost about k^2 log k
/// instead of k^3.
///
/// The union of sets does not depend on how they are put in brackets, nor does its regularisation:
/// the closure of the interior of a union of regularised sets is the union of these. Contacts are
/// those of the last step, which sees the whole boundary. Throws like arrange().
[[nodiscard]] mesh::ExactMesh unite_in_steps(std::span<const Solid> operands,
                                             const BooleanOptions& options);

/// The same, of ten or more solids about axes in a plane whose centres lie nearer to each other
/// than they are thick; else nothing. That these crowd each other is told by where they lie, and
/// nothing is arranged to find it out.
[[nodiscard]] std::optional<mesh::ExactMesh> unite_close_fan(std::span<const Solid> operands,
                                                             const BooleanOptions& options);

}  // namespace dupin::booleans
