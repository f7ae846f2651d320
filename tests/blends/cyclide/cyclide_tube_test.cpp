#include "dupin/blends/cyclide_tube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "support/message_of.h"

namespace dupin {
namespace {

using std::numbers::pi;
using test::RandomArcs;

struct Measure {
  double area = 0, volume = 0;
};

Measure measure(const TriMesh& mesh) {
  Measure sum;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    sum.area += (q - p).cross(r - p).norm() / 2;
    sum.volume += p.dot(q.cross(r)) / 6;
  }
  return sum;
}

// The conical rims of a hollow tube.
double rim_area(const Chain& tube) {
  double sum = 0;
  if (tube.wall > 0) {
    const Chain inner = inner_skin(tube);
    sum = pi * tube.wall *
          (end_ring(tube, End::start).radius + end_ring(inner, End::start).radius +
           end_ring(tube, End::end).radius + end_ring(inner, End::end).radius);
  }
  return sum;
}

// With the volume that discs at the ends enclose.
Measure measure_closed(const Chain& tube, const Tessellation& result,
                       const RingSampling& sampling) {
  Measure sum = measure(result.mesh);
  if (tube.wall == 0) {
    for (const Ring& ring : {end_ring(tube, End::start), end_ring(tube, End::end)}) {
      sum.volume += measure(end_cap_mesh(ring, sampling)).volume;
    }
  }
  return sum;
}

// Outside positive, as signed_distance: of a union the least.
double distance_to_tube(const CyclideChain& chain, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const PeArc& arc : chain.pieces) {
    least = std::min(least, signed_distance(arc, point));
  }
  return least;
}

TEST(CyclideTube, mesh_is_as_near_to_the_smooth_surface_as_it_says) {
  for (const double tolerance : {0.05, 0.004}) {
    const CyclideChain chain = test::twisted_crane_hook();
    const Chain tube = cyclide_tube(chain);
    const RingSampling sampling{segments_for(tube, tolerance), 0.3, 0};
    const Tessellation result = tessellate(tube, sampling, {tolerance});
    EXPECT_LE(result.error_bound, tolerance);
    double largest = 0;
    const std::size_t step = result.mesh.triangles.size() / 499;  // all around and all along
    for (std::size_t i = 0; i < result.mesh.triangles.size(); i += step) {
      const auto& [a, b, c] = result.mesh.triangles[i];
      const Vec3 &p = result.mesh.points[a], &q = result.mesh.points[b], &r = result.mesh.points[c];
      for (const Vec3& inner : {Vec3((p + q + r) / 3), Vec3((p + q) / 2), Vec3((p + r) / 2)}) {
        largest = std::max(largest, std::abs(distance_to_tube(chain, inner)));
      }
      EXPECT_NEAR(distance_to_tube(chain, p), 0, 1e-12);
    }
    EXPECT_LE(largest, result.error_bound);
    EXPECT_GE(largest, result.error_bound / 5) << "the bound would be useless";
  }
}

TEST(CyclideTube, mesh_ends_in_the_stored_rings_bitwise) {
  const Chain tube = cyclide_tube(test::twisted_crane_hook());
  const RingSampling sampling{64, 0.25, std::ldexp(1.0, -20)};
  const TriMesh mesh = tessellate(tube, sampling, {0.01}).mesh;
  const auto first = sample(flipped(end_ring(tube, End::start)), sampling);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), mesh.points.begin()));
  auto last = sample(end_ring(tube, End::end), sampling);
  std::vector<Vec3> found(mesh.points.end() - 64, mesh.points.end());
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::sort(last.begin(), last.end(), before);
  std::sort(found.begin(), found.end(), before);
  EXPECT_EQ(found, last);
}

TEST(CyclideTube, mesh_area_and_volume_converge_at_second_order) {
  struct Row {
    const char* name;
    Chain tube;
  };
  for (const Row& row : {Row{"hook", cyclide_tube(test::crane_hook())},
                         Row{"twisted hook", cyclide_tube(test::twisted_crane_hook())},
                         Row{"jet engine", cyclide_tube(test::jet_engine())},
                         Row{"jet engine shell", cyclide_tube(test::jet_engine(), 0.08)}}) {
    SCOPED_TRACE(row.name);
    // Four times the tolerance are half the segments and, but for whole numbers, half the bands.
    constexpr int kHalvings = 3;
    std::array<Measure, 2> errors;
    for (std::size_t i = 0; i < 2; ++i) {
      const double tolerance = 0.0025 / std::pow(4, i == 0 ? 0 : kHalvings);
      const RingSampling sampling{segments_for(row.tube, tolerance)};
      const Tessellation result = tessellate(row.tube, sampling, {tolerance});
      errors.at(i) = measure_closed(row.tube, result, sampling);
      errors.at(i).volume -= volume(row.tube);
      errors.at(i).area -= area(row.tube) + rim_area(row.tube);
    }
    // Areas may converge faster, where chords and tilted triangles err to opposite sides.
    const auto order = [](double coarse, double fine) {
      return std::log2(std::abs(coarse / fine)) / kHalvings;
    };
    EXPECT_GE(order(errors[0].volume, errors[1].volume), 1.9);
    EXPECT_GE(order(errors[0].area, errors[1].area), 1.9);
  }
}

