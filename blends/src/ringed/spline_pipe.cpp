#include "dupin/blends/spline_pipe.h"

#include <atomic>
#include <cmath>
#include <string>

#include "dupin/blends/regularity.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

void validate(const std::vector<Waypoint>& points, const SplinePipeOptions& options) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].point.allFinite() ||
        !(std::isfinite(points[i].radius) && points[i].radius > 0)) {
      throw Error(Errc::invalid_argument, "point " + std::to_string(i) +
                                              " of the pipe needs finite coordinates and a "
                                              "positive radius");
    }
    if (i > 0 && points[i].point == points[i - 1].point) {
      throw Error(Errc::invalid_argument, "points " + std::to_string(i - 1) + " and " +
                                              std::to_string(i) +
                                              " of the pipe coincide; drop one of them");
    }
  }
  if (!(options.margin >= 0 && options.margin < 1)) {
    throw Error(Errc::invalid_argument,
                "the pipe's margin must be at least 0 and less than 1, not " +
                    decimal(options.margin, kMessageDigits));
  }
}

// Chord lengths between neighbours.
std::vector<double> chords(const std::vector<Waypoint>& points) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    result.push_back((points[i + 1].point - points[i].point).norm());
  }
  return result;
}

// Row i reads before[i] x[i - 1] + here[i] x[i] + after[i] x[i + 1] = right[i]; diagonally
// dominant.
struct Tridiagonal {
  std::vector<double> before, here, after;
};

template <class Value>
std::vector<Value> solved(const Tridiagonal& system, std::vector<Value> right) {
  std::vector<double> pivot = system.here;
  for (std::size_t i = 1; i < right.size(); ++i) {
    const double factor = system.before[i] / pivot[i - 1];
    pivot[i] -= factor * system.after[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = right.size(); i-- > 0;) {
    if (i + 1 < right.size()) {
      right[i] -= system.after[i] * right[i + 1];
    }
    right[i] /= pivot[i];
  }
  return right;
}

// That the second derivatives agree at a knot between spans of lengths a and b:
//   b m_before + 2 (a + b) m_here + a m_after = 3 (b/a (p - p_before) + a/b (p_after - p)).
struct KnotEquation {
  double before = 0, here = 0, after = 0;
  Vec3 right;
};

KnotEquation knot_equation(const Vec3& p_before, const Vec3& p, const Vec3& p_after, double a,
                           double b) {
  return {b, 2 * (a + b), a, 3 * (b / a * (p - p_before) + a / b * (p_after - p))};
}

// Derivatives of the clamped spline by chord length at every point; unit at the ends.
std::vector<Vec3> clamped_velocities(const std::vector<Waypoint>& points, const Vec3& first,
                                     const Vec3& last) {
  const std::vector<double> h = chords(points);
  Tridiagonal system{{0}, {1}, {0}};
  std::vector<Vec3> right{first};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const KnotEquation row =
        knot_equation(points[i - 1].point, points[i].point, points[i + 1].point, h[i - 1], h[i]);
    system.before.push_back(row.before);
    system.here.push_back(row.here);
    system.after.push_back(row.after);
    right.push_back(row.right);
  }
  system.before.push_back(0);
  system.here.push_back(1);
  system.after.push_back(0);
  right.push_back(last);
  return solved(system, right);
}

// Of the periodic spline through points whose last one is the first again. The cyclic system is a
// tridiagonal one plus u w^T (Sherman, Morrison).
std::vector<Vec3> periodic_velocities(const std::vector<Waypoint>& points) {
  const std::vector<double> h = chords(points);
  const std::size_t n = h.size();
  Tridiagonal system;
  std::vector<Vec3> right;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    const KnotEquation row =
        knot_equation(points[before].point, points[i].point, points[i + 1].point, h[before], h[i]);
    system.before.push_back(row.before);
    system.here.push_back(row.here);
    system.after.push_back(row.after);
    right.push_back(row.right);
  }
  const double gamma = -system.here[0], corner = system.before[0], other = system.after[n - 1];
  system.here[0] -= gamma;
  system.here[n - 1] -= other * corner / gamma;
  std::vector<double> u(n);
  u[0] = gamma;
  u[n - 1] = other;
  const std::vector<Vec3> y = solved(system, right);
  const std::vector<double> z = solved(system, u);
  const double weight = corner / gamma;
  const Vec3 factor = (y[0] + weight * y[n - 1]) / (1 + z[0] + weight * z[n - 1]);
  std::vector<Vec3> velocities;
  for (std::size_t i = 0; i < n; ++i) {
    velocities.push_back(y[i] - z[i] * factor);
  }
  velocities.push_back(velocities.front());
  return velocities;
}

