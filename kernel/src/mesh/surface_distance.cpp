#include "mesh/surface_distance.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "support/blocks.h"
#include "support/bulk_vector.h"

namespace dupin::mesh {
namespace {

/// A triangle whose proof needs more parts counts as not near: so many, and more where much is
/// near.
constexpr std::size_t kMostParts = 4096, kMostPartsPerTriangle = 64;
/// Parts of more corners count more often: rounding may leave one as it is, but for a corner that
/// is there once more, time and again.
constexpr std::size_t kUsualCorners = 8;
/// Of parts with more triangles near, halves are looked at: all triangles would be, for each.
constexpr std::size_t kFew = 12;
/// A part may reach over its triangle's edges by this share of the distance: no slivers are left.
constexpr double kOverhang = 0.25;

using Faces = std::vector<std::uint32_t>;
using Polygon = std::vector<Vec3>;  // convex, of at least three corners

/// Leaves of a polygon what is above a plane, and returns the rest. Both have the corners that are
/// cut in common; either may be empty.
Polygon cut_off_below(Polygon& polygon, const Vec3& on, const Vec3& up, double height) {
  Polygon above, below;
  std::vector<double> heights;
  for (const Vec3& p : polygon) {
    heights.push_back((p - on).dot(up) - height);
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t k = (i + 1) % polygon.size();
    (heights[i] >= 0 ? above : below).push_back(polygon[i]);
    if ((heights[i] >= 0) != (heights[k] >= 0)) {
      const Vec3 cut =
          polygon[i] + heights[i] / (heights[i] - heights[k]) * (polygon[k] - polygon[i]);
      above.push_back(cut);
      below.push_back(cut);
    }
  }
  polygon = above.size() < 3 ? Polygon() : std::move(above);
  return below.size() < 3 ? Polygon() : below;
}

/// Cuts a polygon into parts that are near one triangle each.
class Cover {
 public:
  Cover(std::span<const Vec3> points, std::span<const Triangle> triangles, double distance,
        std::size_t near)
      : points_(points),
        triangles_(triangles),
        distance_(distance),
        most_parts_(kMostParts + kMostPartsPerTriangle * near) {}

  /// Whether every point of the part is near one of the triangles.
  [[nodiscard]] bool covers(const Polygon& part, const Faces& near) {
    parts_ += 1 + part.size() * part.size() / (kUsualCorners * kUsualCorners);
    if (is_far_ || parts_ > most_parts_) {
      return false;
    }
    const Vec3 middle = middle_of(part);
    double radius = 0;
    for (const Vec3& corner : part) {
      radius = std::max(radius, (corner - middle).norm());
    }
    Faces reached;
    double least = std::numeric_limits<double>::infinity(), best = least;
    for (const std::uint32_t f : near) {
      const double here = distance_to(f, middle);
      if (here > distance_ + radius) {
        continue;
      }
      if (here < best) {  // else one of the corners is further away, as the distance is convex
        best = std::min(best, farthest(part, f, best));
      }
      reached.push_back(f);
      if (here < least) {
        least = here;
        std::swap(reached.front(), reached.back());
      }
    }
    if (best <= distance_) {
      largest_ = std::max(largest_, best);
      return true;
    }
    is_far_ = least > distance_;
    return !is_far_ && ((reached.size() <= kFew && covers_by_first(part, reached)) ||
                        covers_halves(part, reached));
  }
  [[nodiscard]] double largest() const { return largest_; }

