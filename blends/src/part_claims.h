#pragma once

#include <optional>

#include "dupin/blends/resolve.h"

namespace dupin::detail {

/// What is proven of a part's smooth surface; see PartReport.
struct PartClaims {
  std::optional<double> margin_lower, margin_upper;
  std::optional<double> start_tangency, end_tangency;
};

/// Throws Error{irregular_surface} for a surface that is not proven to be free of folds.
[[nodiscard]] PartClaims claims(const ResolvedPart& part);

}  // namespace dupin::detail
