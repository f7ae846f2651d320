#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "arrangement/arrange.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/boolean_expression.h"

namespace dupin::booleans {

/// arrange() for solids, with the policies of the options.
[[nodiscard]] Solid combine(std::span<const Solid> operands, const arrangement::BooleanRule& rule,
                            const BooleanOptions& options);

/// In the order of `expression.names()`. Throws Error{invalid_argument} if one is missing.
[[nodiscard]] std::vector<Solid> operands_of(const Expression& expression,
                                             const std::map<std::string, Solid>& operands);

}  // namespace dupin::booleans
