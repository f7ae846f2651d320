#include "remeshing/reference_surface.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "support/blocks.h"
#include "support/bulk_vector.h"

namespace dupin::remeshing {
namespace {

/// Pieces are halved so often at most: to a thousandth of the triangle.
constexpr int kDeepest = 24;

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
  return a + t * along;
}

/// Some point of the triangle, rounding apart: the nearest. Rounding may make it another one, which
/// is further off.
Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, normal = u.cross(v);
  const double square = normal.squaredNorm();
  const Vec3 w = p - a;
  const double s = w.cross(v).dot(normal), t = u.cross(w).dot(normal);
  if (square > 0 && s >= 0 && t >= 0 && s + t <= square) {
    return a + s / square * u + t / square * v;
  }
  std::array<Vec3, 3> candidates = {nearest_on_segment(p, a, b), nearest_on_segment(p, b, c),
                                    nearest_on_segment(p, c, a)};
  return *std::ranges::min_element(candidates, {},
                                   [&](const Vec3& q) { return (q - p).squaredNorm(); });
}

}  // namespace

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

boxes::Box ReferenceSurface::around(const std::array<Vec3, 3>& triangle, double margin) const {
  return frame_.around(frame_.map(triangle[0], triangle[1], triangle[2]), margin);
}

std::optional<ReferenceSurface::Place> ReferenceSurface::nearest(const Vec3& point,
                                                                 std::uint32_t region,
                                                                 const Vec3& normal, double guess,
                                                                 double reach) const {
  for (double radius = guess;; radius = std::min(4 * radius, reach)) {
    Place best;
    tree_.visit(around({point, point, point}, radius), [&](std::uint32_t f) {
      if (regions_[f] != region) {
        return;
      }
      const auto& [a, b, c] = triangles_[f];
      if ((points_[b] - points_[a]).cross(points_[c] - points_[a]).dot(normal) < 0) {
        return;
      }
      const Vec3 here = nearest_on_triangle(point, points_[a], points_[b], points_[c]);
      const double distance = (here - point).norm();
      if (distance < best.distance || (distance == best.distance && f < best.face)) {
        best = {here, f, distance};
      }
    });
    if (best.distance <= radius) {
      return best;
    }
    if (radius >= reach) {
      return std::nullopt;
    }
  }
}

bool ReferenceSurface::is_within(const Vec3& point, std::uint32_t region, double distance) const {
  const boxes::FramedTriangle framed = frame_.map(point, point, point);
  return tree_.visit_until(
      frame_.around(framed, distance), {&framed, 1}, [&](std::uint32_t f, const boxes::Box&) {
        return regions_[f] == region &&
               (nearest_on(f, point) - point).squaredNorm() <= distance * distance;
      });
}

std::optional<double> ReferenceSurface::bound(const std::array<Vec3, 3>& triangle,
                                              std::uint32_t region, double distance) const {
  Faces near;
  tree_.visit(around(triangle, distance), [&](std::uint32_t f) {
    if (regions_[f] == region) {
      near.push_back(f);
    }
  });
  return bound(triangle, near, distance, 0);
}

std::optional<double> ReferenceSurface::bound(const std::array<Vec3, 3>& piece, const Faces& near,
                                              double distance, int depth) const {
  const auto& [a, b, c] = piece;
  const std::array<double, 3> edges = {(b - a).norm(), (c - b).norm(), (a - c).norm()};
  const double size = std::max({edges[0], edges[1], edges[2]});
  Faces nearer;
  double best = std::numeric_limits<double>::infinity();
  std::array<double, 3> least = {best, best, best};
  for (const std::uint32_t f : near) {
    std::array<double, 3> here{};
    for (std::size_t i = 0; i < 3; ++i) {
      here[i] = (nearest_on(f, piece[i]) - piece[i]).norm();
      least[i] = std::min(least[i], here[i]);
    }
    const auto [low, high] = std::minmax({here[0], here[1], here[2]});
    best = std::min(best, high);
    if (low <= distance + size) {
      nearer.push_back(f);
    }
  }
  if (best <= distance) {
    return best;
  }
  if (depth == kDeepest || std::max({least[0], least[1], least[2]}) > distance) {
    return std::nullopt;
  }
  const std::size_t k = edges[0] == size ? 0 : edges[1] == size ? 1 : 2;
  const Vec3 middle = (piece[k] + piece[(k + 1) % 3]) / 2;
  const Vec3& apex = piece[(k + 2) % 3];
  const auto first = bound({piece[k], middle, apex}, nearer, distance, depth + 1);
  if (!first) {
    return std::nullopt;
  }
  const auto second = bound({middle, piece[(k + 1) % 3], apex}, nearer, distance, depth + 1);
  return second ? std::optional(std::max(*first, *second)) : std::nullopt;
}

}  // namespace dupin::remeshing