// Or how many there are. Those behind one that is not proved need not be looked at.
std::size_t first_not_proved(const std::vector<RingedSurface>& pieces, double margin) {
  std::atomic<std::size_t> first = pieces.size();
  for_each_in_parallel(pieces.size(), [&](std::size_t i) {
    if (i < first && prove_margin(pieces[i], margin).verdict != Verdict::proved) {
      for (std::size_t least = first; i < least && !first.compare_exchange_weak(least, i);) {
      }
    }
  });
  return first;
}

[[noreturn]] void refuse(const RingedSurface& piece, std::size_t span, double margin) {
  const auto bad = violations(piece, margin);
  const std::string where =
      "t in [" + decimal(bad.front().from, 4) + ", " + decimal(bad.back().to, 4) + "]";
  const double most = regularity(piece).upper;
  const std::string wanted = decimal(margin, kMessageDigits);
  throw Error(Errc::irregular_surface,
              "the pipe is bent too sharply between its points " + std::to_string(span) + " and " +
                  std::to_string(span + 1) + ": " +
                  (most < margin ? "its margin min(1 - kappa R) is at most " +
                                       decimal_at_most(most) + ", not " + wanted
                                 : "that its margin min(1 - kappa R) is " + wanted +
                                       " cannot be proved where its spine nearly stops") +
                  "; move the points apart or reduce the radii",
              {}, where);
}

// One piece per span; rings[i] ends piece i - 1, flipped it starts piece i.
std::vector<RingedSurface> pieces(const std::vector<Waypoint>& points,
                                  const std::vector<Vec3>& velocities,
                                  const std::vector<Ring>& rings, double margin) {
  const std::vector<double> h = chords(points);
  std::vector<RingedSurface> result;
  for (std::size_t i = 0; i < h.size(); ++i) {
    result.push_back({flipped(rings[i]), rings[i + 1],
                      HermiteSpine{points[i].point, points[i + 1].point, h[i] * velocities[i],
                                   h[i] * velocities[i + 1]},
                      CubicRadius{points[i].radius, points[i + 1].radius}});
  }
  if (const std::size_t i = first_not_proved(result, margin); i < result.size()) {
    refuse(result[i], i, margin);
  }
  return result;
}

std::vector<Ring> rings_along(const std::vector<Waypoint>& points,
                              const std::vector<Vec3>& velocities) {
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    rings.push_back({points[i].point, velocities[i].normalized(), points[i].radius});
  }
  return rings;
}

}  // namespace

std::vector<RingedSurface> spline_pipe(const Ring& from, const std::vector<Waypoint>& through,
                                       const Ring& to, const SplinePipeOptions& options) {
  for (const Ring& ring : {from, to}) {
    validate(ring);
    if (ring.slope != 0) {
      throw Error(Errc::invalid_argument,
                  "a pipe through points needs ends of cylinders, not of cones");
    }
  }
  std::vector<Waypoint> points{{from.center, from.radius}};
  points.insert(points.end(), through.begin(), through.end());
  points.push_back({to.center, to.radius});
  validate(points, options);
  const auto velocities = clamped_velocities(points, from.normal, -to.normal);
  std::vector<Ring> rings = rings_along(points, velocities);
  rings.front() = from;
  rings.back() = flipped(to);
  return pieces(points, velocities, rings, options.margin);
}

std::vector<RingedSurface> closed_spline_pipe(const std::vector<Waypoint>& through,
                                              const SplinePipeOptions& options) {
  if (through.size() < 3) {
    throw Error(Errc::invalid_argument,
                "a closed pipe needs at least 3 points, not " + std::to_string(through.size()));
  }
  std::vector<Waypoint> points = through;
  points.push_back(through.front());
  validate(points, options);
  const auto velocities = periodic_velocities(points);
  return pieces(points, velocities, rings_along(points, velocities), options.margin);
}

}  // namespace dupin
