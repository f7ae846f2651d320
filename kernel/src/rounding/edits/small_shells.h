#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rounding/edits/edited_mesh.h"

namespace dupin::rounding {

/// Removes the shells of the given faces that lie within `reach` of one of their points. Returns
/// their number.
std::size_t remove_small_shells(EditedMesh& mesh, const std::vector<std::uint32_t>& faces,
                                double reach);

}  // namespace dupin::rounding
