#include "dupin/blends/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dupin/io/assembly_json.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

using std::numbers::pi;

Drawing drawing(const Assembly& assembly, const View& view, bool hidden = false,
                const BuildOptions& build_options = {}) {
  return draw(assembly, build(assembly, build_options), {view, hidden});
}

Assembly parts(const std::string& text) {
  return parse_assembly(R"({"units": "mm", "tolerance": 0.01, "parts": [)" + text + "]}", "test");
}

Assembly example(const std::string& name) {
  return read_assembly(test::source_folder() / "examples" / (name + ".json"));
}

double length(const DrawnLine& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    sum += (line.points[i] - line.points[i - 1]).norm();
  }
  return sum;
}

// The lengths of a part's lines, ascending.
std::vector<double> lengths(const Drawing& drawing, const std::string& part, LineKind kind,
                            bool hidden = false) {
  std::vector<double> result;
  for (const DrawnLine& line : drawing.lines) {
    if (line.part == part && line.kind == kind && line.hidden == hidden) {
      result.push_back(length(line));
    }
  }
  std::ranges::sort(result);
  return result;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& wanted,
                 double tolerance) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], wanted[i], tolerance);
  }
}

const View kPlan = view_along(-Vec3::UnitZ());

TEST(Drawing, of_a_pipe_before_another_one) {
  const Assembly assembly = parts(
      R"({"name": "front", "pipe": {"from": [-50, 0, 0], "to": [50, 0, 0], "radius": 10}},
         {"name": "back", "pipe": {"from": [0, -50, -50], "to": [0, 50, -50], "radius": 5}})");
  const Drawing all = drawing(assembly, kPlan, true);
  EXPECT_EQ(all.unit, Unit::millimetre);
  EXPECT_GT(all.error, 0);
  EXPECT_LE(all.error, 0.01);
  expect_near(lengths(all, "front", LineKind::contour), {100, 100}, 1e-9);
  expect_near(lengths(all, "back", LineKind::contour), {40, 40, 40, 40}, 0.01);
  expect_near(lengths(all, "back", LineKind::contour, true), {20, 20}, 0.02);
  // Rims seen from the side: their upper halves.
  for (const std::string part : {"front", "back"}) {
    double rims = 0;
    for (const DrawnLine& line : all.lines) {
      if (line.kind == LineKind::edge && !line.hidden && line.part.starts_with(part)) {
        rims += length(line);
      }
    }
    EXPECT_NEAR(rims, part == "front" ? 40 : 20, 0.1);
  }
  for (const DrawnLine& line : drawing(assembly, kPlan).lines) {
    EXPECT_FALSE(line.hidden);
  }
}

// What lies in another part is no line at all, and smooth joints are none.
TEST(Drawing, of_a_branch_ends_on_its_run) {
  const Assembly assembly = parts(
      R"({"name": "run", "pipe": {"from": [-50, 0, 0], "to": [50, 0, 0], "radius": 10}},
         {"name": "branch", "pipe": {"from": [0, 0, 0], "to": [0, 40, 0], "radius": 6}},
         {"name": "bend", "elbow": {"from": "branch.end", "bend_radius": 15, "angle": 90,
          "toward": [1, 0, 0]}})");
  const Drawing all = drawing(assembly, kPlan, true);
  // From the wall of the run, at y = sqrt(100 - z^2) with z = 0, to the end.
  expect_near(lengths(all, "branch", LineKind::contour), {30, 30}, 0.05);
  EXPECT_TRUE(lengths(all, "branch", LineKind::contour, true).empty());
  expect_near(lengths(all, "bend", LineKind::contour), {9 * pi / 2, 21 * pi / 2}, 0.05);
  // One line in which both meet, half of it seen, no line at the bend.
  double seen = 0, hidden = 0;
  for (const DrawnLine& line : all.lines) {
    if (line.kind == LineKind::edge && std::abs(line.points[0][0]) < 7 && line.points[0][1] < 12) {
      (line.hidden ? hidden : seen) += length(line);
      for (const Eigen::Vector2d& point : line.points) {
        EXPECT_NEAR(point[1], std::sqrt(100 - 36 + point[0] * point[0]), 0.05);
      }
    }
  }
  EXPECT_NEAR(seen, hidden, 0.1);
  EXPECT_GT(seen, 12);
}

TEST(Drawing, of_a_wall_shows_the_bore_through_its_end) {
  Assembly assembly =
      parts(R"({"name": "pipe", "pipe": {"from": [0, 0, 0], "to": [0, 0, 50], "radius": 10}})");
  assembly.wall = 2;
  const Drawing plan = drawing(assembly, kPlan);
  std::vector<double> circles;
  for (const DrawnLine& line : plan.lines) {
    EXPECT_EQ(line.kind, LineKind::edge);  // contours are none along the axis
    circles.push_back(length(line));
  }
  std::ranges::sort(circles);
  ASSERT_GE(circles.size(), 2);
  EXPECT_NEAR(circles[circles.size() - 1], 20 * pi, 0.1);
  EXPECT_NEAR(circles[circles.size() - 2], 16 * pi, 0.1);
  const Drawing slanted = drawing(assembly, view_along({0, 1, -1}));
  EXPECT_TRUE(lengths(slanted, "pipe.bore", LineKind::contour).empty());  // behind the metal
  const Drawing fluid = drawing(assembly, view_along({0, 1, 0}), false, {.region = Region::fluid});
  expect_near(lengths(fluid, "pipe.bore", LineKind::contour), {50, 50}, 0.1);
}

