#pragma once

#include <optional>

#include "disc_sweep.h"

namespace dupin::detail {

/// Whoever checks a claim rounds in his own way: nothing is claimed that hangs on a smaller share.
constexpr double kDiscSlack = 0x1p-40;

/// A point inside discs at two places of the same part, if one is found.
[[nodiscard]] std::optional<Overlap> self_overlap(const DiscSweep& sweep);

/// A point inside discs of both parts, if one is found.
[[nodiscard]] std::optional<Overlap> overlap(const DiscSweep& first, const DiscSweep& second);

/// The centre of an end ring of either part that lies in an end ring of the other, exactly.
[[nodiscard]] std::optional<Overlap> contact(const DiscSweep& first, const DiscSweep& second);

}  // namespace dupin::detail
