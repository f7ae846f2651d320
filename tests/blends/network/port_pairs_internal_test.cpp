#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "network/port_pairs.h"

namespace dupin::network {
namespace {

PipingComponent pipe(const Vec3& from, const Vec3& to, double radius = 1) {
  PipingComponent component;
  component.ports = {{from, radius, 1}, {to, radius, 2}};
  return component;
}

std::vector<PortPair> pairs_of(const std::vector<PipingComponent>& components, double snap,
                               double bridge = 0) {
  return paired(line_ports({{}, components}, std::vector<bool>(components.size())), snap, bridge);
}

TEST(LinePorts, look_out_of_their_components) {
  PipingComponent tee = pipe({-1, 0, 0}, {1, 0, 0});
  tee.shape = PipingShape::fitting;
  tee.center = Vec3(0, 0, 0);
  tee.ports.push_back({{0, 0, 5}, 1, 3});
  tee.ports.push_back({{0, 0, 0}, 1, 4});  // in its centre: none
  PipingComponent plate;
  plate.shape = PipingShape::closure;
  plate.ports = {{{0, 0, 5}, {}, 5}};
  const auto ports =
      line_ports({{}, {tee, pipe({1, 0, 0}, {3, 0, 0}), plate}}, {false, false, false});
  ASSERT_EQ(ports.size(), 6);
  EXPECT_EQ(*ports[0].outward, Vec3(-1, 0, 0));
  EXPECT_EQ(*ports[2].outward, Vec3(0, 0, 1));
  EXPECT_EQ(*ports[4].outward, Vec3(1, 0, 0));
  EXPECT_FALSE(ports[5].outward);
  EXPECT_EQ(line_ports({{}, {tee, plate}}, {true, false}).size(), 1);
}

TEST(PortPairs, are_those_within_the_snap_and_then_the_bridge) {
  const std::vector<PipingComponent> line{
      pipe({0, 0, 0}, {10, 0, 0}), pipe({10.04, 0, 0}, {20, 0, 0}), pipe({20.3, 0, 0}, {30, 0, 0})};
  ASSERT_EQ(pairs_of(line, .05).size(), 1);
  EXPECT_EQ(pairs_of(line, .05)[0].first, 1);
  EXPECT_EQ(pairs_of(line, .05)[0].second, 2);
  EXPECT_NEAR(pairs_of(line, .05)[0].distance, .04, 1e-12);
  EXPECT_EQ(pairs_of(line, .03).size(), 0);
  EXPECT_EQ(pairs_of(line, .05, .3 + 1e-9).size(), 2);
  EXPECT_EQ(pairs_of(line, 0).size(), 0);
}

TEST(PortPairs, face_each_other_best) {
  // Three pipes meet in one point; the two on one line belong together.
  const std::vector<PipingComponent> line{pipe({0, 0, 0}, {10, 0, 0}), pipe({10, 0, 0}, {10, 5, 0}),
                                          pipe({10, 0, 0}, {20, 0, 0})};
  const auto pairs = pairs_of(line, .1);
  ASSERT_EQ(pairs.size(), 1);
  EXPECT_EQ(pairs[0].second, 4);
}

TEST(PortPairs, prefer_equal_radii) {
  const std::vector<PipingComponent> line{pipe({0, 0, 0}, {10, 0, 0}, 2),
                                          pipe({10, 0, 0}, {15, 0, 0}, 1),
                                          pipe({10, 0, 0}, {20, 0, 0}, 2)};
  ASSERT_EQ(pairs_of(line, .1).size(), 1);
  EXPECT_EQ(pairs_of(line, .1)[0].second, 4);
}

TEST(PortPairs, never_join_ends_that_look_the_same_way_or_of_one_component) {
  EXPECT_TRUE(pairs_of({pipe({0, 0, 0}, {10, 0, 0}), pipe({0, 0, 1}, {10, 0, 0})}, .1).empty());
  EXPECT_TRUE(pairs_of({pipe({0, 0, 0}, {.05, 0, 0})}, .1).empty());
}

TEST(PortPairs, are_not_sought_without_end_among_ends_that_crowd) {
  std::vector<PipingComponent> star;
  for (int i = 0; i < 2100; ++i) {
    const double angle = .5 * std::numbers::pi * i;
    star.push_back(pipe({0, 0, 0}, {9 * std::cos(angle) + i, 9 * std::sin(angle), 1. * i}));
  }
  try {
    (void)pairs_of(star, .1);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    EXPECT_STREQ(
        error.what(),
        "more than 2000000 pairs of ends lie within 0.1 of each other, as at line 1; a smaller "
        "snap or bridge length may do");
  }
}

TEST(PortPairs, know_the_kink) {
  const auto ports = line_ports(
      {{}, {pipe({0, 0, 0}, {10, 0, 0}), pipe({10, 0, 0}, {10 + std::cos(.3), std::sin(.3), 0})}},
      {false, false});
  EXPECT_NEAR(kink(ports[1], ports[2]), .3, 1e-12);
  EXPECT_NEAR(kink(ports[0], ports[2]), std::numbers::pi - .3, 1e-12);
}

}  // namespace
}  // namespace dupin::network
