#pragma once

#include <optional>

#include "dupin/blends/resolve.h"

namespace dupin::assembly {

/// What is proven of a part's smooth surface; see PartReport.
struct PartMargins {
  std::optional<double> margin_lower, margin_upper;
  std::optional<double> start_tangency, end_tangency;
};

/// Throws Error{irregular_surface} for a surface that is not proven to be free of folds.
[[nodiscard]] PartMargins margins(const ResolvedPart& part);

}  // namespace dupin::assembly