TEST(CyclideTube, hollow_tubes_are_closed_solids_of_genus_one) {
  for (const Chain& tube :
       {cyclide_tube(test::jet_engine(), 0.08), cyclide_tube(test::twisted_crane_hook(), 0.05)}) {
    const Report report = check(tessellate(tube, {64}, {0.01}).mesh);
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(report.euler_number, 0);
    EXPECT_EQ(report.count(Defect::self_intersection), 0U);
  }
}

TEST(CyclideTube, shell_of_the_jet_engine_has_the_volume_between_the_skins) {
  // Totals of the oracle; the rims are frustums between the planes of the end circles.
  const Chain shell = cyclide_tube(test::jet_engine(), 0.08);
  const auto frustum = [](double height, double a, double b) {
    return pi / 3 * height * (a * a + a * b + b * b);
  };
  const double start_height = 0.08 * 0.3, outer = std::sqrt(0.91);
  const double start = -frustum(start_height, outer, outer - 0.08 * std::sqrt(0.91));
  const double end =
      frustum(7.70469662505093 - 7.72020723616958, 0.608235333051665, 0.529753354593386);
  EXPECT_NEAR(volume(shell), 32.6017075823414 - 28.1411077844669 + start + end, 1e-11);
  EXPECT_NEAR(area(shell), 56.9314115782447 + 52.6134360153932, 1e-11);
}

TEST(CyclideTube, walls_thicker_than_the_tube_are_refused) {
  try {
    (void)cyclide_tube(test::crane_hook(), 0.4);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    EXPECT_EQ(error.part(), "piece 5");  // ends with radius 0.25
  }
  EXPECT_THROW((void)cyclide_tube(test::crane_hook(), -0.1), Error);
}

TEST(CyclideTube, margin_of_a_torus_is_one_minus_kappa_r) {
  const PeArc elbow = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitZ(), 0),
                                  test::sphere(3, 0, 3, 1));
  const Enclosure bounds = margin(elbow);
  EXPECT_TRUE(bounds.contains(1 - 1.0 / 3)) << bounds.lower << " " << bounds.upper;
  EXPECT_LT(bounds.upper - bounds.lower, 1e-12);
}

// Per tangential length, the least speed at which the points of the circle move along the axis of
// its cone, times the secant of the half angle: measured by differences.
double measured_margin(const PeArc& arc) {
  double least = std::numeric_limits<double>::infinity();
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) / kSteps, h = 0.5 / kSteps;
    const Ring a = circle_at(arc, t - h), b = circle_at(arc, t + h), m = circle_at(arc, t);
    const double length =
        std::sqrt(squared_tangential_distance(sphere_at(arc, t - h), sphere_at(arc, t + h)));
    const double advance =
        (b.center - a.center).dot(m.normal) - m.radius * (b.normal - a.normal).norm();
    least = std::min(least, advance / length * std::hypot(1, m.slope));
  }
  return least;
}

TEST(CyclideTube, margin_is_the_least_measured_advance) {
  RandomArcs arcs;
  for (int i = 0; i < 60; ++i) {
    const PeArc arc = arcs.next();
    const Enclosure bounds = margin(arc);
    EXPECT_LE(bounds.lower, bounds.upper);
    EXPECT_LT(bounds.upper - bounds.lower, 1e-8);
    EXPECT_GT(bounds.lower, 0);
    if (arc.w() > -0.5) {  // else differences of this step are too coarse
      EXPECT_NEAR(measured_margin(arc), bounds.lower, 0.02 * std::max(1.0, bounds.lower)) << i;
    }
  }
}

TEST(CyclideTube, needs_a_piece) {
  for (const auto& ask : std::vector<std::function<void()>>{
           [] { (void)hollow(Chain(), 0.1); }, [] { (void)hollow(Chain(), 0); },
           [] { (void)inner_skin(Chain()); }, [] { (void)area(Chain()); },
           [] { (void)volume(Chain()); }, [] { (void)kind(Chain()); },
           [] { (void)cyclide_tube(CyclideChain()); },
           [] { (void)cyclide_tube(CyclideChain(), Ring(), Ring()); }}) {
    EXPECT_EQ(test::message_of(ask, Errc::invalid_argument), "a chain needs at least one piece");
  }
}

}  // namespace
}  // namespace dupin
