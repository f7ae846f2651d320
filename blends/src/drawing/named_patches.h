#pragma once

#include <map>
#include <string>

#include "dupin/blends/resolve.h"
#include "shading/patch_table.h"

namespace dupin::drawing {

/// Adds what the parts, fillets and hubs of an assembly are, with the discs of its ends and the
/// rims of its walls, under the names that `build` gives their triangles, or those that `renamed`
/// has for these. O(n log n).
void add_patches(const ResolvedAssembly& assembly,
                 const std::map<std::string, std::string>& renamed, shading::PatchTable& table);

}  // namespace dupin::drawing
