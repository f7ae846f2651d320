#include "checking/crowded_points.h"

#include <algorithm>

#include "boxes/bounds.h"
#include "boxes/box_quantizer.h"
#include "support/blocks.h"
#include "support/none.h"

namespace dupin::checking {
namespace {

/// More than what rounding of directions, and of sums and quotients of two, comes to.
constexpr double kRounding = 0x1p-48;

Vec3 direction(const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;  // exact but for one rounding, and not 0
  return (way / way.cwiseAbs().maxCoeff()).normalized();
}

/// Around the shorter arc between two directions. An arc of a right angle at most lies in the
/// triangle of its ends and the point where its tangents there meet.
Eigen::AlignedBox3d arc_bounds(const Vec3& from, const Vec3& to) {
  Eigen::AlignedBox3d box(from);
  box.extend(to);
  const double cosine = from.dot(to);
  if (cosine >= 0) {
    box.extend(Vec3((from + to) / (1 + cosine)));
    return box;
  }
  if (cosine > -0.5) {
    const Vec3 middle = (from + to).normalized();
    return arc_bounds(from, middle).merged(arc_bounds(middle, to));
  }
  return {Vec3::Constant(-1), Vec3::Constant(1)};
}

}  // namespace

std::vector<CrowdedPoint> crowded_points(std::span<const Triangle> triangles,
                                         std::span<const std::uint32_t> faces,
                                         std::size_t point_count,
                                         std::span<const std::uint8_t> excluded, std::size_t many) {
  std::vector<std::uint32_t> count(point_count, 0);
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : triangles[f]) {
      count[v] += excluded.empty() || excluded[v] == 0 ? 1 : 0;
    }
  }
  std::vector<CrowdedPoint> found;
  if (std::ranges::none_of(count,
                           [many](std::uint32_t faces_there) { return faces_there > many; })) {
    return found;
  }
  std::vector<std::uint32_t> place(point_count, support::kNone);
  for (std::uint32_t v = 0; v < point_count; ++v) {
    if (count[v] > many) {
      place[v] = static_cast<std::uint32_t>(found.size());
      found.push_back({v, {}});
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Triangle& t = triangles[faces[i]];
    const auto fullest = std::ranges::max(t, {}, [&](std::uint32_t v) { return count[v]; });
    if (place[fullest] != support::kNone) {
      found[place[fullest]].faces.push_back(faces[i]);
    }
  }
  return found;
}

support::BulkVector<boxes::Box> direction_boxes(std::span<const Vec3> points,
                                                std::span<const Triangle> triangles,
                                                const CrowdedPoint& crowded,
                                                std::span<const std::uint8_t> degenerate) {
  const Vec3& eye = points[crowded.point];
  std::vector<Vec3> lows(crowded.faces.size()), highs(crowded.faces.size());
  support::for_each_block(crowded.faces.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      if (degenerate[crowded.faces[i]] != 0) {
        continue;
      }
      const Triangle& t = triangles[crowded.faces[i]];
      const auto k = static_cast<std::size_t>(std::ranges::find(t, crowded.point) - t.begin());
      const auto arc = arc_bounds(direction(eye, points[t[(k + 1) % 3]]),
                                  direction(eye, points[t[(k + 2) % 3]]));
      lows[i] = arc.min() - Vec3::Constant(kRounding);
      highs[i] = arc.max() + Vec3::Constant(kRounding);
    }
  });
  std::vector<Vec3> corners = lows;
  corners.insert(corners.end(), highs.begin(), highs.end());
  const boxes::BoxQuantizer frame(corners);
  support::BulkVector<boxes::Box> boxes(crowded.faces.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i] = degenerate[crowded.faces[i]] != 0
                   ? boxes::Box::nothing()
                   : frame.around(frame.map(lows[i], highs[i], highs[i]));
  }
  return boxes;
}

}  // namespace dupin::checking
