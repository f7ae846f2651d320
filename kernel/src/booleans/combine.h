#pragma once

#include <span>

#include "arrangement/arrange.h"
#include "dupin/kernel/boolean.h"

namespace dupin::booleans {

/// arrange() for solids, with the policies of the options. Throws Error{contact} besides, where
/// these refuse contacts.
[[nodiscard]] mesh::ExactMesh combine(std::span<const Solid> operands,
                                      const arrangement::BooleanRule& rule,
                                      const BooleanOptions& options);

}  // namespace dupin::booleans
