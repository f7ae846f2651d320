#pragma once

#include <cstddef>
#include <span>

#include "arrangement/broad_phase.h"
#include "arrangement/input.h"

namespace dupin::arrangement {

/// Whether so many operands meet each other in the same places that most of their arrangement would
/// be inside of a union: k surfaces that all meet each other divide their faces by about k^3
/// segments and points, of which a union keeps k^2 at most. By the operands that the two of a
/// meeting pair both meet, on average; nothing is lost but time where this errs. Told from a sample
/// of the candidates (of broad_phase) that depends on where they are, not on any order. With fewer
/// in common than `many` they are not: arranged at once as fast, as operands are that hardly touch.
[[nodiscard]] bool crowded(const ArrangementInput& input, std::span<const TrianglePair> candidates,
                           std::size_t many = 8);

}  // namespace dupin::arrangement
