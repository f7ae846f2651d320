#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/frame.h"
#include "dupin/blends/nurbs.h"

namespace dupin {
namespace {

// The span of a knot vector that holds t, and de Boor's points of it.
template <class Value>
Value de_boor(const std::vector<Value>& points, const std::vector<double>& knots, int degree,
              double t) {
  std::size_t span = std::size_t(degree);
  while (span + 1 < points.size() && knots[span + 1] <= t) {
    ++span;
  }
  std::vector<Value> d(points.begin() + std::ptrdiff_t(span) - degree,
                       points.begin() + std::ptrdiff_t(span) + 1);
  for (int r = 1; r <= degree; ++r) {
    for (int j = degree; j >= r; --j) {
      const std::size_t i = span - std::size_t(degree) + std::size_t(j);
      const double low = knots[i], high = knots[i + 1 + std::size_t(degree - r)];
      const double share = (t - low) / (high - low);
      d[std::size_t(j)] = (1 - share) * d[std::size_t(j) - 1] + share * d[std::size_t(j)];
    }
  }
  return d.back();
}

}  // namespace

Vec3 evaluate(const NurbsSurface& surface, double along, double around) {
  std::vector<Eigen::Array4d> column;
  for (const auto& row : surface.net) {
    std::vector<Eigen::Array4d> points;
    points.reserve(row.size());
    for (const auto& p : row) {
      points.emplace_back(p[0], p[1], p[2], p[3]);
    }
    column.push_back(de_boor(points, surface.knots_around, surface.degree_around, around));
  }
  const Eigen::Array4d point = de_boor(column, surface.knots_along, surface.degree_along, along);
  return Vec3(point[0], point[1], point[2]) / point[3];
}

Vec3 evaluate(const NurbsCurve& curve, double t) {
  std::vector<Eigen::Array4d> points;
  for (const auto& p : curve.net) {
    points.emplace_back(p[0], p[1], p[2], p[3]);
  }
  const Eigen::Array4d point = de_boor(points, curve.knots, curve.degree, t);
  return Vec3(point[0], point[1], point[2]) / point[3];
}

// Four quarters, each between two points and the corner of the square about them.
NurbsCurve nurbs(const Ring& ring) {
  constexpr std::array<std::array<int, 2>, 9> kSquare{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}};
  const Vec3 axis = reference_axis(ring), other = ring.normal.cross(axis);
  const double across = ring.ellipse ? ring.ellipse->across : ring.radius;
  NurbsCurve result{2, {0, 0, 0, .25, .25, .5, .5, .75, .75, 1, 1, 1}, {}};
  for (std::size_t i = 0; i < kSquare.size(); ++i) {
    const double weight = i % 2 == 0 ? 1 : std::numbers::sqrt2 / 2;
    const Vec3 point =
        ring.center + kSquare.at(i)[0] * ring.radius * axis + kSquare.at(i)[1] * across * other;
    result.net.push_back({weight * point.x(), weight * point.y(), weight * point.z(), weight});
  }
  return result;
}

}  // namespace dupin
