#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

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

}  // namespace dupin::test
