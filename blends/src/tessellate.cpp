#include "dupin/blends/tessellate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "chord_budget.h"
#include "second_derivatives.h"

namespace dupin {
namespace {

// Cells of [0, 1] on which the second derivatives are bounded once; bands may end inside a cell.
// The interval bounds of so short a cell exceed the suprema by about a percent.
constexpr std::uint32_t kCells = 1024;

// Steps of the frame per band; see Band::shear.
constexpr std::uint32_t kSteps = 16;

// A band turns by at most so many radians; what the bound of the frame's drift requires.
constexpr double kLargestTurn = 1;

// A cylinder or cone whose end polygons are parallel and start at the same angle: its
// quadrilaterals are plane, and every plane across the axis cuts chords from circles.
bool is_straight(const RingedSurface& surface) {
  return std::holds_alternative<LineSpine>(surface.spine) &&
         (std::holds_alternative<ConstantRadius>(surface.radius) ||
          std::holds_alternative<LinearRadius>(surface.radius)) &&
         surface.end.normal == flipped(surface.start).normal;
}

// How far the arcs of a circle are from their chords.
double sagitta(double radius, std::uint32_t segments) {
  return radius * (1 - std::cos(std::numbers::pi / segments));
}

bool is_uniform(const RingedSurface& surface) {
  return (std::holds_alternative<LineSpine>(surface.spine) ||
          std::holds_alternative<ArcSpine>(surface.spine)) &&
         std::holds_alternative<ConstantRadius>(surface.radius);
}

// Where the surface lies between the corners of a triangle with legs dt along and du around.
//
// A linear interpolant on a right triangle with legs dt, du differs from the surface x(t, u) by at
// most (dt^2 Mtt + 2 dt du Mtu + du^2 Muu) / 8 [FMM86]. If the far corners are turned by s against
// the frame, the triangle is right-angled in w = u - (s / dt) t, where
//   X_tt = x_tt + 2 (s/dt) x_tu + (s/dt)^2 x_uu,  X_tw = x_tu + (s/dt) x_uu,  X_ww = x_uu,
// and the bound becomes the one with du + |s| for du:
//   dt^2 (Mtt + 2 |s|/dt Mtu + (s/dt)^2 Muu) + 2 dt du (Mtu + |s|/dt Muu) + du^2 Muu
//     = dt^2 Mtt + 2 dt (du + |s|) Mtu + (du + |s|)^2 Muu.
struct Band {
  SecondDerivativeBounds second;
  double turning = 0;  // sup |T'|
  double twist = 0;    // of the part per band, spread evenly
  double around = 0;   // du

  void include(const detail::BandBounds& cell) {
    second.along = std::max(second.along, cell.second.along);
    second.mixed = std::max(second.mixed, cell.second.mixed);
    second.around = std::max(second.around, cell.second.around);
    turning = std::max(turning, cell.turning);
  }

  // The frame is carried in kSteps minimal rotations T -> T' per band. A step that turns by at most
  // a <= 1 differs from the rotation-minimising frame by the area between the tangent's path on the
  // unit sphere and its chord; seen from the step's start, at distance d <= the path so far, the
  // path sweeps (1 - cos d) per radian of azimuth, and sin d |azimuth'| <= 1, so the area is at
  // most the integral of tan(d / 2) = -2 ln cos(a / 2) < 0.27 a^2.
  [[nodiscard]] double shear(double dt) const {
    const double turn = turning * dt;
    return twist + 0.27 * turn * turn / kSteps;
  }

  [[nodiscard]] double eight_errors(double dt) const {
    const double du = around + shear(dt);
    return dt * dt * second.along + 2 * dt * du * second.mixed + du * du * second.around;
  }

  [[nodiscard]] bool allows(double dt, double eight_errors_allowed) const {
    return turning * dt <= kLargestTurn && eight_errors(dt) <= eight_errors_allowed;
  }
};

// Marches along [0, 1] in the largest bands that keep to a bound.
class March {
 public:
  March(const RingedSurface& surface, double around) : around_(around) {
    const std::uint32_t cells = is_uniform(surface) ? 1 : kCells;
    cells_.reserve(cells);
    for (std::uint32_t i = 0; i < cells; ++i) {
      cells_.push_back(detail::band_bounds(surface, double(i) / cells, double(i + 1) / cells));
    }
  }

