#include "districts/box_cover.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace dupin::districts {
namespace {

/// What of the polygon lies on one side of a plane across an axis, or on it.
Polygon part_beyond(const Polygon& polygon, std::size_t axis, const mpq_class& at, bool is_above) {
  const auto height = [&](const std::array<mpq_class, 3>& p) -> mpq_class {
    return is_above ? mpq_class(p.at(axis) - at) : mpq_class(at - p.at(axis));
  };
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const mpq_class here = height(p), next = height(q);
    if (here >= 0) {
      part.push_back(p);
    }
    if (sgn(here) * sgn(next) < 0) {
      const mpq_class share = here / (here - next);
      std::array<mpq_class, 3> cut;
      for (std::size_t k = 0; k < 3; ++k) {
        cut.at(k) = p.at(k) + share * (q.at(k) - p.at(k));
      }
      part.push_back(std::move(cut));
    }
  }
  return part;
}

/// Appends what of the polygon is not in the interior of the box.
void append_rest(Polygon polygon, const Eigen::AlignedBox3d& box, std::vector<Polygon>& rest) {
  for (std::size_t axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    for (const auto& [side, is_above] : {std::pair(box.max()[k], true), {box.min()[k], false}}) {
      if (!std::isfinite(side)) {
        continue;
      }
      const mpq_class at(side);
      if (Polygon beyond = part_beyond(polygon, axis, at, is_above); !beyond.empty()) {
        rest.push_back(std::move(beyond));
      }
      polygon = part_beyond(polygon, axis, at, !is_above);
    }
  }
}

}  // namespace

bool is_covered(Polygon polygon, std::span<const Eigen::AlignedBox3d> boxes) {
  std::vector<Polygon> rest;
  rest.push_back(std::move(polygon));
  for (const Eigen::AlignedBox3d& box : boxes) {
    if (box.isEmpty()) {
      continue;
    }
    std::vector<Polygon> next;
    for (Polygon& piece : rest) {
      append_rest(std::move(piece), box, next);
    }
    rest = std::move(next);
  }
  return rest.empty();
}

}  // namespace dupin::districts
