#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dupin::mesh {

/// Leaves each name once, in the order of their first places, and makes labels of one name one.
void unite_names(std::vector<std::string>& names, std::span<std::uint32_t> labels);

}  // namespace dupin::mesh
