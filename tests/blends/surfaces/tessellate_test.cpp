#include "dupin/blends/tessellate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/cyclic_blend.h"
#include "dupin/kernel/error.h"
#include "support/mesh_distance.h"
#include "support/message_of.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

RingedSurface blend(const Vec3& from, const Vec3& a2, const Vec3& to, const Vec3& a3, double k,
                    double l, const RadiusLaw& law) {
  return {{from, -a2, evaluate(law, 0).value},
          {to, a3, evaluate(law, 1).value},
          HermiteSpine{from, to, k * a2, l * a3},
          law};
}

RingedSurface figure_6(const RadiusLaw& law) {
  return blend(Vec3::Zero(), Vec3::UnitX(), Vec3(10, 4, 0), Vec3(1, 2, 10).normalized(), 10, 20,
               law);
}

RingedSurface elbow(double bend_radius, double radius, double angle) {
  const Vec3 end(bend_radius * std::sin(angle), bend_radius * (1 - std::cos(angle)), 0);
  return {{Vec3::Zero(), -Vec3::UnitX(), radius},
          {end, Vec3(std::cos(angle), std::sin(angle), 0), radius},
          ArcSpine{Vec3(0, bend_radius, 0), Vec3::UnitZ(), Vec3::Zero(), angle},
          ConstantRadius{radius}};
}

RingedSurface straight(const Vec3& from, const Vec3& to, double start, double end) {
  const Vec3 along = (to - from).normalized();
  return {{from, -along, start}, {to, along, end}, LineSpine{from, to}, LinearRadius{start, end}};
}

// The distance from points of the surface, on a fine lattice of parameters, to the mesh: brute
// force over all triangles.
double measured_deviation(const RingedSurface& surface, const TriMesh& mesh, int along,
                          int around) {
  const FrameField frames(surface.spine, reference_axis(surface.start));
  double largest = 0;
  for (int i = 0; i <= along; ++i) {
    for (int k = 0; k < around; ++k) {
      const Vec3 p = evaluate(surface, frames, double(i) / along, 2 * kPi * k / around).position;
      largest = std::max(largest, test::distance_to(p, mesh));
    }
  }
  return largest;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Directed edges that do not occur once in each direction.
std::vector<Edge> unmatched_edges(const TriMesh& mesh) {
  std::map<Edge, int> count;
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const Edge& edge : {Edge(a, b), Edge(b, c), Edge(c, a)}) {
      ++count[edge];
    }
  }
  std::vector<Edge> result;
  for (const auto& [edge, times] : count) {
    const auto back = count.find({edge.second, edge.first});
    if (times != 1 || back == count.end() || back->second != 1) {
      result.push_back(edge);
    }
  }
  return result;
}

TEST(SecondDerivativeBounds, agree_with_the_suprema_of_figure_6) {
  struct Row {
    RadiusLaw law;
    double along, mixed, around;
  };
  const Row rows[] = {{CubicRadius{1, 2}, 126.89082833, 9.99213959, 2},
                      {CyclideRadius{1, 2}, 128.41417681, 9.90998394, 2}};
  constexpr int kCells = 1 << 16;
  for (const auto& row : rows) {
    SecondDerivativeBounds sup;
    for (int i = 0; i < kCells; ++i) {
      const auto cell =
          second_derivative_bounds(figure_6(row.law), double(i) / kCells, double(i + 1) / kCells);
      sup.along = std::max(sup.along, cell.along);
      sup.mixed = std::max(sup.mixed, cell.mixed);
      sup.around = std::max(sup.around, cell.around);
    }
    // Upper bounds, up to the digits of the table, and tight in proportion to the cells.
    EXPECT_GT(sup.along, row.along - 5e-9);
    EXPECT_LT(sup.along, row.along * (1 + 1e-3));
    EXPECT_GT(sup.mixed, row.mixed - 5e-9);
    EXPECT_LT(sup.mixed, row.mixed * (1 + 1e-3));
    EXPECT_GE(sup.around, row.around);
    EXPECT_LT(sup.around, row.around * (1 + 1e-12));
  }
}

