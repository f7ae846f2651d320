#pragma once

#include <span>
#include <string>

#include "exchange/exchange_model.h"
#include "occt/labelled_shape.h"

namespace dupin::occt {

/// The union of one shape or more: of `what`, as "its pieces". Throws Refusal about `at` where
/// OpenCASCADE fails.
[[nodiscard]] LabelledShape fused(std::span<const LabelledShape> all, const std::string& at,
                                  const std::string& what);

/// One shape without another, or what both have in common. Throws Refusal.
[[nodiscard]] LabelledShape combined(const LabelledShape& a, const LabelledShape& b,
                                     exchange::Operation operation);

}  // namespace dupin::occt
