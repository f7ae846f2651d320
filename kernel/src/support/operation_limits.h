#pragma once

#include <cstddef>
#include <cstdint>

namespace dupin::support {

/// The other half of the index space is for the points of one face before they are numbered.
inline constexpr std::uint64_t kMostPoints = std::uint64_t{1} << 31;

/// Throws Error{limit_exceeded} for more points or triangles than indices can count.
void refuse_too_many(std::uint64_t points, std::uint64_t triangles);

/// Throws Error{limit_exceeded} if an arrangement of so many triangles, of which so many pairs
/// meet, is estimated to need more than `limit` bytes; a limit of 0 stands for the machine's
/// memory.
void refuse_too_large(std::uint64_t triangles, std::uint64_t intersections, std::uint64_t limit);

/// The same of the pairs whose boxes overlap, which are searched for those that meet.
void refuse_too_many_candidates(std::uint64_t triangles, std::uint64_t pairs, std::uint64_t limit);

/// Of more there is none that would not be refused.
[[nodiscard]] std::uint64_t most_candidates(std::uint64_t limit);

}  // namespace dupin::support
