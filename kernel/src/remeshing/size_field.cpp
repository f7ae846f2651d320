#include "remeshing/size_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "mesh/edge_table.h"
#include "support/bulk_vector.h"

namespace dupin::remeshing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Shares of the distance that curved edges may take: the rest is for what is not foreseen.
constexpr double kShare = 0.6;
/// An edge sees the surface turn by at most so much: at least nine of them go around a pipe.
constexpr double kMostTurn = 0.7;
/// Bends below are what rounding makes of planes.
constexpr double kLeastBend = 1e-7;
/// Two curves that meet in a smaller angle than about 55 degrees come near each other: the way from
/// one to the other along them is so many times as long as that across.
constexpr double kDetour = 2;

/// The part of a segment within a ball: its length.
double length_within(const Vec3& a, const Vec3& b, const Vec3& centre, double radius) {
  const Vec3 along = b - a;
  const double length = along.norm();
  if (!(length > 0)) {
    return 0;
  }
  const Vec3 direction = along / length;
  const double foot = (centre - a).dot(direction);
  const double off = (centre - a - foot * direction).squaredNorm();
  if (off >= radius * radius) {
    return 0;
  }
  const double half = std::sqrt(radius * radius - off);
  return std::max(0.0, std::min(length, foot + half) - std::max(0.0, foot - half));
}

double distance_to(const Vec3& p, const Vec3& a, const Vec3& b, double& share) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  share = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
  return (a + share * along - p).norm();
}

}  // namespace

SizeField::SizeField(const TriMesh& mesh, const Features& features, const SizeLimits& limits)
    : features_(features), limits_(limits), frame_(mesh.points) {
  const mesh::EdgeTable edges(mesh.triangles, mesh.points.size());
  const auto normal = [&](std::uint32_t f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const Vec3 n = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    const double longest = std::max({(mesh.points[b] - mesh.points[a]).norm(),
                                     (mesh.points[c] - mesh.points[b]).norm(),
                                     (mesh.points[a] - mesh.points[c]).norm()});
    const bool is_certain = n.norm() > longest * mesh.points[a].cwiseAbs().maxCoeff() * 0x1p-40;
    return is_certain ? Vec3(n.normalized()) : Vec3(Vec3::Zero());
  };
  for (const std::uint32_t region : features.regions) {
    is_bent_.resize(std::max<std::size_t>(is_bent_.size(), region + 1), 0);
  }
  support::BulkVector<boxes::Box> boxes;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const mesh::Edge edge = edges[e];
    const std::uint32_t h = edge.half_edges[0], f = h / 3, g = edge.half_edges[1] / 3;
    if (features.spans[f][h % 3].is_sharp()) {
      continue;
    }
    const Vec3 m = normal(f), n = normal(g);
    const double angle = std::atan2(m.cross(n).norm(), m.dot(n));
    if (!m.isZero() && !n.isZero() && angle > kLeastBend) {
      const Vec3 &a = mesh.points[edge.low], &b = mesh.points[edge.high];
      bends_.push_back({a, b, angle, features.regions[f]});
      is_bent_[features.regions[f]] = 1;
      boxes.push_back(around(a, b, 0));
    }
  }
  if (!bends_.empty()) {
    bend_tree_.emplace(std::span<const boxes::Box>(boxes));
  }
  boxes.clear();
  for (std::uint32_t c = 0; c < features.curves.size(); ++c) {
    const Curve& curve = features.curves[c];
    curves_at_.emplace_back(curve.ends[0], c);
    curves_at_.emplace_back(curve.ends[1], c);
    for (std::uint32_t i = 0; i + 1 < curve.points.size(); ++i) {
      curve_edges_.push_back({c, i});
      boxes.push_back(around(curve.points[i], curve.points[i + 1], 0));
    }
  }
  std::sort(curves_at_.begin(), curves_at_.end());
  if (!curve_edges_.empty()) {
    curve_tree_.emplace(std::span<const boxes::Box>(boxes));
  }
}

boxes::Box SizeField::around(const Vec3& a, const Vec3& b, double margin) const {
  return frame_.around(frame_.map(a, b, b), margin);
}

/// Of a surface of facets that turn by `angle` from one to the next, new points lie anywhere
/// between the ridges: the ridges stand out of what they span by s = angle^2 / 8 curvature, more
/// than the smooth surface would.
double SizeField::length_for(double curvature, double angle) const {
  if (!(curvature > 0)) {
    return kInfinity;
  }
  const double distance = kShare * limits_.distance;
  const double ridge = angle * angle / (8 * curvature);
  const double smooth = std::sqrt(8 * std::max(0.0, distance - ridge) / curvature);
  const double faceted = angle > 0 ? 4 * distance / angle : 0;
  return std::min(std::max(smooth, faceted), kMostTurn / curvature);
}

