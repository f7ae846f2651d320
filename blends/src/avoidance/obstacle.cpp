#include "avoidance/obstacle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"
#include "numbers/interval.h"
#include "ringed/nearest_in_disc.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin::avoidance {
namespace {

using numbers::Interval;

// The capsule about the segment from the first control point to the last that holds all discs.
Obstacle capsule_about(const surfaces::DiscHull& hull) {
  const Vec3 from = middle(hull.centers.front()), to = middle(hull.centers.back());
  const Vec3 along = to - from;
  Obstacle result{from, {along}, 0};
  Interval farthest = 0;
  for (const numbers::IntervalVec& center : hull.centers) {
    // From any point of the segment: the hull of the centres is convex, and so is the distance.
    const double squared = along.squaredNorm();
    const double s =
        squared > 0 ? std::clamp(along.dot(middle(center) - from) / squared, 0.0, 1.0) : 0.0;
    const numbers::IntervalVec on =
        numbers::interval_vec(from) + Interval(s) * numbers::interval_vec(along);
    const numbers::IntervalVec off = center - on;
    farthest = max(farthest, sqrt(numbers::dot(off, off)));
  }
  result.radius = (farthest + hull.radius).upper;
  return result;
}

// [Ericson, Real-time collision detection, 5.1.5]: by the regions of the triangle's corners and
// sides.
Vec3 nearest_in_triangle(const Vec3& a, const Vec3& ab, const Vec3& ac, const Vec3& p) {
  const Vec3 ap = p - a, bp = ap - ab, cp = ap - ac;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
               d6 = ac.dot(cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (d1 <= 0 && d2 <= 0) {
    return a;
  }
  if (d3 >= 0 && d4 <= d3) {
    return a + ab;
  }
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    return a + d1 / (d1 - d3) * ab;
  }
  if (d6 >= 0 && d5 <= d6) {
    return a + ac;
  }
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    return a + d2 / (d2 - d6) * ac;
  }
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double s = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return a + ab + s * (ac - ab);
  }
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

// Corners are exact, so that a box of sizes that are rounded up holds them.
Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& bounds) {
  const double most = bounds.min().cwiseAbs().cwiseMax(bounds.max().cwiseAbs()).maxCoeff();
  const Vec3 more = Vec3::Constant(std::ldexp(most, -50));
  return {Vec3(bounds.min() - more), Vec3(bounds.max() + more)};
}

struct BoundedTriangle {
  Obstacle shape;
  Eigen::AlignedBox3d bounds;
};

std::vector<ObstacleBox> boxes_of(std::span<BoundedTriangle> triangles) {
  constexpr std::size_t kFew = 4;
  std::vector<ObstacleBox> result;
  if (triangles.size() <= kFew) {
    for (const BoundedTriangle& t : triangles) {
      result.push_back({t.shape});
    }
    return result;
  }
  Eigen::AlignedBox3d middles;
  for (const BoundedTriangle& t : triangles) {
    middles.extend(t.bounds.center());
  }
  int axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::size_t half = triangles.size() / 2;
  std::nth_element(triangles.begin(), triangles.begin() + std::ptrdiff_t(half), triangles.end(),
                   [=](const BoundedTriangle& a, const BoundedTriangle& b) {
                     return a.bounds.center()[axis] < b.bounds.center()[axis];
                   });
  for (const auto part : {triangles.first(half), triangles.subspan(half)}) {
    Eigen::AlignedBox3d bounds;
    for (const BoundedTriangle& t : part) {
      bounds.extend(t.bounds);
    }
    result.push_back({box_about(widened(bounds)), boxes_of(part)});
  }
  return result;
}

}  // namespace

Obstacle box_about(const Eigen::AlignedBox3d& bounds) {
  const Vec3 size = bounds.sizes();
  return {bounds.min(),
          {size.x() * Vec3::UnitX(), size.y() * Vec3::UnitY(), size.z() * Vec3::UnitZ()},
          0};
}

NamedObstacle obstacle_of(const std::string& name, const TriMesh& mesh) {
  std::vector<BoundedTriangle> triangles;
  Eigen::AlignedBox3d all;
  bool is_finite = true;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    Eigen::AlignedBox3d bounds(a);
    bounds.extend(b).extend(c);
    all.extend(bounds);
    is_finite = is_finite && a.allFinite() && b.allFinite() && c.allFinite();
    // Its edges are rounded.
    const double most = bounds.min().cwiseAbs().cwiseMax(bounds.max().cwiseAbs()).maxCoeff();
    triangles.push_back({{a, {b - a, c - a}, std::ldexp(most, -50), true}, bounds});
  }
  if (triangles.empty() || !is_finite) {
    throw Error(Errc::invalid_argument,
                triangles.empty() ? "the mesh has no triangles" : "the mesh is not finite");
  }
  return {name, box_about(widened(all)), boxes_of(triangles)};
}

