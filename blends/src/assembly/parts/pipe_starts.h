#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "dupin/blends/assembly.h"

namespace dupin::assembly {

/// One of two pipes that begins on the axis of the other one.
struct BranchStart {
  std::size_t branch = 0;  ///< which of them
  double at = 0;           ///< along the other one, from its start
  std::string tee = {};    ///< the entry that says both; empty of pipes that stand for themselves
  double run_length = 0;   ///< as the tee says it
};

/// How a document says where two pipes begin and end: what of it can be changed.
struct PipeStarts {
  std::array<std::array<std::string, 2>, 2> joined;  ///< the port at each end; empty if none
  std::optional<BranchStart> on = {};
};

/// Of these of Assembly::parts.
[[nodiscard]] PipeStarts pipe_starts(const Assembly& assembly,
                                     const std::array<std::uint32_t, 2>& parts);

}  // namespace dupin::assembly
