#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/tessellate.h"
#include "dupin/kernel/error.h"
#include "tessellation/trimmed_face.h"

namespace dupin::tessellation {
namespace {

constexpr double kPi = std::numbers::pi;

// About the z axis, from z = 0 to 4.
struct Frustum {
  double start = 1, end = 1;

  [[nodiscard]] double radius(double z) const { return start + (end - start) * z / 4; }
  [[nodiscard]] Vec3 point(double angle, double z) const {
    return {radius(z) * std::cos(angle), radius(z) * std::sin(angle), z};
  }
  [[nodiscard]] TrimmedFace face() const {
    const double slope = (end - start) / 4;
    return {{{0, 0, 0}, {0, 0, -1}, start, -slope}, {{0, 0, 4}, {0, 0, 1}, end, slope}, {}};
  }
  [[nodiscard]] std::vector<Vec3> hole(double angle, double z, double half_angle,
                                       double half_height, int corners) const {
    std::vector<Vec3> curve;
    for (int i = 0; i < corners; ++i) {
      const double t = 2 * kPi * i / corners;
      curve.push_back(point(angle + half_angle * std::cos(t), z + half_height * std::sin(t)));
    }
    return curve;
  }
  [[nodiscard]] std::vector<Vec3> wave(double z, double height, int corners) const {
    std::vector<Vec3> curve;
    for (int i = 0; i < corners; ++i) {
      const double t = 2 * kPi * i / corners;
      curve.push_back(point(t, z + height * std::cos(2 * t)));
    }
    return curve;
  }
};

using Sides = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

Sides open_sides(const TriMesh& mesh) {
  Sides sides;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = t[i], b = t[(i + 1) % 3];
      if (const auto back = sides.find({b, a}); back != sides.end()) {
        sides.erase(back);
      } else {
        EXPECT_EQ((++sides[{a, b}]), 1) << "a side is run along twice in one sense";
      }
    }
  }
  return sides;
}

// Every triangle looks outwards and is, all over, as near as is said.
void expect_near(const Frustum& frustum, const Tessellation& result) {
  for (const Triangle& t : result.mesh.triangles) {
    const Vec3 &a = result.mesh.points[t[0]], &b = result.mesh.points[t[1]],
               &c = result.mesh.points[t[2]];
    const Vec3 middle = (a + b + c) / 3;
    EXPECT_GT((b - a).cross(c - a).dot(Vec3(middle.x(), middle.y(), 0)), 0);
    for (const Vec3& p : {middle, Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2)}) {
      const double off = std::abs(std::hypot(p.x(), p.y()) - frustum.radius(p.z()));
      EXPECT_LE(off, result.error_bound);
    }
  }
}

double area(const TriMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += (mesh.points[t[1]] - mesh.points[t[0]])
               .cross(mesh.points[t[2]] - mesh.points[t[0]])
               .norm() /
           2;
  }
  return sum;
}

TEST(TrimmedFace, has_a_hole_where_a_curve_is) {
  for (const Frustum& frustum : {Frustum{}, Frustum{2, 0.5}, Frustum{0.1, 0.2}}) {
    TrimmedFace face = frustum.face();
    // One across the first corner's ruling, one beside it, higher.
    face.curves = {frustum.hole(0.1, 2, 0.7, 1.2, 50), frustum.hole(kPi, 3.2, 1.2, 0.5, 71)};
    const RingSampling sampling{48};
    const Tessellation result = trimmed_face(face, sampling);
    expect_near(frustum, result);
    EXPECT_EQ(open_sides(result.mesh).size(), 48U + 48U + 50U + 71U);
    EXPECT_GT(result.mesh.points.size(), 48U + 48U + 50U + 71U);
    EXPECT_GT(smallest_angle(result.mesh), 2 * kPi / 180);
    EXPECT_LE(result.error_bound,
              1.01 * std::max(frustum.start, frustum.end) * (1 - std::cos(kPi / 48)))
        << "no triangle spans more than a segment";
    const auto first = sample(flipped(face.start), sampling), last = sample(face.end, sampling);
    EXPECT_TRUE(std::equal(first.begin(), first.end(), result.mesh.points.begin()));
    EXPECT_TRUE(std::equal(last.rbegin(), last.rend(), result.mesh.points.rbegin()));
  }
}