TEST(SecondDerivativeBounds, hold_at_sampled_parameters) {
  const RingedSurface surfaces[] = {figure_6(CubicRadius{1, 2}), figure_6(CyclideRadius{2, 1}),
                                    elbow(3, 1, 2), straight(Vec3::Zero(), Vec3(1, 2, 3), 1, 2)};
  for (const auto& surface : surfaces) {
    const FrameField frames(surface.spine, reference_axis(surface.start), {.knots = 4096});
    for (int i = 0; i < 16; ++i) {
      const auto bound = second_derivative_bounds(surface, i / 16.0, (i + 1) / 16.0);
      const double h = 1.0 / 4096, t = (i + 0.5) / 16;
      for (int k = 0; k < 12; ++k) {
        const double u = 2 * kPi * k / 12;
        const auto at = [&](double dt, double du) {
          return evaluate(surface, frames, t + dt, u + du).position;
        };
        // Central differences; their truncation is of order h^2.
        const Vec3 tt = (at(h, 0) - 2 * at(0, 0) + at(-h, 0)) / (h * h);
        const Vec3 tu = (at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h);
        const Vec3 uu = (at(0, h) - 2 * at(0, 0) + at(0, -h)) / (h * h);
        EXPECT_LE(tt.norm(), bound.along + 1e-4);
        EXPECT_LE(tu.norm(), bound.mixed + 1e-4);
        EXPECT_LE(uu.norm(), bound.around + 1e-4);
      }
    }
  }
}

TEST(SecondDerivativeBounds, refuse_a_spine_that_stops) {
  const auto stopped =
      blend(Vec3::Zero(), Vec3::UnitX(), Vec3(6, 0, 0), Vec3::UnitX(), 18, 18, CubicRadius{1, 2});
  EXPECT_THROW((void)second_derivative_bounds(stopped, 0.25, 0.75), Error);
}

TEST(Tessellation, needs_no_more_bands_than_the_papers_march) {
  struct Row {
    double tolerance;
    std::uint32_t segments, bands_r1, bands_r2;
  };
  // The march of D.3; ours pays besides for the twist between the two end rings and for a proof of
  // the frame's drift.
  const Row rows[] = {
      {0.1, 20, 14, 14}, {0.01, 63, 40, 39}, {0.001, 199, 122, 121}, {0.0001, 629, 382, 379}};
  for (const auto& row : rows) {
    const auto r1 = figure_6(CubicRadius{1, 2}), r2 = figure_6(CyclideRadius{1, 2});
    EXPECT_EQ(segments_for(r1, row.tolerance), row.segments);
    EXPECT_EQ(segments_for(r2, row.tolerance), row.segments);
    const auto mesh_1 = tessellate(r1, {row.segments}, {row.tolerance});
    const auto mesh_2 = tessellate(r2, {row.segments}, {row.tolerance});
    EXPECT_LE(mesh_1.bands, row.bands_r1 + 1 + row.bands_r1 / 100);
    EXPECT_LE(mesh_2.bands, row.bands_r2 + 1 + row.bands_r2 / 100);
    EXPECT_LE(mesh_1.error_bound, row.tolerance);
    EXPECT_LE(mesh_2.error_bound, row.tolerance);
  }
}

TEST(Tessellation, is_within_the_tolerance_of_random_blends) {
  std::mt19937_64 random(20301);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto direction = [&] {
    return Vec3(uniform(random), uniform(random), uniform(random)).normalized();
  };
  for (int i = 0; i < 24; ++i) {
    const Vec3 to = 10 * direction();
    const Vec3 a2 = (to.normalized() + 0.5 * direction()).normalized();
    const Vec3 a3 = (to.normalized() + 0.5 * direction()).normalized();
    const double r0 = 0.4 + 0.2 * uniform(random), r1 = 0.8 + 0.3 * uniform(random);
    const RadiusLaw law = i % 2 == 0 ? RadiusLaw(CubicRadius{r0, r1}) : CyclideRadius{r0, r1};
    const auto surface = blend(direction(), a2, to, a3, 10, 10, law);
    const double tolerance = i % 3 == 0 ? 0.1 : 0.02;
    const RingSampling sampling{segments_for(surface, tolerance), 0.13 * i,
                                i % 2 == 0 ? 0 : std::ldexp(1.0, -14)};
    const auto result = tessellate(surface, sampling, {tolerance});
    EXPECT_LE(result.error_bound, tolerance);
    EXPECT_LE(measured_deviation(surface, result.mesh, 37, 23), result.error_bound);
  }
}

