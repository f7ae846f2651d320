#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <TopExp_Explorer.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/occt/body_shapes_internal.h"
#include "occt/body_booleans.h"
#include "occt/fillet_surfaces.h"

namespace dupin::occt {
namespace {

constexpr double kLevel = 2, kRadius = 0.5, kPost = 1;

/// A round plate up to z = 2, as wide as to hold a fillet, and a post on it.
exchange::Body plate() {
  exchange::Body body;
  body.name = "plate";
  body.rings = {{{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, 5, 5},
                {{0, 0, kLevel}, {0, 0, 1}, {1, 0, 0}, 5, 5}};
  body.tubes = {{0, 0, 1, exchange::CylinderOrCone{}}};
  body.discs = {{1, 0, {0, 0, -1}}, {2, 1, {0, 0, 1}}};
  return body;
}

exchange::Body post() {
  exchange::Body body;
  body.name = "post";
  body.rings = {{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, kPost, kPost},
                {{0, 0, 8}, {0, 0, 1}, {1, 0, 0}, kPost, kPost}};
  body.tubes = {{3, 0, 1, exchange::CylinderOrCone{}}};
  body.discs = {{4, 0, {0, 0, -1}}, {5, 1, {0, 0, 1}}};
  return body;
}

// A quarter of a torus' tube, from the plate to the post, all around: exact.
NurbsSurface hollow_ring(double radius) {
  const double h = std::sqrt(0.5), out = kPost + radius, pi = std::numbers::pi;
  NurbsSurface surface;
  surface.degree_along = surface.degree_around = 2;
  surface.knots_around = {0, 0, 0, 1, 1, 1};
  surface.knots_along = {0, 0, 0, .25, .25, .5, .5, .75, .75, 1, 1, 1};
  const std::vector<std::array<double, 3>> profile = {// off the axis, height, weight
                                                      {out, kLevel, 1},
                                                      {kPost, kLevel, h},
                                                      {kPost, kLevel + radius, 1}};
  for (int i = 0; i <= 8; ++i) {
    const double weight = i % 2 == 0 ? 1 : h, far = i % 2 == 0 ? 1 : 1 / h, angle = pi / 4 * i;
    auto& row = surface.net.emplace_back();
    for (const auto& [off, height, w] : profile) {
      const double all = w * weight;
      row.push_back({off * far * std::cos(angle) * all, off * far * std::sin(angle) * all,
                     height * all, all});
    }
  }
  return surface;
}

exchange::BodyUnion with(const std::optional<double>& radius, const NurbsSurface& surface) {
  return {{plate(), post()}, {{"throat", 6, {2, 3}, radius, {surface}}}};
}

// Of the square beside a quarter of a circle, by Pappus.
double added(double r) {
  const double pi = std::numbers::pi, area = r * r * (1 - pi / 4);
  const double moment = r * r * r / 2 - pi / 4 * r * r * (r - 4 * r / (3 * pi));
  return 2 * pi * (kPost * area + moment);
}

TEST(FilletSurfaces, take_the_place_of_the_strips_beside_the_edge) {
  const double sharp = volume(united({{plate(), post()}, {}}).shape);
  const LabelledShape made = united(with({}, hollow_ring(kRadius)));
  EXPECT_TRUE(is_valid(made.shape));
  EXPECT_NEAR(volume(made.shape), sharp + added(kRadius), 1e-6);
  std::multiset<std::uint32_t> labels;
  for (TopExp_Explorer face(made.shape, TopAbs_FACE); face.More(); face.Next()) {
    labels.insert(*made.labels.Seek(face.Current()));
  }
  EXPECT_EQ(labels, (std::multiset<std::uint32_t>{0, 1, 2, 3, 5, 6}));
}

TEST(FilletSurfaces, are_refused_where_they_do_not_touch) {
  NurbsSurface off = hollow_ring(kRadius);
  for (auto& row : off.net) {
    row.front()[2] += 3 * row.front()[3];  // up in the air
  }
  try {
    (void)united(with({}, off));
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.at(), "throat");
    EXPECT_THAT(refusal.what(), testing::HasSubstr("does not touch them"));
  }
}

// Of a ball of constant radius OpenCASCADE makes its own, which is as large.
TEST(FilletSurfaces, of_constant_radius_have_a_second_way) {
  NurbsSurface off = hollow_ring(kRadius);
  for (auto& row : off.net) {
    row.front()[2] += 3 * row.front()[3];
  }
  const double sharp = volume(united({{plate(), post()}, {}}).shape);
  const LabelledShape made = united(with(kRadius, off));
  EXPECT_TRUE(is_valid(made.shape));
  EXPECT_NEAR(volume(made.shape), sharp + added(kRadius), 1e-4);
}

}  // namespace
}  // namespace dupin::occt
