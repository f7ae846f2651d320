#include "text/polygon.h"

#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <gmpxx.h>

#include "dupin/kernel/error.h"

namespace dupin::text {
namespace {

using Point2 = std::array<double, 2>;

/// Sign of twice the area of a, b, c: positive when counter-clockwise.
int orientation(const Point2& a, const Point2& b, const Point2& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]);
  const double right = (a[1] - c[1]) * (b[0] - c[0]);
  const double determinant = left - right;
  // Shewchuk (1997), ccwerrboundA: |error| <= (3 + 16 u) u (|left| + |right|) with u = 2^-53 unless
  // a product underflows, which adds less than DBL_MIN each.
  const double bound = 2 * DBL_EPSILON * (std::abs(left) + std::abs(right)) + 2 * DBL_MIN;
  if (std::abs(determinant) > bound) {
    return determinant > 0 ? 1 : -1;
  }
  const mpq_class cx(c[0]);
  const mpq_class cy(c[1]);
  return sgn(mpq_class((a[0] - cx) * (b[1] - cy) - (a[1] - cy) * (b[0] - cx)));
}

/// Sign of the signed area of a closed polygon.
int orientation(const std::vector<Point2>& polygon) {
  double area = 0;
  double magnitude = 0;
  const std::size_t size = polygon.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % size];
    area += a[0] * b[1] - a[1] * b[0];
    magnitude += std::abs(a[0] * b[1]) + std::abs(a[1] * b[0]);
  }
  // A sum of 2n products, each through at most n + 2 roundings: error <= (n + 3) u magnitude to
  // first order, and DBL_MIN for each product that underflows; twice that is safe.
  const double terms = static_cast<double>(size) + 3;
  if (std::abs(area) > terms * DBL_EPSILON * magnitude + 2 * terms * DBL_MIN) {
    return area > 0 ? 1 : -1;
  }
  mpq_class exact = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % size];
    exact += mpq_class(a[0]) * b[1] - mpq_class(a[1]) * b[0];
  }
  return sgn(exact);
}

/// The polygon in the coordinate plane across its area vector's largest component, mirrored if
/// need be so that it runs counter-clockwise.
std::vector<Point2> projected(std::span<const std::uint32_t> corners,
                              const std::vector<Vec3>& points) {
  Vec3 area = Vec3::Zero();
  const Vec3& origin = points[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3 u = points[corners[i]] - origin;
    const Vec3 v = points[corners[i + 1]] - origin;
    area += Vec3(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(),
                 u.x() * v.y() - u.y() * v.x());
  }
  Eigen::Index across = 0;
  area.cwiseAbs().maxCoeff(&across);
  std::vector<Point2> polygon;
  polygon.reserve(corners.size());
  for (const std::uint32_t corner : corners) {
    polygon.push_back({points[corner][(across + 1) % 3], points[corner][(across + 2) % 3]});
  }
  if (orientation(polygon) < 0) {
    for (Point2& point : polygon) {
      std::swap(point[0], point[1]);
    }
  }
  return polygon;
}

/// The corners not yet cut off, as a ring.
class EarClipper {
 public:
  EarClipper(std::span<const std::uint32_t> corners, std::vector<Point2> polygon,
             std::vector<Triangle>& triangles)
      : corners_(corners),
        polygon_(std::move(polygon)),
        triangles_(triangles),
        next_(polygon_.size()),
        previous_(polygon_.size()),
        turn_(polygon_.size()) {
    const std::size_t size = polygon_.size();
    for (std::size_t i = 0; i < size; ++i) {
      next_[i] = (i + 1) % size;
      previous_[(i + 1) % size] = i;
    }
    for (std::size_t i = 0; i < size; ++i) {
      update(i);
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (turn_[i] <= 0) {
        blockers_.push_back(i);
      }
    }
  }

  void clip() {
    std::size_t left = polygon_.size();
    std::size_t corner = 0;
    std::size_t tried = 0;  // after a full turn without an ear the polygon is not simple: just cut
    while (left > 3) {
      if (tried < left && !is_ear(corner)) {
        corner = next_[corner];
        ++tried;
        continue;
      }
      emit(corner);
      const std::size_t before = previous_[corner];
      const std::size_t after = next_[corner];
      next_[before] = after;
      previous_[after] = before;
      update(before);
      update(after);
      turn_[corner] = kGone;
      corner = after;
      tried = tried < left ? 0 : left;
      --left;
    }
    emit(corner);
  }

 private:
  static constexpr int kGone = 2;

  void update(std::size_t i) {
    turn_[i] = orientation(polygon_[previous_[i]], polygon_[i], polygon_[next_[i]]);
  }

  void emit(std::size_t i) {
    triangles_.push_back({corners_[previous_[i]], corners_[i], corners_[next_[i]]});
  }

  /// Strictly convex, and no other corner in its closed triangle. Only corners that were reflex or
  /// straight at the start can lie in it, for clipping ears makes no convex corner reflex.
  [[nodiscard]] bool is_ear(std::size_t i) const {
    if (turn_[i] <= 0) {
      return false;
    }
    const Point2& a = polygon_[previous_[i]];
    const Point2& b = polygon_[i];
    const Point2& c = polygon_[next_[i]];
    for (const std::size_t other : blockers_) {
      const Point2& p = polygon_[other];
      if (turn_[other] != kGone && p != a && p != b && p != c && orientation(a, b, p) >= 0 &&
          orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0) {
        return false;
      }
    }
    return true;
  }

  std::span<const std::uint32_t> corners_;
  std::vector<Point2> polygon_;
  std::vector<Triangle>& triangles_;
  std::vector<std::size_t> next_, previous_;
  std::vector<int> turn_;
  std::vector<std::size_t> blockers_;
};

}  // namespace

void refuse_polygon(std::size_t corners, std::string where) {
  throw Error(Errc::limit_exceeded,
              "a face of " + std::to_string(corners) + " vertices is more than the " +
                  std::to_string(kLargestPolygon) +
                  " that are cut into triangles; write it as triangles",
              {}, std::move(where));
}

void cut_into_triangles(std::span<const std::uint32_t> corners, const std::vector<Vec3>& points,
                        std::vector<Triangle>& triangles) {
  EarClipper(corners, projected(corners, points), triangles).clip();
}

}  // namespace dupin::text
