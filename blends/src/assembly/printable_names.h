#pragma once

#include "dupin/blends/assembly.h"

namespace dupin::assembly {

/// Names of parts, of patches and of components are such that what is printed of them is what the
/// document says. Throws Error{invalid_argument} with the place of one that is not.
void require_printable_names(const Assembly& assembly);

}  // namespace dupin::assembly