TEST(Tessellation, is_within_the_tolerance_of_elbows_and_straight_parts) {
  const RingedSurface surfaces[] = {elbow(3, 1, kPi / 2), elbow(1.2, 1, 6), elbow(30, 1, 0.01),
                                    straight(Vec3(1, 2, 3), Vec3(4, 4, -3), 2, 2),
                                    straight(Vec3(1, 2, 3), Vec3(4, 4, -3), 2, 0.1)};
  for (const auto& surface : surfaces) {
    const double tolerance = 0.03;
    const auto result = tessellate(surface, {segments_for(surface, tolerance), 0.37}, {tolerance});
    EXPECT_LE(result.error_bound, tolerance);
    EXPECT_LE(measured_deviation(surface, result.mesh, 40, 23), result.error_bound);
  }
}

TEST(Tessellation, gives_straight_parts_one_band) {
  for (const double end : {2.0, 1.0}) {
    const auto surface = straight(Vec3(1, 2, 3), Vec3(4, 4, -3), 2, end);
    const auto n = segments_for(surface, 0.01);
    EXPECT_LE(2 * (1 - std::cos(kPi / n)), 0.01);
    EXPECT_GT(2 * (1 - std::cos(kPi / (n - 1))), 0.0099);
    EXPECT_EQ(tessellate(surface, {n}, {0.01}).bands, 1U);
  }
}

TEST(Tessellation, ends_in_the_samples_of_its_rings) {
  const auto surface = figure_6(CubicRadius{1, 2});
  const RingSampling sampling{24, 0.37, std::ldexp(1.0, -12)};
  const auto mesh = tessellate(surface, sampling, {0.1}).mesh;
  const auto first = sample(flipped(surface.start), sampling);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), mesh.points.begin()));
  auto last = sample(surface.end, sampling);
  const auto shifted = std::find(last.begin(), last.end(), mesh.points[mesh.points.size() - 24]);
  ASSERT_NE(shifted, last.end());
  std::rotate(last.begin(), shifted, last.end());
  EXPECT_TRUE(std::equal(last.begin(), last.end(), mesh.points.end() - 24));
}

TEST(Tessellation, of_the_reversed_figure_6_has_the_volume_of_the_table) {
  // Divergence theorem; the mesh of bound e differs by at most e times its area (125.15).
  const auto surface = figure_6(CubicRadius{1, 2});
  const RingSampling sampling{segments_for(surface, 1e-3)};
  const auto tube = tessellate(surface, sampling, {1e-3});
  TriMesh soup = tube.mesh;
  for (const Ring& ring : {surface.start, surface.end}) {
    const TriMesh end = end_cap_mesh(ring, sampling);
    const auto offset = std::uint32_t(soup.points.size());
    soup.points.insert(soup.points.end(), end.points.begin(), end.points.end());
    for (const auto& [a, b, c] : end.triangles) {
      soup.triangles.push_back({a + offset, b + offset, c + offset});
    }
  }
  double volume = 0;
  for (const auto& [a, b, c] : soup.triangles) {
    volume += soup.points[a].cross(soup.points[b]).dot(soup.points[c]) / 6;
  }
  EXPECT_NEAR(volume, 98.7626771261853, 1e-3 * 125.2);
  EXPECT_LT(volume, 98.7626771261853);
}

TEST(Tessellation, with_fixed_segments_says_what_it_keeps) {
  const auto surface = figure_6(CubicRadius{1, 2});
  const auto coarse = tessellate(surface, {12}, {1e-4});
  EXPECT_GT(coarse.error_bound, 1e-4);
  EXPECT_LE(measured_deviation(surface, coarse.mesh, 41, 31), coarse.error_bound);
  EXPECT_LT(coarse.bands, 30U);
}

TEST(Tessellation, refuses_what_cannot_be_kept) {
  const auto surface = figure_6(CubicRadius{1, 2});
  EXPECT_THROW((void)segments_for(surface, 0), Error);
  EXPECT_THROW((void)segments_for(surface, std::nan("")), Error);
  EXPECT_THROW((void)segments_for(surface, 1e-13), Error);
  EXPECT_THROW((void)segments_for(surface, 1e-12), Error);
  EXPECT_THROW((void)tessellate(surface, {24, 0, 0.5}, {0.1}), Error);
  EXPECT_THROW((void)tessellate(surface, {2}, {0.1}), Error);
}

