#pragma once

#include <cstdint>
#include <vector>

#include "contact.h"
#include "dupin/kernel/check.h"

namespace dupin::detail {

/// A report with what else was learnt on the way.
struct Inspection {
  Report report;
  std::vector<ContactPlace> contacts;
  std::vector<std::uint8_t> steady;  ///< see SelfIntersections; of a solid
};

/// `margin` is that of SelfIntersectionOptions.
[[nodiscard]] Inspection inspect(const TriMesh& mesh, const CheckOptions& options,
                                 double margin = 0);

}  // namespace dupin::detail
