#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include <gmpxx.h>

#include "dupin/kernel/solid.h"

/// Set operations by CGAL's Nef polyhedra: slow, general, and sharing no code with ours.
namespace dupin::test {

enum class NefOperation { unite, intersect, subtract };

struct NefResult {
  mpq_class volume;
  std::size_t components = 0;
  std::int64_t genus = 0;  ///< sum over the shells
};

/// Nothing if the result's boundary is not 2-manifold.
[[nodiscard]] std::optional<NefResult> by_nef(NefOperation operation, const Solid& a,
                                              const Solid& b);

/// Of reverse Polish notation: an operand's index, or what to do with the last two sets.
using NefStep = std::variant<std::size_t, NefOperation>;

/// The same for any expression; regularised once, at the end.
[[nodiscard]] std::optional<NefResult> by_nef(std::span<const NefStep> steps,
                                              std::span<const Solid> operands);

}  // namespace dupin::test
