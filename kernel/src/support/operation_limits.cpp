#include "support/operation_limits.h"

#include <string>

#include <unistd.h>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::support {
namespace {

// Rounded up from the peaks that boolean_bench reports, operands not counted: untouched triangles
// are stored, boxed and copied (100 bytes); each meeting of two makes a segment, a point and up to
// six new triangles (280 to 870 bytes in racks, headers and chains).
constexpr std::uint64_t kBytesPerTriangle = 200, kBytesPerIntersection = 1000;
// Pairs of boxes that overlap are there twice when they are joined.
constexpr std::uint64_t kBytesPerCandidate = 16;

std::uint64_t machine_memory() {
  return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

double megabytes(std::uint64_t bytes) { return double(bytes) / 1e6; }

// `which` of them, in words that follow the triangles.
void refuse_beyond(std::uint64_t limit, std::uint64_t needed, std::uint64_t triangles,
                   const std::string& which) {
  const std::uint64_t allowed = limit == 0 ? machine_memory() : limit;
  if (needed > allowed) {
    throw Error(Errc::limit_exceeded,
                "the boolean operation on " + std::to_string(triangles) + " triangles" + which +
                    " would need about " + decimal_at_most(megabytes(needed)) +
                    " MB of memory; allowed are " + decimal_at_least(megabytes(allowed)) + " MB");
  }
}

}  // namespace

void refuse_too_many(std::uint64_t points, std::uint64_t triangles) {
  if (points >= kMostPoints || triangles >= kMostPoints) {
    throw Error(Errc::limit_exceeded, "the operands have " + std::to_string(points) +
                                          " points and " + std::to_string(triangles) +
                                          " triangles; a boolean operation takes fewer than " +
                                          std::to_string(kMostPoints) + " of each");
  }
}

void refuse_too_large(std::uint64_t triangles, std::uint64_t intersections, std::uint64_t limit) {
  refuse_beyond(
      limit, kBytesPerTriangle * triangles + kBytesPerIntersection * intersections, triangles,
      intersections == 0 ? "" : ", of which " + std::to_string(intersections) + " pairs meet,");
}

void refuse_too_many_candidates(std::uint64_t triangles, std::uint64_t pairs, std::uint64_t limit) {
  refuse_beyond(limit, kBytesPerTriangle * triangles + kBytesPerCandidate * pairs, triangles,
                ", of whose boxes " + std::to_string(pairs) + " pairs overlap,");
}

std::uint64_t most_candidates(std::uint64_t limit) {
  return (limit == 0 ? machine_memory() : limit) / kBytesPerCandidate;
}

}  // namespace dupin::support
