#include "dupin/blends/spline_pipe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/regularity.h"
#include "dupin/blends/tangency.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

const Ring kFrom{Vec3(0, 0, 0), Vec3::UnitX(), 1};
const Ring kTo{Vec3(30, 10, 0), -Vec3::UnitX(), 1.5};
const std::vector<Waypoint> kThrough{
    {Vec3(8, 3, 2), 1.2}, {Vec3(15, 10, 4), .8}, {Vec3(22, 11, 1), 1.5}};

// Joints are C2 by chord length: t runs over spans of different length.
void expect_smooth_joint(const RingedSurface& a, const RingedSurface& b) {
  EXPECT_EQ(b.start, flipped(a.end));
  const SpinePoint end = evaluate(a.spine, 1), start = evaluate(b.spine, 0);
  EXPECT_LT((end.position - start.position).norm(), 1e-14);
  const double stretch = start.first.norm() / end.first.norm();
  EXPECT_LT((end.first * stretch - start.first).norm(), 1e-12);
  EXPECT_LT((end.second * stretch * stretch - start.second).norm(), 1e-11);
  EXPECT_EQ(evaluate(a.radius, 1).first, 0);
  EXPECT_EQ(evaluate(b.radius, 0).first, 0);
  const FrameField before(a.spine, Vec3(.1, .2, 1)), after(b.spine, before.at(1).first);
  for (double u = 0; u < 6; u += .5) {
    const SurfacePoint x = evaluate(a, before, 1, u), y = evaluate(b, after, 0, u);
    EXPECT_LT((x.position - y.position).norm(), 1e-13);
    EXPECT_LT((x.normal - y.normal).norm(), 1e-13);
  }
}

TEST(SplinePipe, runs_smoothly_from_port_to_port) {
  const auto run = spline_pipe(kFrom, kThrough, kTo);
  ASSERT_EQ(run.size(), 4u);
  EXPECT_EQ(run.front().start, flipped(kFrom));
  EXPECT_EQ(run.back().end, flipped(kTo));
  for (std::size_t i = 0; i + 1 < run.size(); ++i) {
    EXPECT_EQ(run[i].end.center, kThrough[i].point);
    EXPECT_EQ(run[i].end.radius, kThrough[i].radius);
    expect_smooth_joint(run[i], run[i + 1]);
    EXPECT_EQ(prove_margin(run[i], .05).verdict, Verdict::proved);
  }
  EXPECT_EQ(tangency_at_end(run.front(), End::start).deviation.upper, 0);
}

TEST(SplinePipe, without_points_is_the_cubic_of_unit_speed_by_chord) {
  const auto run = spline_pipe(kFrom, {}, kTo);
  ASSERT_EQ(run.size(), 1u);
  const double chord = kTo.center.norm();
  EXPECT_LT((evaluate(run[0].spine, 0).first - chord * Vec3::UnitX()).norm(), 1e-14);
}

TEST(SplinePipe, of_points_on_a_line_is_straight) {
  const auto run = spline_pipe(kFrom, {{Vec3(3, 0, 0), 1}, {Vec3(11, 0, 0), 2}},
                               {Vec3(12, 0, 0), -Vec3::UnitX(), 1});
  for (const RingedSurface& piece : run) {
    EXPECT_NEAR(regularity(piece).lower, 1, 1e-12);
  }
}

std::vector<Waypoint> circle(int count, double radius) {
  std::vector<Waypoint> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back({Vec3(5 * std::cos(angle), 5 * std::sin(angle), 0), radius});
  }
  return points;
}

TEST(ClosedSplinePipe, is_smooth_at_every_joint) {
  auto points = circle(5, 1);
  points[1].point.z() = 2;
  points[3].radius = 1.4;
  const auto ring = closed_spline_pipe(points);
  ASSERT_EQ(ring.size(), 5u);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    expect_smooth_joint(ring[i], ring[(i + 1) % ring.size()]);
  }
}

TEST(ClosedSplinePipe, converges_to_the_torus_with_order_four) {
  const auto excess = [](int count) {
    double sum = 0;
    for (const RingedSurface& piece : closed_spline_pipe(circle(count, 1))) {
      sum += volume(piece);
    }
    return std::abs(sum / (10 * std::pow(std::numbers::pi, 2)) - 1);
  };
  EXPECT_GT(excess(8) / excess(16), 14);
  EXPECT_LT(excess(16), 1e-3);
}

std::string message_of(const std::vector<Waypoint>& through, const SplinePipeOptions& options = {},
                       const Ring& to = kTo) {
  try {
    (void)spline_pipe(kFrom, through, to, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SplinePipe, says_where_it_is_bent_too_sharply) {
  const std::string message =
      message_of({{Vec3(8, 0, 0), 1}, {Vec3(8, 1, 0), 1}, {Vec3(2, 1, 0), 1}});
  EXPECT_NE(message.find("too sharply between its points"), std::string::npos) << message;
}

// Waves that get steeper: which spans are too sharp for a margin is known of the pipe for a smaller
// one.
TEST(SplinePipe, names_the_first_of_many_spans_that_are_too_sharp) {
  const Ring to{Vec3(120, 0, 0), -Vec3::UnitX(), .4};
  std::vector<Waypoint> through;
  for (int i = 1; i < 240; ++i) {
    const double height = .005 * i * std::min(1., (240 - i) / 60.);
    through.push_back({Vec3(.5 * i, height * std::sin(.4 * i), 0), .4});
  }
  const auto run = spline_pipe(kFrom, through, to, {.margin = .01});
  std::set<std::string> named;
  for (const double margin : {.8, .85, .9}) {
    const auto first = std::ranges::find_if(run, [margin](const RingedSurface& piece) {
      return prove_margin(piece, margin).verdict != Verdict::proved;
    });
    ASSERT_NE(first, run.end());
    const auto i = first - run.begin();
    const std::string points =
        "points " + std::to_string(i) + " and " + std::to_string(i + 1) + ":";
    EXPECT_NE(message_of(through, {.margin = margin}, to).find(points), std::string::npos)
        << points;
    named.insert(points);
  }
  EXPECT_EQ(named.size(), 3u);
}

TEST(SplinePipe, refuses_bad_points_and_ports) {
  EXPECT_NE(message_of({{Vec3(0, 0, 0), 1}}).find("points 0 and 1 of the pipe coincide"),
            std::string::npos);
  EXPECT_NE(message_of({{Vec3(9, 0, 0), 0}}).find("point 1"), std::string::npos);
  EXPECT_THROW((void)closed_spline_pipe(circle(2, 1)), Error);
  EXPECT_THROW((void)spline_pipe({Vec3(0, 0, 0), Vec3::UnitX(), 1, .1}, {}, kTo), Error);
  EXPECT_THROW((void)spline_pipe(kFrom, {}, kTo, {.margin = 1}), Error);
}

}  // namespace
}  // namespace dupin
