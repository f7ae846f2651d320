#pragma once

#include <optional>

#include "dupin/blends/certificate.h"

namespace dupin::certification {

/// Proves or refutes the margin, or without one nearly the largest that holds, of all pieces and,
/// of a hollow chain, of both skins.
[[nodiscard]] RegularClaim prove_regular(const Chain& chain, std::optional<double> margin);

}  // namespace dupin::certification
