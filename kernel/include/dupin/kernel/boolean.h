#pragma once

#include <cstdint>
#include <span>

#include "dupin/kernel/progress.h"
#include "dupin/kernel/solid.h"

/// Set operations on solids. Each is a rule over one exact arrangement of all operands' surfaces at
/// once: how often each group of operands winds around a point says whether the point is inside
/// (union: at least once; intersection: as often as there are operands; difference: the first, and
/// none of the others). Regularised: what has no volume is not in the result. Expressions over
/// named operands are one rule too, in boolean_expression.h; the algorithm is in
/// kernel/src/arrangement/arrange.h. Where many operands of a union meet each other in the same
/// place, few are arranged at a time.
namespace dupin {

/// What to do where a result touches itself (see Contact).
enum class ContactPolicy {
  report,  ///< duplicate vertices, list the contacts in the result
  refuse,  ///< throw Error{contact}
};

struct BooleanOptions {
  ContactPolicy contacts = ContactPolicy::report;
  Progress progress;               ///< may be empty
  std::uint64_t memory_limit = 0;  ///< in bytes; 0: what the machine has
};

/// Exact set operations, regularised, with a result that does not depend on the order of operands
/// (but for its sources) nor on the number of threads. The result keeps exact coordinates; its
/// triangles know their source operand and triangle. Throws Error{contact | cancelled}, and
/// Error{limit_exceeded} for 2^31 points or triangles or more, or if an estimate made before
/// anything large is allocated is above the memory limit.
[[nodiscard]] Solid unite(std::span<const Solid> operands, const BooleanOptions& options = {});
[[nodiscard]] Solid intersect(std::span<const Solid> operands, const BooleanOptions& options = {});
/// `from` without the union of `operands`; in the sources, `from` is operand 0.
[[nodiscard]] Solid subtract(const Solid& from, std::span<const Solid> operands,
                             const BooleanOptions& options = {});

}  // namespace dupin