std::vector<NamedObstacle> obstacles_of(const std::string& part, const PartSurface& surface) {
  if (const auto* ball = std::get_if<Sphere>(&surface)) {
    return {{part, {ball->center, {}, ball->radius}}};
  }
  constexpr int kStretches = 16;
  std::vector<NamedObstacle> result;
  for (const Piece& piece : std::get<Chain>(surface).pieces) {
    const auto* ringed = std::get_if<RingedSurface>(&piece);
    const bool is_pipe = ringed != nullptr && std::holds_alternative<LineSpine>(ringed->spine) &&
                         std::holds_alternative<ConstantRadius>(ringed->radius);
    const int count = is_pipe ? 1 : kStretches;
    const surfaces::PieceDiscs discs =
        std::visit([](const auto& one) { return surfaces::discs(one); }, piece);
    for (int i = 0; i < count; ++i) {
      result.push_back(
          {part, capsule_about(discs.hull({double(i) / count, double(i + 1) / count}))});
    }
  }
  return result;
}

// Coordinate descent on the edges' fractions, exact for right angles.
Vec3 nearest_core_point(const Obstacle& obstacle, const Vec3& point) {
  if (obstacle.is_triangle) {
    return nearest_in_triangle(obstacle.corner, obstacle.edges[0], obstacle.edges[1], point);
  }
  constexpr int kSweeps = 24;
  Vec3 result = obstacle.corner;
  std::vector<double> fractions(obstacle.edges.size(), 0);
  bool is_moved = true;
  for (int sweep = 0; sweep < kSweeps && is_moved; ++sweep) {
    is_moved = false;
    for (std::size_t i = 0; i < fractions.size(); ++i) {
      const Vec3& edge = obstacle.edges[i];
      const double squared = edge.squaredNorm();
      if (squared > 0) {
        const double before = fractions[i];
        fractions[i] = std::clamp(before + edge.dot(point - result) / squared, 0.0, 1.0);
        result += (fractions[i] - before) * edge;
        is_moved = is_moved || fractions[i] != before;
      }
    }
  }
  return result;
}

// Alternating projections between two convex sets.
Approach approach(const TravelRing& disc, const Obstacle& obstacle) {
  constexpr int kSteps = 40;
  Vec3 on_disc = disc.center, on_core = nearest_core_point(obstacle, on_disc);
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 next = ringed::nearest_in_disc(disc, on_core);
    const bool is_done = next == on_disc;
    on_disc = next;
    on_core = nearest_core_point(obstacle, on_disc);
    if (is_done) {
      break;
    }
  }
  return {(on_core - on_disc).norm() - obstacle.radius, on_disc, on_core - on_disc};
}

double distance(const TravelRing& disc, const NamedObstacle& obstacle) {
  if (obstacle.parts.empty()) {
    return approach(disc, obstacle.shape).distance;
  }
  double nearest = std::numeric_limits<double>::infinity();
  std::vector<const std::vector<ObstacleBox>*> open{&obstacle.parts};
  while (!open.empty()) {
    const auto& boxes = *open.back();
    open.pop_back();
    for (const ObstacleBox& box : boxes) {
      // A box holds its triangles, and a ball the disc.
      const double apart =
          (disc.center - nearest_core_point(box.shape, disc.center)).norm() - disc.radius;
      if (box.parts.empty()) {
        nearest = std::min(nearest, approach(disc, box.shape).distance);
      } else if (apart < nearest) {
        open.push_back(&box.parts);
      }
    }
  }
  return nearest;
}

double separation(const surfaces::DiscHull& discs, const Obstacle& obstacle,
                  const Vec3& direction) {
  if (!(direction.norm() > 0)) {
    return -std::numeric_limits<double>::infinity();
  }
  const Vec3 u = direction.normalized();
  const numbers::IntervalVec exact = numbers::interval_vec(u);
  Interval least = numbers::dot(exact, numbers::interval_vec(obstacle.corner));
  Interval deepest = 0;
  for (const Vec3& edge : obstacle.edges) {
    const Interval fall = min(Interval(0), numbers::dot(exact, numbers::interval_vec(edge)));
    deepest = obstacle.is_triangle ? min(deepest, fall) : deepest + fall;
  }
  least = least + deepest;
  const Interval gap = least - Interval(surfaces::support(discs, u));
  return (gap / sqrt(numbers::dot(exact, exact)) - Interval(obstacle.radius)).lower;
}

}  // namespace dupin::avoidance