  // The ends of the bands, or the first `limit` + 1 of more.
  [[nodiscard]] std::vector<double> knots(double eight_errors_allowed, double twist,
                                          std::size_t limit) const {
    std::vector<double> result{0};
    while (result.back() < 1 && result.size() <= limit) {
      result.push_back(next(result.back(), eight_errors_allowed, twist));
    }
    return result;
  }

  [[nodiscard]] double error_bound(const std::vector<double>& knots, double twist) const {
    double largest = 0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      Band band = start(twist);
      const auto last = std::min(cells_.size(), std::size_t(std::ceil(knots[i + 1] * count())));
      for (auto cell = cell_of(knots[i]); cell < last; ++cell) {
        band.include(cells_[cell]);
      }
      largest = std::max(largest, band.eight_errors(knots[i + 1] - knots[i]));
    }
    return largest / 8;
  }

 private:
  [[nodiscard]] double count() const { return static_cast<double>(cells_.size()); }
  [[nodiscard]] std::size_t cell_of(double t) const { return std::size_t(t * count()); }
  [[nodiscard]] Band start(double twist) const { return {{}, 0, twist, around_}; }

  [[nodiscard]] double next(double t, double allowed, double twist) const {
    Band band = start(twist);
    double reached = t;
    for (auto cell = cell_of(t); cell < cells_.size(); ++cell) {
      band.include(cells_[cell]);
      const double cell_end = double(cell + 1) / count();
      if (band.allows(cell_end - t, allowed)) {
        reached = cell_end;
        continue;
      }
      double no = cell_end;
      for (double middle = (reached + no) / 2; reached < middle && middle < no;
           middle = (reached + no) / 2) {
        (band.allows(middle - t, allowed) ? reached : no) = middle;
      }
      break;
    }
    return reached;
  }

  std::vector<detail::BandBounds> cells_;
  double around_ = 0;
};

struct Bands {
  std::vector<double> knots;
  double error_bound = 0;
};

// As few bands as the allowed error permits, then the smallest error for that number, so that the
// last band is not a sliver.
//
// segments_for() gives three quarters of the bound to the bands: 8 allowed >= 4 Muu du^2. Where the
// segments are fewer, the bands are those that suit them. A twist of at most half a segment leaves
// (1.5 du)^2 Muu < 4 Muu du^2, so that every march arrives.
Bands bands(const RingedSurface& surface, double allowed, std::uint32_t segments) {
  const double around = 2 * std::numbers::pi / segments;
  if (is_straight(surface)) {
    return {{0, 1}, sagitta(largest_radius(surface.radius), segments)};
  }
  constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  const March march(surface, around);
  const double bend = largest_radius(surface.radius) * around * around;
  double enough = std::max(8 * allowed, 4 * bend), too_little = 2.25 * bend;
  const double twist = around / 2 / double(march.knots(enough, 0, kNoLimit).size() - 1);
  auto knots = march.knots(enough, twist, kNoLimit);
  for (int i = 0; i < 12; ++i) {
    const double middle = (enough + too_little) / 2;
    auto candidate = march.knots(middle, twist, knots.size());
    if (candidate.size() == knots.size() && candidate.back() == 1) {
      knots = std::move(candidate);
      enough = middle;
    } else {
      too_little = middle;
    }
  }
  return {knots, march.error_bound(knots, twist)};
}

// The smallest rotation that takes the unit vector `from` to `to`, applied to `v`; it never meets
// opposite vectors, as a step turns by less than kLargestTurn.
Vec3 carried(const Vec3& from, const Vec3& to, const Vec3& v) {
  const Vec3 axis = from.cross(to);
  return v + axis.cross(v) + axis.cross(axis.cross(v)) / (1 + from.dot(to));
}

// One direction across the spine per knot, turning no more than the tangent forces it to.
//
// FrameField is more accurate per step, but its drift has no proof; here it has (Band::shear).
std::vector<Vec3> carried_along(const Spine& spine, const std::vector<double>& knots, Vec3 first) {
  std::vector<Vec3> result{first};
  Vec3 tangent = evaluate(spine, 0).first.normalized();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (std::uint32_t step = 1; step <= kSteps; ++step) {
      const double t = knots[i] + (knots[i + 1] - knots[i]) * step / kSteps;
      const Vec3 next = evaluate(spine, t).first.normalized();
      first = carried(tangent, next, first);
      tangent = next;
    }
    first = (first - first.dot(tangent) * tangent).normalized();
    result.push_back(first);
  }
  return result;
}