 private:
  [[nodiscard]] static Vec3 middle_of(const Polygon& part) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& corner : part) {
      sum += corner;
    }
    return sum / static_cast<double>(part.size());
  }
  [[nodiscard]] double distance_to(std::uint32_t f, const Vec3& p) const {
    const auto& [a, b, c] = triangles_[f];
    return (nearest_on_triangle(p, points_[a], points_[b], points_[c]) - p).norm();
  }
  /// The largest distance of a corner from a triangle, or something not below `enough`.
  [[nodiscard]] double farthest(const Polygon& part, std::uint32_t f, double enough) const {
    double most = 0;
    for (std::size_t i = 0; i < part.size() && most < enough; ++i) {
      most = std::max(most, distance_to(f, part[i]));
    }
    return most;
  }
  /// The first triangle covers what lies above it.
  [[nodiscard]] bool covers_by_first(const Polygon& part, const Faces& near) {
    Polygon above = part;
    std::vector<Polygon> beside;
    const Triangle& t = triangles_[near.front()];
    const Vec3 normal = (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]);
    for (std::size_t i = 0; i < 3 && !above.empty(); ++i) {
      const Vec3& a = points_[t[i]];
      const Vec3 inward = normal.cross(points_[t[(i + 1) % 3]] - a).normalized();
      Polygon rest = cut_off_below(above, a, inward, -kOverhang * distance_);
      if (!rest.empty()) {
        beside.push_back(std::move(rest));
      }
    }
    const double most = farthest(above, near.front(), std::numeric_limits<double>::infinity());
    if (above.empty() || most > distance_) {
      return false;
    }
    largest_ = std::max(largest_, most);
    return std::ranges::all_of(beside, [&](const Polygon& rest) { return covers(rest, near); });
  }
  /// Across the longest of the ways from one corner to another.
  [[nodiscard]] bool covers_halves(const Polygon& part, const Faces& near) {
    Vec3 longest = Vec3::Zero(), on = part.front();
    for (const Vec3& p : part) {
      for (const Vec3& q : part) {
        if ((q - p).squaredNorm() > longest.squaredNorm()) {
          longest = q - p;
          on = (p + q) / 2;
        }
      }
    }
    Polygon above = part;
    const Polygon below = cut_off_below(above, on, longest, 0);
    return !above.empty() && !below.empty() && covers(above, near) && covers(below, near);
  }

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  double distance_, largest_ = 0;
  std::size_t parts_ = 0, most_parts_;
  bool is_far_ = false;  // a point of the triangle is
};

}  // namespace

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
  return a + t * along;
}

Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, normal = u.cross(v);
  const double square = normal.squaredNorm();
  const Vec3 w = p - a;
  const double s = w.cross(v).dot(normal), t = u.cross(w).dot(normal);
  // An edge that the point is not beyond has no nearest place but its ends, which others have, too;
  // of triangles too thin to tell, all are looked at.
  const bool is_plane = square > 0;
  const bool beyond_ca = !is_plane || s < 0, beyond_ab = !is_plane || t < 0,
             beyond_bc = !is_plane || s + t > square;
  if (!beyond_ca && !beyond_ab && !beyond_bc) {
    return a + s / square * u + t / square * v;
  }
  Vec3 nearest = a;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const Vec3& from, const Vec3& to) {
    const Vec3 here = nearest_on_segment(p, from, to);
    if (const double distance = (here - p).squaredNorm(); distance < least) {
      least = distance;
      nearest = here;
    }
  };
  if (beyond_ab) {
    look(a, b);
  }
  if (beyond_bc) {
    look(b, c);
  }
  if (beyond_ca) {
    look(c, a);
  }
  return nearest;
}

ReferenceSurface::ReferenceSurface(std::span<const Vec3> points,
                                   std::span<const Triangle> triangles,
                                   std::span<const std::uint32_t> regions)
    : points_(points),
      triangles_(triangles),
      regions_(regions),
      frame_(points, triangles),
      tree_([&] {
        support::BulkVector<boxes::Box> boxes(triangles.size());
        support::for_each_block(boxes.size(), [&](const support::Block& block) {
          for (std::size_t i = block.begin; i < block.end; ++i) {
            const auto& [a, b, c] = triangles[i];
            boxes[i] = frame_.around(frame_.map(points[a], points[b], points[c]));
          }
        });
        return boxes::BoxTree(std::span<const boxes::Box>(boxes));
      }()) {}

Vec3 ReferenceSurface::nearest_on(std::uint32_t face, const Vec3& point) const {
  const auto& [a, b, c] = triangles_[face];
  return nearest_on_triangle(point, points_[a], points_[b], points_[c]);
}

std::optional<ReferenceSurface::Place> ReferenceSurface::nearest(const Vec3& point,
                                                                 std::uint32_t region,
                                                                 double reach) const {
  Place best;
  visit_near(point, reach, [&](std::uint32_t f, const Vec3& here, double distance) {
    if (regions_[f] == region &&
        (distance < best.distance || (distance == best.distance && f < best.face))) {
      best = {here, f, distance};
    }
  });
  return best.distance <= reach ? std::optional(best) : std::nullopt;
}

bool ReferenceSurface::looks_near(const std::array<Vec3, 3>& triangle, std::uint32_t region,
                                  double distance) const {
  const auto& [a, b, c] = triangle;
  return std::ranges::all_of(
      std::array<Vec3, 4>{(a + b + c) / 3, (a + b) / 2, (b + c) / 2, (c + a) / 2},
      [&](const Vec3& place) { return nearest(place, region, distance).has_value(); });
}

std::optional<double> ReferenceSurface::bound(const std::array<Vec3, 3>& triangle,
                                              std::uint32_t region, double distance) const {
  Faces near;
  const auto& [a, b, c] = triangle;
  tree_.visit(frame_.around(frame_.map(a, b, c), distance), [&](std::uint32_t f) {
    if (regions_[f] == region) {
      near.push_back(f);
    }
  });
  Cover cover(points_, triangles_, distance, near.size());
  if (!cover.covers({triangle[0], triangle[1], triangle[2]}, near)) {
    return std::nullopt;
  }
  return cover.largest();
}

}  // namespace dupin::mesh
