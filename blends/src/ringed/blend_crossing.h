#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "dupin/blends/ringed_surface.h"

namespace dupin::ringed {

inline constexpr std::string_view kCrossesItself = "crosses itself";

/// What a regular blend with this margin runs into, in words that follow "the blend": itself, or
/// what would go straight on behind one of its ends, however far; none where nothing was found. By
/// samples an eighth of the radius apart, for what is proposed only: nothing is proved.
[[nodiscard]] std::optional<std::string> crossing(const RingedSurface& blend, double margin);

}  // namespace dupin::ringed
