#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/check.h"
#include "mesh/self_contact.h"

namespace dupin::checking {

/// A report with what else was learnt on the way.
struct Inspection {
  Report report;
  std::vector<mesh::ContactPlace> contacts;
  std::vector<std::uint8_t> stable;  ///< see SelfIntersections; of a solid
};

/// `margin` is that of SelfIntersectionOptions.
[[nodiscard]] Inspection inspect(const TriMesh& mesh, const CheckOptions& options,
                                 double margin = 0);

}  // namespace dupin::checking
