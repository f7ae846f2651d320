#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arrangement/broad_phase.h"
#include "arrangement/input.h"

namespace dupin::arrangement {

/// In common of a meeting pair, from which on they crowd each other.
inline constexpr std::size_t kManyInCommon = 8;

/// Whether so many operands meet each other in the same places that most of their arrangement would
/// be inside of a union: k surfaces that all meet each other divide their faces by about k^3
/// segments and points, of which a union keeps k^2 at most. By the operands that the two of a
/// meeting pair both meet, on average; nothing is lost but time where this errs. Told from a sample
/// of the candidates (of broad_phase) that depends on where they are, not on any order. With fewer
/// in common than `many` they are not: arranged at once as fast, as operands are that hardly touch.
[[nodiscard]] bool crowded(const ArrangementInput& input, std::span<const TrianglePair> candidates,
                           std::size_t many = kManyInCommon);

/// Whether a handful of operands, fewer than can be crowded(), meet each other so that most of
/// their arrangement would be points in their faces where others cross (face_crossings.h): these
/// are dearer than to unite the operands in steps.
[[nodiscard]] bool are_faces_crowded(const ArrangementInput& input,
                                     std::span<const TrianglePair> candidates);

/// How many operands the two of a meeting pair both meet, on average.
[[nodiscard]] double operands_in_common(const ArrangementInput& input,
                                        std::span<const TrianglePair> candidates);

/// An operand and some of those whose boxes touch its own.
struct OperandSample {
  std::vector<std::uint32_t> operands;
  double times = 1;  ///< so many of them there are for each that is here
};

/// Two of these, with `most` others each: around one that has more neighbours than a quarter of all
/// have, and around one that has more than three quarters. None if the first has not so many.
[[nodiscard]] std::vector<OperandSample> samples_around(const ArrangementInput& input,
                                                        std::size_t most);

}  // namespace dupin::arrangement
