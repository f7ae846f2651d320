#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::test {

/// The operands of a named arrangement of pipes; names ending in `_rot` are turned by an irrational
/// angle about an irrational axis. Besides those listed, `star_K`, `star_general_K` and `coaxial_K`
/// have K pipes: through one point, about axes in a plane or in space, or about one axis. Throws
/// std::out_of_range for other names.
[[nodiscard]] std::vector<TriMesh> pipe_case(std::string_view name);

[[nodiscard]] std::vector<std::string> pipe_case_names();

}  // namespace dupin::test
