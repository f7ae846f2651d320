#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "dupin/blends/assembly.h"

namespace dupin {

/// The document `text` with the spheres and tangents of one chain as `chain` has them; every other
/// character, and every sphere that does not differ, stays as it was. Numbers are the shortest
/// decimals that read back to the same double. Throws as parse_assembly; the chain must be the
/// part's with as many spheres.
[[nodiscard]] std::string with_chain(std::string_view text, const std::string& source,
                                     std::uint32_t part, const CyclideChainThrough& chain);

}  // namespace dupin