/// The curvature about a place is what edges turn by in a ball, by their length and direction, over
/// the area [Cohen-Steiner and Morvan, Restricted Delaunay Triangulations and Normal Cycle, 2003],
/// whatever the triangles look like. The ball is as large as the edges that follow.
double SizeField::by_bends(const Vec3& point, std::span<const std::uint32_t> regions) const {
  if (std::ranges::none_of(regions, [&](std::uint32_t r) { return is_bent_[r] != 0; })) {
    return limits_.largest;
  }
  for (double radius = std::min(limits_.largest, 2 * limits_.distance);;
       radius = std::min(1.6 * radius, limits_.largest)) {
    Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
    double sum = 0, squares = 0;
    bend_tree_->visit(around(point, point, radius), [&](std::uint32_t i) {
      const Bend& bend = bends_[i];
      if (std::ranges::find(regions, bend.region) == regions.end()) {
        return;
      }
      const double within = length_within(bend.from, bend.to, point, radius);
      if (within > 0) {
        const Vec3 direction = (bend.to - bend.from).normalized();
        tensor += bend.angle * within * direction * direction.transpose();
        sum += bend.angle * within;
        squares += bend.angle * bend.angle * within;
      }
    });
    double length = kInfinity;
    if (sum > 0) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor, Eigen::EigenvaluesOnly);
      const double curvature = solver.eigenvalues()[2] / (M_PI * radius * radius);
      length = length_for(curvature, squares / sum);
    }
    if (length <= radius || radius >= limits_.largest) {
      return std::clamp(length, limits_.smallest, limits_.largest);
    }
  }
}

/// The same for a curve: what it turns by over a length.
double SizeField::by_turns(const Curve& curve, double length) const {
  for (double radius = std::min(limits_.largest, 2 * limits_.distance);;
       radius = std::min(1.6 * radius, limits_.largest)) {
    double sum = 0, squares = 0;
    const double from = std::max(0.0, length - radius),
                 to = std::min(curve.length(), length + radius);
    for (std::size_t i = curve.edge_at(from) + 1;
         i + 1 < curve.points.size() && curve.lengths[i] < to; ++i) {
      const Vec3 a = curve.points[i] - curve.points[i - 1],
                 b = curve.points[i + 1] - curve.points[i];
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      sum += angle;
      squares += angle * angle;
    }
    const double wanted = sum > 0 ? length_for(sum / (to - from), squares / sum) : kInfinity;
    if (wanted <= radius || radius >= limits_.largest) {
      return std::clamp(wanted, limits_.smallest, limits_.largest);
    }
  }
}

template <class Along>
double SizeField::by_gaps(const Vec3& point, std::span<const std::uint32_t> regions, double most,
                          const Along& along) const {
  for (double radius = std::min(most, 2 * limits_.distance);; radius = std::min(2 * radius, most)) {
    double gap = kInfinity;
    curve_tree_->visit(around(point, point, radius), [&](std::uint32_t i) {
      const auto& [c, edge] = curve_edges_[i];
      const Curve& curve = features_.curves[c];
      const auto& sides = curve.sides[edge];
      if (std::ranges::find(regions, sides[0]) == regions.end() &&
          std::ranges::find(regions, sides[1]) == regions.end()) {
        return;
      }
      double share = 0;
      const double distance = distance_to(point, curve.points[edge], curve.points[edge + 1], share);
      const double at =
          curve.lengths[edge] + share * (curve.lengths[edge + 1] - curve.lengths[edge]);
      // Nearer than the smallest edge is the place itself, or as good as none.
      if (distance < gap && along(c, at) > kDetour * std::max(distance, limits_.smallest)) {
        gap = distance;
      }
    });
    if (gap <= radius) {
      return std::max(gap, limits_.smallest);
    }
    if (!(radius < most)) {
      return most;
    }
  }
}

double SizeField::in_region(const Vec3& point, std::uint32_t region) const {
  return by_bends(point, {&region, 1});
}

double SizeField::on_curve(const Vec3& point, std::uint32_t curve, double length) const {
  const Curve& mine = features_.curves[curve];
  const auto& regions = mine.sides[mine.edge_at(length)];
  const double most = std::min(by_bends(point, regions), by_turns(mine, length));
  const auto along = [&](std::uint32_t c, double at) {
    const Curve& other = features_.curves[c];
    double way = kInfinity;
    if (c == curve) {
      const double between = std::abs(at - length);
      way = mine.ends[0] == mine.ends[1] ? std::min(between, mine.length() - between) : between;
    }
    for (int i = 0; i < 2; ++i) {
      for (int k = 0; k < 2; ++k) {
        if (mine.ends[i] == other.ends[k]) {
          way = std::min(way, (i == 0 ? length : mine.length() - length) +
                                  (k == 0 ? at : other.length() - at));
        }
      }
    }
    return way;
  };
  return by_gaps(point, regions, most, along);
}

double SizeField::at_corner(const Vec3& point, std::uint32_t corner,
                            std::span<const std::uint32_t> regions) const {
  double most = by_bends(point, regions);
  auto next = std::lower_bound(curves_at_.begin(), curves_at_.end(), std::pair(corner, 0U));
  for (; next != curves_at_.end() && next->first == corner; ++next) {
    const Curve& curve = features_.curves[next->second];
    most = std::min(most, by_turns(curve, curve.ends[0] == corner ? 0 : curve.length()));
  }
  if (!curve_tree_) {
    return most;
  }
  const auto along = [&](std::uint32_t c, double at) {
    const Curve& other = features_.curves[c];
    double way = kInfinity;
    for (int k = 0; k < 2; ++k) {
      if (other.ends[k] == corner) {
        way = std::min(way, k == 0 ? at : other.length() - at);
      }
    }
    return way;
  };
  return by_gaps(point, regions, most, along);
}

}  // namespace dupin::remeshing