// The pipe lies within it, and is seen as a hole through its end.
TEST(Drawing, of_insulation_shows_both_its_sides) {
  Assembly assembly =
      parts(R"({"name": "pipe", "pipe": {"from": [0, 0, 0], "to": [0, 0, 50], "radius": 10}})");
  assembly.insulation = 2;
  const BuildOptions options{.region = Region::insulation};
  std::vector<double> circles;
  for (const DrawnLine& line : drawing(assembly, kPlan, false, options).lines) {
    circles.push_back(length(line));
  }
  std::ranges::sort(circles);
  ASSERT_GE(circles.size(), 2);
  EXPECT_NEAR(circles[circles.size() - 1], 24 * pi, 0.1);
  EXPECT_NEAR(circles[circles.size() - 2], 20 * pi, 0.1);
  const Drawing front = drawing(assembly, view_along({0, 1, 0}), false, options);
  expect_near(lengths(front, "pipe.insulation", LineKind::contour), {50, 50}, 0.1);
  EXPECT_TRUE(lengths(front, "pipe", LineKind::contour).empty());
  ASSERT_EQ(front.parts.size(), 1);
  EXPECT_NEAR(front.parts[0].diameters[0], 24, 1e-9);
}

// The chain's own wall, which the document does not state.
TEST(Drawing, of_a_hollow_chain_shows_its_bore) {
  const Drawing metal =
      drawing(example("jet-engine"), view_along({-1, 1, -1}), true, {.region = Region::metal});
  EXPECT_TRUE(std::ranges::any_of(metal.lines, [](const DrawnLine& line) {
    return line.part.ends_with(".bore") && line.kind == LineKind::contour;
  }));
}

// In a document without walls, too: the inner skin's contour is seen through the open end.
TEST(Drawing, of_a_hollow_chain_in_no_region_shows_its_inner_contour) {
  const auto chain = [](const std::string& wall) {
    return parts(R"({"name": "k", "cyclide_chain": {"spheres": [[0, 0, 0, 1], [2, 1, 0, 0.8],
        [4, 0, 0, 1], [6, 1, 0, 0.7], [8, 0, 0, 0.9]])" +
                 wall + "}}");
  };
  const View view = view_along({1, 0, 0});
  const auto hollow = lengths(drawing(chain(R"(, "wall": 0.2)"), view), "k", LineKind::contour),
             full = lengths(drawing(chain(""), view), "k", LineKind::contour);
  EXPECT_GT(hollow.size(), full.size());
}

// The axis is all but seen from its end: no rims are added to what is traced.
TEST(Drawing, of_a_pipe_along_its_axis_but_for_rounding_has_no_scraps) {
  for (const double tilt : {1e-13, 1e-11, 1e-10, 1e-8}) {
    const Drawing pipe = drawing(
        parts(R"({"name": "pipe", "pipe": {"from": [0, 0, 0], "to": [50, 0, 0], "radius": 10}})"),
        view_along({1, tilt, 0}));
    EXPECT_LE(pipe.lines.size(), 4U) << tilt;
  }
}

void expect_as_wide(const Drawing& drawing, const Built& built) {
  Eigen::AlignedBox2d of_lines, of_points;
  for (const DrawnLine& line : drawing.lines) {
    for (const Eigen::Vector2d& point : line.points) {
      of_lines.extend(point);
    }
  }
  for (const Vec3& point : built.solid.nearest_points()) {
    of_points.extend(Eigen::Vector2d(drawing.view(point).head<2>()));
  }
  const double allowed = 4 * drawing.error;
  EXPECT_LT((of_lines.min() - of_points.min()).cwiseAbs().maxCoeff(), allowed);
  EXPECT_LT((of_lines.max() - of_points.max()).cwiseAbs().maxCoeff(), allowed);
}

// Where blends, heads and fillets end in pipes that are seen along their axes, nothing but the rim
// bounds the picture.
TEST(Drawing, of_the_examples_along_their_axes_is_as_wide_as_they_are) {
  for (const char* name : {"coplanar", "cyclide-blends", "reducing-elbow", "skew-pipes", "vessel",
                           "straight-reducer", "straight-reducer-r2", "way-points", "tee",
                           "hollow-tee", "junction", "two-cones", "plant-run"}) {
    const Assembly assembly = example(name);
    const Built built = build(assembly);
    for (int i = 0; i < 3; ++i) {
      for (const double sign : {-1., 1.}) {
        SCOPED_TRACE(testing::Message() << name << ' ' << sign << ' ' << i);
        expect_as_wide(draw(assembly, built, {view_along(sign * Vec3::Unit(i))}), built);
      }
    }
  }
}

// The lines' bounds are those of the solid's points.
TEST(Drawing, of_the_examples_is_as_wide_as_they_are) {
  for (const char* name : {"tee", "equal-tee", "header", "junction", "skew-cross", "crane-hook",
                           "hollow-tee", "ucct-arm", "two-cones", "cope"}) {
    const Assembly assembly = example(name);
    const Built built = build(assembly);
    for (const Vec3& direction : {Vec3(-1, 1, -1), Vec3(0.3, -0.2, 0.9)}) {
      SCOPED_TRACE(name);
      expect_as_wide(draw(assembly, built, {view_along(direction)}), built);
    }
  }
}

TEST(Drawing, is_the_same_whatever_else_runs) {
  const Assembly assembly = example("header");
  const View view = view_along({-1, 1, -1});
  const Drawing first = drawing(assembly, view, true), second = drawing(assembly, view, true);
  ASSERT_EQ(first.lines.size(), second.lines.size());
  for (std::size_t i = 0; i < first.lines.size(); ++i) {
    EXPECT_EQ(first.lines[i].points, second.lines[i].points);
  }
}

}  // namespace
}  // namespace dupin
