#pragma once

#include "exchange/exchange_model.h"
#include "occt/labelled_shape.h"

namespace dupin::occt {

/// The body as one solid, its faces sharing edges and vertices. Throws Refusal.
[[nodiscard]] LabelledShape solid_of(const exchange::Body& body);

}  // namespace dupin::occt
