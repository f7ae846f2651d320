#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::test {

/// The operands of a named arrangement of pipes; names ending in `_rot` are turned by an irrational
/// angle about an irrational axis. Throws std::out_of_range for a name that pipe_case_names() does
/// not list.
[[nodiscard]] std::vector<TriMesh> pipe_case(std::string_view name);

[[nodiscard]] std::vector<std::string> pipe_case_names();

}  // namespace dupin::test
