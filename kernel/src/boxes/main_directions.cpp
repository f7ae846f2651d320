#include "boxes/main_directions.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace dupin::boxes {
namespace {

/// Some triangles, evenly spread over the mesh.
std::vector<std::array<Vec3, 3>> sample(std::span<const Vec3> points,
                                        std::span<const Triangle> triangles) {
  constexpr std::size_t kMost = 1024, kOneIn = 16;
  const std::size_t count = std::min(kMost, triangles.size() / kOneIn);
  std::vector<std::array<Vec3, 3>> some;
  some.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [a, b, c] = triangles[i * triangles.size() / count];
    some.push_back({points[a], points[b], points[c]});
  }
  return some;
}

Vec3 longest_edge(const std::array<Vec3, 3>& t) {
  const std::array<Vec3, 3> edges = {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  return *std::ranges::max_element(edges, {}, [](const Vec3& e) { return e.squaredNorm(); });
}

/// The sum of vectors nearly along `direction`, either way round.
Vec3 sum_along(const std::vector<Vec3>& vectors, const Vec3& direction) {
  constexpr double kNearly = 0.998;  // square of the cosine of 2.6 degrees
  const double least = kNearly * direction.squaredNorm();
  Vec3 sum = Vec3::Zero();
  for (const Vec3& vector : vectors) {
    const double along = vector.dot(direction);
    if (along * along >= least * vector.squaredNorm()) {
      sum += along < 0 ? Vec3(-vector) : vector;
    }
  }
  return sum;
}

/// Along most of the vectors, by length; zero if all are.
Vec3 main_direction(const std::vector<Vec3>& vectors) {
  constexpr std::size_t kCandidates = 32;
  Vec3 best = Vec3::Zero();
  const std::size_t count = std::min(kCandidates, vectors.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 sum = sum_along(vectors, vectors[i * vectors.size() / count]);
    best = sum.squaredNorm() > best.squaredNorm() ? sum : best;
  }
  return sum_along(vectors, best).normalized();  // normalized() leaves zero as it is
}

/// Half the surface of the boxes along the axes, in all.
double box_surface(const std::vector<std::array<Vec3, 3>>& some, const Eigen::Matrix3d& axes) {
  double sum = 0;
  for (const auto& t : some) {
    const Vec3 a = axes * t[0], b = axes * t[1], c = axes * t[2];
    const Vec3 size = a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c);
    sum += size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
  return sum;
}

}  // namespace

Eigen::Matrix3d orthonormal(const Vec3& first, const Vec3& second) {
  Eigen::Matrix3d axes;
  const Vec3 a = first.normalized();
  Vec3 b = second - second.dot(a) * a;
  b.normalize();
  b = (b - b.dot(a) * a).normalized();
  axes << a.transpose(), b.transpose(), a.cross(b).transpose();
  return axes;
}

// Principal axes need not be exact, nor seen from every point.
Eigen::Matrix3d principal_axes(std::span<const Vec3> points) {
  constexpr std::size_t kSamples = 512;
  const std::size_t step = std::max<std::size_t>(1, points.size() / kSamples);
  Vec3 center = Vec3::Zero();
  double count = 0;
  for (std::size_t i = 0; i < points.size(); i += step) {
    center += points[i];
    count += 1;
  }
  center /= count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Vec3 d = points[i] - center;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Eigen::Matrix3d axes =
      orthonormal(solver.eigenvectors().col(2), solver.eigenvectors().col(1));
  return axes.allFinite() ? axes : Eigen::Matrix3d::Identity();
}

std::optional<Eigen::Matrix3d> axes_along_most(std::vector<Vec3> vectors) {
  constexpr double kRounding = 1e-20;  // of squares: what is left of vectors along the first
  const Vec3 first = main_direction(vectors);
  for (Vec3& vector : vectors) {
    const double least = kRounding * vector.squaredNorm();
    vector -= vector.dot(first) * first;
    if (vector.squaredNorm() <= least) {
      vector.setZero();
    }
  }
  const Vec3 second = main_direction(vectors);
  const Eigen::Matrix3d axes =
      orthonormal(first, second.isZero(0) ? first.unitOrthogonal() : second);
  const bool are_found = axes.row(0).squaredNorm() > 0.5 && axes.row(1).squaredNorm() > 0.5;
  return are_found ? std::optional(axes) : std::nullopt;
}

std::optional<Eigen::Matrix3d> main_directions(std::span<const Vec3> points,
                                               std::span<const Triangle> triangles) {
  constexpr double kMuchLess = 0.75;
  const auto some = sample(points, triangles);
  std::vector<Vec3> edges;
  edges.reserve(some.size());
  for (const auto& t : some) {
    edges.push_back(longest_edge(t));
  }
  const auto axes = axes_along_most(std::move(edges));
  return axes && box_surface(some, *axes) <
                     kMuchLess * box_surface(some, Eigen::Matrix3d::Identity())
             ? axes
             : std::nullopt;
}

}  // namespace dupin::boxes
