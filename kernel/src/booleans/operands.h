#pragma once

#include <map>
#include <string>
#include <vector>

#include "dupin/kernel/boolean_expression.h"

namespace dupin::booleans {

/// In the order of `expression.names()`. Throws Error{invalid_argument} if one is missing.
[[nodiscard]] std::vector<Solid> operands_of(const Expression& expression,
                                             const std::map<std::string, Solid>& operands);

}  // namespace dupin::booleans