TEST(TrimmedFace, ends_in_a_wave_or_goes_from_wave_to_wave) {
  const Frustum frustum{1.5, 1};
  for (const bool at_start : {false, true}) {
    TrimmedFace face = frustum.face();
    face.curves = {frustum.wave(2, 1.9, 100)};
    (at_start ? face.keeps_start : face.keeps_end) = false;
    const Tessellation result = trimmed_face(face, {40});
    expect_near(frustum, result);
    EXPECT_EQ(open_sides(result.mesh).size(), 140U);
    // The mean of the integral of the radius over the heights below the wave, and what is left.
    const double below = 1.5 * 2 - 0.125 / 2 * (4 + 1.9 * 1.9 / 2), all = 1.25 * 4;
    EXPECT_NEAR(area(result.mesh),
                2 * kPi * (at_start ? all - below : below) * std::hypot(1, 0.125), 0.05);
  }
  TrimmedFace face = frustum.face();
  face.curves = {frustum.wave(3, 0.5, 64), frustum.wave(1, 0.7, 64)};
  const Tessellation ends = trimmed_face(face, {40});
  EXPECT_EQ(open_sides(ends.mesh).size(), 40U + 64U + 64U + 40U) << "what lies between is gone";
  face.keeps_start = face.keeps_end = false;
  const Tessellation between = trimmed_face(face, {40});
  EXPECT_EQ(open_sides(between.mesh).size(), 128U);
  expect_near(frustum, ends);
  expect_near(frustum, between);
}

// Rings that are not sampled from the same angle, or turned by a phase.
TEST(TrimmedFace, takes_over_the_rings_polygons_at_any_phase) {
  TrimmedFace face = Frustum{}.face();
  face.curves = {Frustum{}.hole(2, 2, 0.4, 1.99, 17)};
  for (const double phase : {0.0, 0.37, 0.91}) {
    const Tessellation result = trimmed_face(face, {12, phase, 0x1p-12});
    EXPECT_EQ(open_sides(result.mesh).size(), 12U + 12U + 17U);
    expect_near({}, result);
  }
}

TEST(TrimmedFace, keeps_curves_that_meet_in_a_corner) {
  const Frustum frustum;
  TrimmedFace face = frustum.face();
  face.curves = {frustum.hole(0, 2, 1, 1, 20), frustum.hole(2, 2, 1, 1, 20)};
  face.curves[1][10] = face.curves[0][0];  // both are at angle 1
  const Tessellation result = trimmed_face(face, {32});
  EXPECT_EQ(open_sides(result.mesh).size(), 32U + 32U + 40U);
}

TEST(TrimmedFace, refuses_curves_that_cross_or_leave) {
  const Frustum frustum;
  const auto refusal = [&](const std::vector<std::vector<Vec3>>& curves) {
    TrimmedFace face = frustum.face();
    face.curves = curves;
    try {
      (void)trimmed_face(face, {32});
    } catch (const Error& error) {
      return error.code();
    }
    return Errc::internal;
  };
  EXPECT_EQ(refusal({frustum.hole(0, 2, 1, 1, 20), frustum.hole(1, 2, 1, 1, 20)}),
            Errc::self_intersecting);
  EXPECT_EQ(refusal({frustum.hole(0, 3.5, 1, 1, 20)}), Errc::self_intersecting);
  EXPECT_EQ(refusal({frustum.hole(0, 3, 1, 1, 20)}), Errc::self_intersecting) << "it touches";
  for (const double at : {0., 3.1}) {
    EXPECT_EQ(refusal({frustum.hole(at, 2, 1, 1, 20), frustum.hole(at + 0.1, 2, 0.5, 0.4, 33)}),
              Errc::self_intersecting)
        << "one lies inside another";
  }
}

}  // namespace
}  // namespace dupin::tessellation
