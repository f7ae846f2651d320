#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/blends/ringed_blend.h"
#include "dupin/blends/spine.h"
#include "dupin/blends/spline_pipe.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

// Every surface by its points x(t, u), to measure meshes against.
using Surface = std::function<Vec3(double, double)>;

// The least distance from a point to samples of the surface, refined by a pattern search: an upper
// bound of the distance.
double distance(const Surface& surface, const Vec3& point) {
  double best = std::numeric_limits<double>::infinity(), t = 0, u = 0;
  for (int i = 0; i <= 48; ++i) {
    for (int j = 0; j < 32; ++j) {
      const double d = (surface(i / 48., 2 * kPi * j / 32) - point).norm();
      if (d < best) {
        best = d;
        t = i / 48.;
        u = 2 * kPi * j / 32;
      }
    }
  }
  for (double step = 1; step > 1e-7; step *= .7) {
    for (const auto& [dt, du] : {std::pair(1., 0.), {-1., 0.}, {0., 1.}, {0., -1.}}) {
      const double at = std::clamp(t + dt * step / 48, 0., 1.), on = u + du * step / 16;
      const double d = (surface(at, on) - point).norm();
      if (d < best) {
        best = d;
        t = at;
        u = on;
      }
    }
  }
  return best;
}

double largest_deviation(const Surface& surface, const TriMesh& mesh) {
  double largest = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 7) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3 middle = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3;
    largest = std::max(largest, distance(surface, middle));
  }
  return largest;
}

// Open edges, each of which occurs once.
std::size_t open_edges(const TriMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const auto a = triangle.at(i), b = triangle.at((i + 1) % 3);
      edges[{a, b}] += 1;
      edges[{b, a}] -= 1;
    }
  }
  std::size_t open = 0;
  for (const auto& [edge, balance] : edges) {
    open += balance > 0 ? 1 : 0;
  }
  return open;
}

double enclosed(const TriMesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    six_volumes += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c]));
  }
  return six_volumes / 6;
}

const Ring kOval{Vec3(0, 0, 0), Vec3::UnitX(), 1.2, 0, Ellipse{Vec3(0, .6, .8), .7}};

Ring oval_outlet() {
  const Vec3 normal = -Vec3(1, 2, 10).normalized();
  const Vec3 axis = normal.cross(Vec3(1, .3, .2)).normalized();
  return {Vec3(14, 6, 3), normal, 1.5, 0, Ellipse{axis, .8}};
}

void expect_ends_on_rings(const TriMesh& mesh, const Ring& start, const Ring& end,
                          const RingSampling& sampling) {
  const auto first = sample(flipped(start), sampling), last = sample(end, sampling);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), mesh.points.begin()));
  EXPECT_TRUE(std::is_permutation(last.begin(), last.end(),
                                  mesh.points.end() - std::ptrdiff_t(last.size())));
}

TEST(TubeTessellation, of_an_elliptic_blend_keeps_the_bound_it_states) {
  const Ring circle{Vec3(14, 6, 3), oval_outlet().normal, 1.1};
  for (const Ring& to : {oval_outlet(), circle}) {
    const EllipticTube tube = elliptic_blend(kOval, to, {.margin = .02});
    const FrameField field = frames(tube);
    const Surface surface = [&](double t, double u) {
      return evaluate(tube, field, t, u).position;
    };
    for (const double tolerance : {.1, .02}) {
      const RingSampling sampling{segments_for(tube, tolerance), .37};
      const Tessellation result = tessellate(tube, sampling, {tolerance});
      EXPECT_LE(result.error_bound, tolerance);
      const double measured = largest_deviation(surface, result.mesh);
      EXPECT_LE(measured, result.error_bound);
      EXPECT_GE(measured, result.error_bound / 10);
      EXPECT_EQ(open_edges(result.mesh), 2 * sampling.segments);
      expect_ends_on_rings(result.mesh, tube.start, tube.end, sampling);
    }
  }
}

TEST(TubeTessellation, of_an_elliptic_cylinder_takes_one_row) {
  const EllipticTube tube = elliptic_tube(
      flipped(kOval), {Vec3(5, 0, 0), Vec3::UnitX(), 1.2, 0, kOval.ellipse},
      LineSpine{Vec3(0, 0, 0), Vec3(5, 0, 0)}, ConstantRadius{1.2}, ConstantRadius{.7});
  const RingSampling sampling{segments_for(tube, .01), .2};
  const Tessellation result = tessellate(tube, sampling, {.01});
  EXPECT_EQ(result.bands, 1);
  EXPECT_LE(result.error_bound, .01);
  expect_ends_on_rings(result.mesh, tube.start, tube.end, sampling);
}

