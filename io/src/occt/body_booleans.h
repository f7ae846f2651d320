#pragma once

#include <vector>

#include "exchange/exchange_model.h"
#include "occt/labelled_shape.h"

namespace dupin::occt {

/// The bodies as one shape, which may be several solids; filleted where balls roll. Throws Refusal
/// where OpenCASCADE fails, naming the body or the fillet.
[[nodiscard]] LabelledShape united(const exchange::BodyUnion& bodies);

}  // namespace dupin::occt