// The direction of the polygon's first point, exactly across the ring's normal.
Vec3 first_direction(const Ring& ring, const RingSampling& sampling) {
  const Vec3 to_point = sample(ring, {sampling.segments, sampling.phase, 0}).front() - ring.center;
  return (to_point - to_point.dot(ring.normal) * ring.normal).normalized();
}

void append_band(TriMesh& mesh, std::uint32_t segments) {
  const auto next = std::uint32_t(mesh.points.size()) - segments, here = next - segments;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t k = (i + 1) % segments;
    const std::uint32_t a = here + i, b = here + k, c = next + k, d = next + i;
    const auto squared = [&](std::uint32_t p, std::uint32_t q) {
      return (mesh.points[p] - mesh.points[q]).squaredNorm();
    };
    if (squared(a, c) <= squared(b, d)) {
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    } else {
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
    }
  }
}

// The end polygon, counted from the point that the carried frame arrives at: the frame differs from
// the ring's own axis by whole segments and a rest of at most half a segment.
struct Arrival {
  std::vector<Vec3> points;
  double twist = 0;  // radians, right-handed about the spine
};

Arrival arrival(const Ring& end, const RingSampling& sampling, const Vec3& carried_first) {
  const Vec3 wanted = first_direction(end, sampling);
  const double angle =
      std::atan2(end.normal.dot(carried_first.cross(wanted)), carried_first.dot(wanted));
  const double segment = 2 * std::numbers::pi / sampling.segments;
  const auto whole = std::lround(angle / segment);
  Arrival result{sample(end, sampling), angle - double(whole) * segment};
  const auto count = long(sampling.segments);
  const auto shift = (count - whole % count) % count;
  std::rotate(result.points.begin(), result.points.begin() + shift, result.points.end());
  return result;
}

}  // namespace

std::uint32_t segments_for(const RingedSurface& surface, double tolerance, double grid) {
  const double allowed = detail::allowed_error(tolerance, detail::point_error(surface, grid));
  const double radius = largest_radius(surface.radius);
  if (!is_straight(surface)) {
    return detail::segment_count(2 * std::numbers::pi * std::sqrt(radius / (2 * allowed)));
  }
  return detail::segment_count(std::numbers::pi / std::acos(1 - std::min(allowed / radius, 1.0)));
}

Tessellation tessellate(const RingedSurface& surface, const RingSampling& sampling,
                        const TessellationOptions& options) {
  const double displacement = detail::point_error(surface, sampling.grid);
  const std::uint32_t n = sampling.segments;
  const auto first_ring = sample(flipped(surface.start), sampling);
  const Bands along = bands(surface, detail::allowed_error(options.tolerance, displacement), n);
  const auto& knots = along.knots;
  const auto firsts =
      carried_along(surface.spine, knots, first_direction(flipped(surface.start), sampling));
  const Arrival last = arrival(surface.end, sampling, firsts.back());

  Tessellation result{{}, std::uint32_t(knots.size() - 1), along.error_bound + displacement};
  TriMesh& mesh = result.mesh;
  mesh.points.reserve(n * knots.size());
  mesh.triangles.reserve(2 * std::size_t(n) * result.bands);
  mesh.points = first_ring;
  for (std::size_t j = 1; j + 1 < knots.size(); ++j) {
    const SpinePoint y = evaluate(surface.spine, knots[j]);
    const double radius = evaluate(surface.radius, knots[j]).value;
    const Vec3& b1 = firsts[j];
    const Vec3 b2 = y.first.normalized().cross(b1);
    const double turned = last.twist * double(j) / result.bands;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n + turned;
      mesh.points.push_back(snapped(
          y.position + radius * (std::cos(angle) * b1 + std::sin(angle) * b2), sampling.grid));
    }
    append_band(mesh, n);
  }
  mesh.points.insert(mesh.points.end(), last.points.begin(), last.points.end());
  append_band(mesh, n);
  return result;
}

}  // namespace dupin
