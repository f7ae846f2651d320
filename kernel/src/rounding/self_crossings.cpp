#include "rounding/self_crossings.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "arrangement/arrange.h"
#include "dupin/kernel/connected_components.h"
#include "healing/degenerate_faces.h"
#include "healing/polygon_soup.h"
#include "mesh/surface_distance.h"
#include "support/blocks.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

using arrangement::OutsideSheets;
using Corners = std::array<Vec3, 3>;

/// A bound of how far triangles are from the solid, by parts that are near one of its triangles
/// each: the distance from that is a convex function. Quicker to give up than
/// mesh::ReferenceSurface::bound, which looks for minutes at sheets that are far from all.
class SheetDistance {
 public:
  explicit SheetDistance(const mesh::ReferenceSurface& solid) : solid_(solid) {}

  /// The first of growing distances that can be proved, or less; none if that is none up to `most`.
  [[nodiscard]] std::optional<double> of(const Corners& sheet, double step, double most) const {
    constexpr double kGrowth = 4;
    for (double distance = std::min(step, most); distance > 0;
         distance = distance < most ? std::min(kGrowth * distance, most) : 0) {
      if (const auto bound = at_most(sheet, distance)) {
        return bound;
      }
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kMostParts = 512;  // of a sheet

  [[nodiscard]] std::optional<double> at_most(const Corners& sheet, double distance) const {
    std::vector<Corners> parts{sheet};
    double largest = 0;
    for (std::size_t looked_at = 0; !parts.empty(); ++looked_at) {
      const Corners part = parts.back();
      parts.pop_back();
      const Vec3 middle = (part[0] + part[1] + part[2]) / 3;
      const auto nearest = solid_.nearest(middle, 0, distance);
      if (!nearest || looked_at == kMostParts) {
        return std::nullopt;
      }
      const double farthest = farthest_corner(part, solid_.corners(nearest->face));
      if (farthest <= distance) {
        largest = std::max(largest, farthest);
      } else {
        append_halves(part, parts);
      }
    }
    return largest;
  }
  [[nodiscard]] static double farthest_corner(const Corners& part, const Corners& face) {
    double farthest = 0;
    for (const Vec3& p : part) {
      const Vec3 there = mesh::nearest_on_triangle(p, face[0], face[1], face[2]);
      farthest = std::max(farthest, (there - p).norm());
    }
    return farthest;
  }
  static void append_halves(const Corners& part, std::vector<Corners>& parts) {
    std::size_t longest = 0;
    const auto length = [&](std::size_t i) { return (part[(i + 1) % 3] - part[i]).squaredNorm(); };
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
      longest = length(i) > length(longest) ? i : longest;
    }
    const Vec3 &from = part[longest], &to = part[(longest + 1) % 3],
               &apex = part[(longest + 2) % 3];
    const Vec3 between = from / 2 + to / 2;
    parts.push_back({from, between, apex});
    parts.push_back({between, to, apex});
  }

  const mesh::ReferenceSurface& solid_;
};

/// How far from the solid the sheets are, at most; none if that may be more than `most`.
std::optional<double> distance_of(const OutsideSheets& sheets, const mesh::ExactMesh& solid,
                                  double step, double most) {
  if (sheets.triangles.empty()) {
    return 0;
  }
  // Of a place in a sheet, and of one of the solid, as of its nearest doubles.
  const double error = 2 * std::sqrt(3.0) * sheets.error;
  const std::vector<std::uint32_t> one_region(solid.triangles.size(), 0);
  const mesh::ReferenceSurface surface(solid.points, solid.triangles, one_region);
  const SheetDistance distance(surface);
  std::vector<double> bounds(sheets.triangles.size(), 0);
  std::atomic<bool> is_too_far{false};
  support::for_each_in_parallel(sheets.triangles.size(), [&](std::size_t i) {
    if (!is_too_far) {
      const auto bound = distance.of(sheets.triangles[i], step, most - error);
      bounds[i] = bound.value_or(0);
      is_too_far = is_too_far || !bound;
    }
  });
  const double largest = *std::ranges::max_element(bounds);
  constexpr double kRounding = 0x1p-40;  // of distances, and of where triangles are cut for them
  return is_too_far ? std::nullopt : std::optional(largest * (1 + kRounding) + error);
}

/// Shells of which there are sheets outside of the solid, and nothing else.
std::size_t lost_shells(const TriMesh& surface, const OutsideSheets& outside,
                        const mesh::ExactMesh& solid) {
  if (outside.triangles.empty()) {
    return 0;
  }
  const std::vector<std::uint32_t> shell_of =
      connected_components(surface.triangles, surface.points.size());
  const auto shell = [&](std::uint32_t face) { return shell_of[surface.triangles[face][0]]; };
  std::vector<std::uint8_t> is_left(surface.points.size(), 0);
  for (const Source& source : solid.sources) {
    is_left[shell(source.triangle)] = 1;
  }
  std::vector<std::uint32_t> lost;
  for (const std::uint32_t face : outside.sources) {
    if (is_left[shell(face)] == 0) {
      lost.push_back(shell(face));
    }
  }
  support::sort_unique(lost);
  return lost.size();
}

}  // namespace

std::optional<CutSurface> without_self_crossings(const TriMesh& surface,
                                                 std::span<const Source> sources,
                                                 std::span<const Fault> faults, double step,
                                                 double most) {
  std::vector<std::uint8_t> is_faulty(surface.triangles.size(), 0);
  for (const Fault& fault : faults) {
    is_faulty[fault.first] = is_faulty[fault.second] = 1;
  }
  healing::PolygonSoup soup = healing::merge_duplicate_points(surface).soup;
  healing::drop_degenerate_faces(soup);
  auto [solid, outside] = healing::wound_surface(soup, surface, is_faulty);
  if (solid.triangles.empty()) {
    return std::nullopt;
  }
  const auto lost = distance_of(outside, solid, step, most);
  if (!lost) {
    return std::nullopt;
  }
  CutSurface result{{}, *lost, lost_shells(surface, outside, solid)};
  result.solid = std::move(solid);
  for (Source& source : result.solid.sources) {
    source = sources[source.triangle];
  }
  return result;
}

}  // namespace dupin::rounding
