#include "rounding/broken_share.h"

#include <algorithm>

namespace dupin::rounding {
namespace {

/// One triangle in so many is looked at, and so many needles among them, and such a part, are many.
constexpr std::size_t kSampled = 16, kManyNeedles = kManyFaults / kSampled;
constexpr double kNeedlePart = 1.0 / 32;

/// A fault for each so many triangles is no accident of single parts.
constexpr std::size_t kFaultPart = 16;

}  // namespace

bool is_full_of_needles(std::span<const Vec3> on_lattice, std::span<const Triangle> triangles) {
  std::size_t needles = 0;
  for (std::size_t f = 0; f < triangles.size(); f += kSampled) {
    const auto& [a, b, c] = triangles[f];
    const bool is_needle = on_lattice[a] == on_lattice[b] || on_lattice[b] == on_lattice[c] ||
                           on_lattice[c] == on_lattice[a];
    needles += is_needle ? 1 : 0;
  }
  const auto all = static_cast<double>(triangles.size());
  return needles >= kManyNeedles && static_cast<double>(needles * kSampled) >= kNeedlePart * all;
}

bool is_full_of_crossings(const FaultySurface& surface, double step) {
  const auto& [points, triangles, faults] = surface;
  if (faults.size() < kManyFaults || faults.size() < triangles.size() / kFaultPart) {
    return false;
  }
  std::size_t of_short_edges = 0;
  for (const Fault& fault : faults) {
    double shortest =
        (points[triangles[fault.first][0]] - points[triangles[fault.first][1]]).norm();
    for (const std::uint32_t face : {fault.first, fault.second}) {
      const auto& [a, b, c] = triangles[face];
      shortest = std::min({shortest, (points[a] - points[b]).norm(), (points[b] - points[c]).norm(),
                           (points[c] - points[a]).norm()});
    }
    of_short_edges += shortest <= step ? 1 : 0;
  }
  return 2 * of_short_edges < faults.size();
}

}  // namespace dupin::rounding