TEST(Tessellation, of_a_sphere_is_closed_and_within_the_tolerance) {
  const Sphere sphere{Vec3(1, 2, 3), 2};
  for (const double tolerance : {1.0, 0.1, 0.01}) {
    const auto n = segments_for(sphere, tolerance, std::ldexp(1.0, -20));
    const auto result = tessellate(sphere, {n, 0.37, std::ldexp(1.0, -20)});
    EXPECT_LE(result.error_bound, tolerance);
    EXPECT_THAT(unmatched_edges(result.mesh), testing::IsEmpty());
    double volume = 0;
    for (const auto& [a, b, c] : result.mesh.triangles) {
      const auto& p = result.mesh.points;
      volume += p[a].cross(p[b]).dot(p[c]) / 6;
      // The point of a triangle nearest to the centre is the furthest from the sphere.
      EXPECT_GE(test::distance_to_triangle(sphere.center, p[a], p[b], p[c]),
                sphere.radius - result.error_bound);
    }
    EXPECT_NEAR(volume, 4 * kPi / 3 * 8, result.error_bound * 4 * kPi * 4);
  }
}

TEST(Tessellation, of_a_sphere_needs_segments_that_bound_something) {
  for (const std::uint32_t segments : {0U, 1U, 2U, 0xffffffffU}) {
    EXPECT_THROW((void)tessellate(Sphere{}, {segments}), Error) << segments;
  }
  EXPECT_THAT(unmatched_edges(tessellate(Sphere{}, {3}).mesh), testing::IsEmpty());
  EXPECT_THROW((void)tessellate(Sphere{{0, 0, 0}, std::nan("")}, {16}), Error);
  EXPECT_THROW((void)tessellate(Sphere{{0, std::nan(""), 0}, 1}, {16}), Error);
}

TEST(Tessellation, is_as_coarse_as_can_be_for_any_large_tolerance) {
  Ring to{{4, 0, 10}, Vec3(-.6, 0, -.8)};
  const Chain chain(cyclic_blend(Ring{}, to));
  const auto coarse = tessellate(chain, {16}, {1e9}).mesh;
  for (const double tolerance : {1e100, 1e308, double(INFINITY)}) {
    EXPECT_EQ(tessellate(chain, {16}, {tolerance}).mesh.triangles, coarse.triangles) << tolerance;
  }
}

TEST(SmallestAngle, is_that_of_triangles_whose_corners_are_points) {
  TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_NEAR(smallest_angle(mesh), kPi / 4, 1e-15);
  mesh.triangles[0][1] = 3;
  EXPECT_THROW((void)smallest_angle(mesh), Error);
}

TEST(Disc, of_the_flipped_ring_has_the_same_triangles_the_other_way_round) {
  std::mt19937_64 random(20302);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (std::uint32_t n = 3; n < 40; ++n) {
    const Ring ring{Vec3(uniform(random), uniform(random), uniform(random)),
                    Vec3(uniform(random), uniform(random), uniform(random)).normalized(), 2};
    const RingSampling sampling{n, 0.37, n % 2 == 0 ? 0 : std::ldexp(1.0, -10)};
    const auto corners = [](const TriMesh& mesh, bool reversed) {
      std::vector<std::array<std::array<double, 3>, 3>> result;
      for (auto t : mesh.triangles) {
        if (reversed) {
          std::swap(t[1], t[2]);
        }
        std::array<std::array<double, 3>, 3> triangle{};
        for (std::size_t i = 0; i < 3; ++i) {
          const Vec3& p = mesh.points[t.at(i)];
          triangle.at(i) = {p.x(), p.y(), p.z()};
        }
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                    triangle.end());
        result.push_back(triangle);
      }
      std::sort(result.begin(), result.end());
      return result;
    };
    const auto here = end_cap_mesh(ring, sampling), there = end_cap_mesh(flipped(ring), sampling);
    EXPECT_EQ(here.triangles.size(), n - 2);
    EXPECT_EQ(corners(here, false), corners(there, true));
    for (const auto& [a, b, c] : here.triangles) {
      EXPECT_GT(
          (here.points[b] - here.points[a]).cross(here.points[c] - here.points[a]).dot(ring.normal),
          0);
    }
  }
}

TEST(Tessellate, needs_a_piece) {
  Chain spherical;
  spherical.joints = Joints::spherical;
  for (const Chain& chain : {Chain(), spherical}) {
    EXPECT_EQ(
        test::message_of([&] { (void)tessellate(chain, RingSampling()); }, Errc::invalid_argument),
        "a chain needs at least one piece");
  }
}

}  // namespace
}  // namespace dupin
