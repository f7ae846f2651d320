#include "dupin/blends/cyclide_patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "cyclide/complementary_sphere.h"

namespace dupin {
namespace {

struct RingCoordinates {
  double kappa, c, s;
};

struct HomogeneousPoint {
  Vec3 point;
  double weight;
};

// Contact of two spheres of different families, bilinear in their homogeneous coordinates.
HomogeneousPoint contact(const HomogeneousSphere& g, const cyclide::ComplementarySphere& q) {
  return {q.radius * g.sphere.m - g.sphere.r * q.center,
          q.radius * g.weight - g.sphere.r * q.weight};
}

// cos of half the arc that a rational quadratic with these weights spans.
double half_arc_cosine(double w0, double w1, double w2) { return w1 / std::sqrt(w0 * w2); }

const double kQuarterTurn = std::numbers::sqrt2 / 2;  // cos 45 deg: arcs of at most 90 degrees

bool short_enough(const PeArc& arc) {
  if (arc.w() < kQuarterTurn) {
    return false;
  }
  const auto rows = bezier_points(arc);
  const ArcFrame f = frame(arc);
  for (int k = 0; k < 16; ++k) {
    const double v = k * std::numbers::pi / 8;
    const cyclide::ComplementarySphere q =
        cyclide::complementary_sphere(arc, f, 1, std::cos(v), std::sin(v));
    const double w0 = contact(rows[0], q).weight, w1 = contact(rows[1], q).weight,
                 w2 = contact(rows[2], q).weight;
    if (!(w0 > 0 && w2 > 0 && half_arc_cosine(w0, w1, w2) >= kQuarterTurn)) {
      return false;
    }
  }
  return true;
}

BiquadraticPatch patch(const PeArc& arc, double v0, double v1) {
  const double half = (v1 - v0) / 2, middle = (v0 + v1) / 2;
  const std::array<RingCoordinates, 3> columns{
      {{1, std::cos(v0), std::sin(v0)},
       {std::cos(half), std::cos(middle), std::sin(middle)},
       {1, std::cos(v1), std::sin(v1)}}};
  const auto rows = bezier_points(arc);
  const ArcFrame f = frame(arc);
  const double scale = 1 / (arc.chord() * arc.chord());
  BiquadraticPatch result;
  for (std::size_t j = 0; j < 3; ++j) {
    const cyclide::ComplementarySphere q =
        cyclide::complementary_sphere(arc, f, columns[j].kappa, columns[j].c, columns[j].s);
    for (std::size_t i = 0; i < 3; ++i) {
      const HomogeneousPoint p = contact(rows[i], q);
      result.points[i][j] = scale * p.point;
      result.weights[i][j] = scale * p.weight;
    }
  }
  return result;
}

bool narrow_enough(const BiquadraticPatch& p) {
  return std::ranges::all_of(p.weights, [](const std::array<double, 3>& w) {
    // Rounding may leave the quarter arc of the first row a few ulp above 90 degrees.
    return w[0] > 0 && w[1] > 0 && w[2] > 0 &&
           half_arc_cosine(w[0], w[1], w[2]) >= kQuarterTurn * (1 - 1.0 / (1 << 20));
  });
}

void add_columns(const PeArc& arc, double v0, double v1, std::vector<BiquadraticPatch>& out) {
  const BiquadraticPatch p = patch(arc, v0, v1);
  if (narrow_enough(p)) {
    out.push_back(p);
    return;
  }
  const double middle = (v0 + v1) / 2;
  add_columns(arc, v0, middle, out);
  add_columns(arc, middle, v1, out);
}

void add_rows(const PeArc& arc, std::vector<BiquadraticPatch>& out) {
  if (!short_enough(arc)) {
    add_rows(sub_arc(arc, 0, 0.5), out);
    add_rows(sub_arc(arc, 0.5, 1), out);
    return;
  }
  for (int quarter = 0; quarter < 4; ++quarter) {
    add_columns(arc, quarter * std::numbers::pi / 2, (quarter + 1) * std::numbers::pi / 2, out);
  }
}

}  // namespace

Vec3 evaluate(const BiquadraticPatch& patch, double t, double s) {
  const std::array<double, 3> bt{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
  const std::array<double, 3> bs{(1 - s) * (1 - s), 2 * s * (1 - s), s * s};
  Vec3 point = Vec3::Zero();
  double weight = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      point += bt[i] * bs[j] * patch.points[i][j];
      weight += bt[i] * bs[j] * patch.weights[i][j];
    }
  }
  return point / weight;
}

std::vector<BiquadraticPatch> patches(const PeArc& arc) {
  std::vector<BiquadraticPatch> result;
  add_rows(arc, result);
  return result;
}

}  // namespace dupin
