#pragma once

#include <vector>

#include "contact.h"
#include "dupin/kernel/check.h"

namespace dupin::detail {

/// A report with what else was learnt on the way.
struct Inspection {
  Report report;
  std::vector<ContactPlace> contacts;
};

[[nodiscard]] Inspection inspect(const TriMesh& mesh, const CheckOptions& options);

}  // namespace dupin::detail