TEST(TubeTessellation, of_a_ringed_blend_keeps_the_bound_it_states) {
  const RationalRingedTube oblique =
      oblique_tube(Vec3(0, 0, 0), Vec3(2, 0, 4), Vec3::UnitZ(), 1, 1.3);
  const MovingRing from = leaving(oblique, End::end);
  const Ring end{Vec3(8, 2, 9), Vec3::UnitX(), .8};
  const RationalRingedTube blend{
      flipped(oblique.end), end,
      ringed_blend(at_speed(from, 8), along_canal({end.center, end.normal, end.radius}, 0, 8))};
  for (const RationalRingedTube& tube : {oblique, blend}) {
    const Surface surface = [&](double t, double u) {
      return evaluate(tube.surface, t, u).position;
    };
    const RingSampling sampling{segments_for(tube, .03), .37};
    const Tessellation result = tessellate(tube, sampling, {.03});
    EXPECT_LE(result.error_bound, .03);
    EXPECT_LE(largest_deviation(surface, result.mesh), result.error_bound);
    EXPECT_EQ(open_edges(result.mesh), 2 * sampling.segments);
    expect_ends_on_rings(result.mesh, tube.start, tube.end, sampling);
  }
}

TEST(TubeTessellation, of_a_closed_pipe_is_closed) {
  const Chain ring(closed_spline_pipe({{Vec3(8, 0, 0), 1},
                                       {Vec3(3, 7, 3), 1.6},
                                       {Vec3(-6, 6, -1), 1},
                                       {Vec3(-7, -4, 3), .7},
                                       {Vec3(2, -8, -2), 1.2}}),
                   true);
  double volume_of_pieces = 0;
  for (const Piece& piece : ring.pieces) {
    volume_of_pieces += volume(std::get<RingedSurface>(piece));
  }
  double before = std::numeric_limits<double>::infinity();
  for (const double tolerance : {.1, .02, .004}) {
    const Tessellation result = tessellate(ring, {segments_for(ring, tolerance)}, {tolerance});
    EXPECT_EQ(open_edges(result.mesh), 0);
    const double missing = std::abs(volume_of_pieces - enclosed(result.mesh));
    EXPECT_LT(missing, before / 3);
    before = missing;
  }
}

TEST(SmallestAngle, is_that_of_the_sharpest_corner) {
  const TriMesh mesh{
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(4, 0, 1)}, {{0, 1, 2}, {0, 3, 2}}, {}, {}};
  EXPECT_NEAR(smallest_angle(mesh), std::atan(1 / std::sqrt(17)), 1e-15);
}

TEST(RingedTube, leaves_along_its_rulings) {
  const RationalRingedTube cone = oblique_tube(Vec3(0, 0, 0), Vec3(3, 0, 4), Vec3::UnitZ(), 1, 2);
  const MovingRing out = leaving(cone, End::end), in = leaving(cone, End::start);
  EXPECT_LT((out.center_rate / out.radius_rate - Vec3(3, 0, 4)).norm(), 1e-13);
  EXPECT_LT((in.center_rate / in.radius_rate - Vec3(3, 0, 4)).norm(), 1e-13);
  EXPECT_LT(in.radius_rate, 0);
  EXPECT_EQ(in.normal, -Vec3::UnitZ());
  EXPECT_THROW((void)oblique_tube(Vec3(0, 0, 0), Vec3(3, 0, 4), -Vec3::UnitZ(), 1, 2), Error);
}

TEST(RingedBlend, rises_out_of_a_plate) {
  const TravelRing hole{Vec3(0, 0, 0), Vec3::UnitZ(), 2}, top{Vec3(.5, 0, 4), Vec3::UnitZ(), 1};
  const auto surface = ringed_blend(along_plate(hole, -3), along_canal(top, 0, 4));
  EXPECT_GT(certified_margin(surface), 0);
  for (double u = 0; u < 6; u += .5) {
    EXPECT_NEAR(std::abs(evaluate(surface, 0, u).normal.z()), 1, 1e-14);
  }
  // Sideways out of its hole, the surface would start across the plate.
  MovingRing sliding = along_plate(hole, -3);
  sliding.center_rate = Vec3(1, 0, 0);
  EXPECT_THROW((void)ringed_blend(sliding, along_canal(top, 0, 4)), Error);
}

TEST(RationalRingedSurface, has_the_margin_of_the_torus_it_is) {
  // A quarter of nearly a torus of bend radius 3 and radius 1.
  const auto surface = canal_ringed_blend({{Vec3(0, 0, 0), Vec3::UnitZ(), 1}, 0, 4.7},
                                          {{Vec3(3, 0, 3), Vec3::UnitX(), 1}, 0, 4.7});
  double sampled = 1;
  for (int i = 0; i <= 200; ++i) {
    const MovingRing ring = ring_at(surface, i / 200.);
    sampled = std::min(
        sampled, 1 - ring.radius * ring.normal_rate.norm() / ring.center_rate.dot(ring.normal));
  }
  EXPECT_LE(certified_margin(surface), sampled);
  EXPECT_GE(certified_margin(surface), sampled - 1. / 128);
}

}  // namespace
}  // namespace dupin
