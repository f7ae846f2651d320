#include "tessellation/swept_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "tessellation/tessellation_tolerance.h"

namespace dupin::tessellation {
namespace {

// The end polygon of a frame that has to turn by so much to reach its first corner.
Arrival turned(const Ring& end, const RingSampling& sampling, double angle) {
  const double segment = 2 * std::numbers::pi / sampling.segments;
  const auto whole = std::lround(angle / segment);
  const auto count = long(sampling.segments);
  const auto shift = (count - whole % count) % count;
  Arrival result{sample(end, sampling), angle - double(whole) * segment};
  std::rotate(result.points.begin(), result.points.begin() + shift, result.points.end());
  return result;
}

// The parameter in the row of the first corner of the ring's polygon, through which it runs.
double first_parameter(const Ring& ring, const Row& row, const RingSampling& sampling) {
  const Vec3 to_point = sample(ring, {sampling.segments, sampling.phase, 0}).front() - row.center;
  return std::atan2(to_point.dot(row.second) / row.second.squaredNorm(),
                    to_point.dot(row.first) / row.first.squaredNorm());
}

}  // namespace

Vec3 first_direction(const Ring& ring, const RingSampling& sampling) {
  const Vec3 to_point = sample(ring, {sampling.segments, sampling.phase, 0}).front() - ring.center;
  return (to_point - to_point.dot(ring.normal) * ring.normal).normalized();
}

Vec3 carried(const Vec3& from, const Vec3& to, const Vec3& v) {
  const Vec3 axis = from.cross(to);
  return v + axis.cross(v) + axis.cross(axis.cross(v)) / (1 + from.dot(to));
}

double sagitta(double radius, std::uint32_t segments) {
  return radius * (1 - std::cos(std::numbers::pi / segments));
}

Vec3 Row::direction(double u) const { return std::cos(u) * first + std::sin(u) * second; }

Arrival arrival(const Ring& end, const RingSampling& sampling, const Vec3& carried_first) {
  const Vec3 wanted = first_direction(end, sampling);
  return turned(end, sampling,
                std::atan2(end.normal.dot(carried_first.cross(wanted)), carried_first.dot(wanted)));
}

double expected_bands(const std::vector<BandStepper>& marches, double allowed,
                      double largest_radius, std::uint32_t segments) {
  const BandBudget budget = band_budget(allowed, largest_radius, 2 * std::numbers::pi / segments);
  double sum = 0;
  for (const BandStepper& march : marches) {
    sum += march.expected_bands(budget.enough);
  }
  return sum;
}

double expected_bands(const BoundsOfCells& bounds, double allowed, double largest_radius,
                      std::uint32_t segments) {
  return expected_bands({coarse_march(bounds, 2 * std::numbers::pi / segments)}, allowed,
                        largest_radius, segments);
}

// First without a twist, to learn how many bands share it.
std::vector<Bands> even_bands(const std::vector<BandStepper>& marches, double allowed,
                              double largest_radius, std::uint32_t segments) {
  constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  const double around = 2 * std::numbers::pi / segments;
  const BandBudget budget = band_budget(allowed, largest_radius, around);
  refuse_too_fine(2. * segments * expected_bands(marches, allowed, largest_radius, segments));
  std::size_t count = 0;
  for (const BandStepper& march : marches) {
    count += march.knots(budget.enough, 0, kNoLimit).size() - 1;
  }
  refuse_too_fine(2. * segments * double(count));  // before the search for the best of them
  const double twist = around / 2 / double(count);
  std::vector<Bands> result;
  for (const BandStepper& march : marches) {
    Bands bands{even_knots(march, budget, twist), 0};
    bands.error_bound = march.error_bound(bands.knots, twist);
    result.push_back(std::move(bands));
  }
  return result;
}

Bands even_bands(const BoundsOfCells& bounds, double allowed, double largest_radius,
                 std::uint32_t segments) {
  const double around = 2 * std::numbers::pi / segments;
  const BandBudget budget = band_budget(allowed, largest_radius, around);
  return even_bands(std::vector{fine_march(bounds, around, budget.enough)}, allowed, largest_radius,
                    segments)
      .front();
}

TriMesh swept_mesh(const Ring& start, const std::vector<Row>& inner, const Arrival& last,
                   const RingSampling& sampling) {
  const std::uint32_t n = sampling.segments;
  const std::size_t bands = inner.size() + 1;
  TriMesh mesh = first_row(sample(flipped(start), sampling), bands);
  for (std::size_t j = 0; j < inner.size(); ++j) {
    const Row& row = inner[j];
    const double angle = row.angle + last.twist * double(j + 1) / double(bands);
    for (std::uint32_t i = 0; i < n; ++i) {
      const double u = 2 * std::numbers::pi * i / n + angle;
      mesh.points.push_back(snapped(row.center + row.scale * row.direction(u), sampling.grid));
    }
    append_band(mesh, n);
  }
  mesh.points.insert(mesh.points.end(), last.points.begin(), last.points.end());
  append_band(mesh, n);
  return mesh;
}

TriMesh swept_mesh(const Ring& start, const Ring& end, std::vector<Row> rows,
                   const RingSampling& sampling) {
  const double first = first_parameter(flipped(start), rows.front(), sampling);
  const Arrival last = turned(end, sampling, first_parameter(end, rows.back(), sampling) - first);
  rows.erase(rows.begin());
  rows.pop_back();
  for (Row& row : rows) {
    row.angle = first;
  }
  return swept_mesh(start, rows, last, sampling);
}

TriMesh first_row(const std::vector<Vec3>& points, std::size_t bands) {
  const std::size_t triangles = 2 * points.size() * bands;
  refuse_too_fine(double(triangles));
  TriMesh mesh;
  mesh.points.reserve(points.size() * (bands + 1));
  mesh.points.insert(mesh.points.end(), points.begin(), points.end());
  mesh.triangles.reserve(triangles);
  return mesh;
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

}  // namespace dupin::tessellation
