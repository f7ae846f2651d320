#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dupin/blends/build.h"
#include "tiles/district_output.h"

namespace dupin::cli {

/// What is made of one district: what became of its parts, and its facets.
struct DistrictResult {
  Built built;  ///< without its solid
  DistrictOutput output;
};

/// Of a piece that cannot be made with its ends at these seams: nothing.
[[nodiscard]] inline DistrictResult unfit_result(std::span<const Seam> seams) {
  return {{}, unfit_output(seams.size())};
}

/// It as bytes, to be kept or sent. Parts are told by their places among `parts`, ascending, so
/// that a document may count them otherwise later. Findings of its check, which is that of a solid,
/// and a cross-check do not go along.
[[nodiscard]] std::string bytes_of(const DistrictResult& result,
                                   const std::vector<std::uint32_t>& parts);

/// The result of these bytes; none if they are damaged, or of another kind.
[[nodiscard]] std::optional<DistrictResult> result_of(std::string bytes,
                                                      const std::vector<std::uint32_t>& parts);

}  // namespace dupin::cli
