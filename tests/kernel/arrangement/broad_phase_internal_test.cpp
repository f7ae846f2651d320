#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "kernel/arrangement/stages_internal.h"
#include "support/message_of.h"
#include "support/pipe_cases.h"

namespace dupin::arrangement {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Triangle_3 triangle(const ArrangementInput& input, std::uint32_t t) {
  const auto point = [&input](PointId id) {
    const Vec3& p = input.points.coordinates(id);
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  const Triangle& corners = input.triangles[t];
  return {point(corners[0]), point(corners[1]), point(corners[2])};
}

// Turns by an angle whose sine and cosine are no doubles, so that all coordinates are rounded.
TriMesh turned(TriMesh mesh, double angle, const Vec3& axis) {
  for (Vec3& p : mesh.points) {
    p = Eigen::AngleAxisd(angle, axis.normalized()) * p;
  }
  return mesh;
}

std::vector<test::Meeting> turned_meetings() {
  std::vector<test::Meeting> result = test::meetings();
  for (double angle = 0.1; angle < 3; angle += 0.7) {
    result.push_back({"turned tubes",
                      {turned(test::tube(1, -4, 4, 24), angle, {1, 2, 3}),
                       turned(test::tube(0.5, -4, 4, 16), 2 * angle, {3, -1, angle}),
                       test::tube(0.25, -6, 6, 8)}});
  }
  return result;
}

TEST(Candidates, hold_every_pair_of_triangles_that_meets) {
  for (const auto& [name, solids] : turned_meetings()) {
    SCOPED_TRACE(name);
    const test::Stages s(solids);
    const std::vector<TrianglePair> candidates = s.candidates();
    const auto count = static_cast<std::uint32_t>(s.input.triangles.size());
    std::vector<TrianglePair> meeting;
    {
      const CGAL::Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
      for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t j = i + 1; j < count; ++j) {
          if (s.input.operand_of(i) != s.input.operand_of(j) && !s.input.merged[i] &&
              !s.input.merged[j] &&
              CGAL::do_intersect(triangle(s.input, i), triangle(s.input, j))) {
            meeting.push_back({i, j});
          }
        }
      }
    }
    std::vector<TrianglePair> sorted = candidates;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end()) << "each once";
    EXPECT_TRUE(std::includes(sorted.begin(), sorted.end(), meeting.begin(), meeting.end()));
  }
}

TEST(Candidates, leave_merged_triangles_out) {
  const test::Stages s({test::cube(0, 0, 0), test::cube(0, 0, 0)});
  for (const auto& [first, second] : s.candidates()) {
    EXPECT_FALSE(s.input.merged[first] || s.input.merged[second]);
  }
}

TEST(Candidates, are_few_where_slanted_tubes_cross) {
  const test::Stages s({turned(test::tube(1, -40, 40, 256), 0.7, {1, 2, 3}),
                        turned(test::tube(1, -40, 40, 256), 2.1, {3, -1, 1})});
  const std::size_t all = 1020 * 1020;
  EXPECT_LT(s.candidates().size(), all / 8);
}

// And says how much would do, of whatever number of threads.
TEST(Candidates, are_no_more_than_memory_holds) {
  const std::vector<Solid> pipes = test::solids_of(test::pipe_case("star_general_10"));
  const std::vector<const mesh::ExactMesh*> operands = test::operands_of(pipes);
  const UpwardRounding rounding;
  const ArrangementInput input = load_operands(operands, union_rule(operands.size()));
  const Progress silent;
  const support::ProgressStage stage(silent, "test", 0, 1);
  const std::vector<TrianglePair> all = broad_phase(input, stage);
  const std::string message =
      test::message_of([&] { (void)broad_phase(input, stage, all.size() * 15); });
  EXPECT_NE(message.find(" " + std::to_string(all.size()) + " pairs overlap, would need about "),
            std::string::npos)
      << message;
  const std::size_t at = message.find("about ") + 6;
  const double megabytes = std::stod(message.substr(at));
  EXPECT_EQ(broad_phase(input, stage, static_cast<std::uint64_t>(megabytes * 1e6) + 1), all);
}

// Two unions of pipes through one point: thousands of long triangles in all directions, whose boxes
// overlap many others, so that they are looked at in slices.
TEST(Candidates, hold_all_that_meets_where_long_triangles_are_looked_at_in_slices) {
  const std::vector<Solid> pipes = test::solids_of(test::pipe_case("star_general_20"));
  const std::vector<Solid> halves = {unite(std::span(pipes).first(10)),
                                     unite(std::span(pipes).subspan(10))};
  const std::vector<const mesh::ExactMesh*> operands = test::operands_of(halves);
  const UpwardRounding rounding;
  const ArrangementInput input = load_operands(operands, union_rule(2));
  const Progress silent;
  const std::vector<TrianglePair> candidates =
      broad_phase(input, support::ProgressStage(silent, "test", 0, 1));
  EXPECT_TRUE(std::is_sorted(candidates.begin(), candidates.end()));
  EXPECT_EQ(std::adjacent_find(candidates.begin(), candidates.end()), candidates.end());
  std::size_t meeting = 0;
  std::vector<TriangleIntersection> found;
  for (std::uint32_t i = 0; i < input.first_triangle[1]; i += 20) {
    for (std::uint32_t j = input.first_triangle[1]; j < input.first_triangle[2]; ++j) {
      found.clear();
      intersect(input, i, j, found);
      if (!found.empty()) {
        ++meeting;
        EXPECT_TRUE(std::binary_search(candidates.begin(), candidates.end(), TrianglePair{i, j}));
      }
    }
  }
  EXPECT_GT(meeting, 100U);
}

// A fan about the apex and one about the middle of the base.
TriMesh cone(const Vec3& apex, const Vec3& axis, std::uint32_t sides) {
  TriMesh mesh{{apex, apex + axis}, {}, {}, {}};
  const Vec3 u = axis.unitOrthogonal(), v = axis.normalized().cross(u);
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    mesh.points.emplace_back(apex + axis + std::cos(angle) * u + std::sin(angle) * v);
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % sides;
    mesh.triangles.push_back({0, b, a});
    mesh.triangles.push_back({1, a, b});
  }
  return mesh;
}

// Nearly all share corners with many others, and many lie in one plane.
TriMesh random_fans(std::uint32_t seed) {
  std::mt19937 random(seed);
  TriMesh mesh;
  while (mesh.points.size() < 40) {
    mesh.points.emplace_back(random() % 5, random() % 5, random() % 3);
  }
  while (mesh.triangles.size() < 300) {
    const Triangle t = {static_cast<std::uint32_t>(random() % 4),
                        static_cast<std::uint32_t>(random() % 40),
                        static_cast<std::uint32_t>(random() % 40)};
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    if (!(b - a).cross(c - a).isZero(0)) {
      mesh.triangles.push_back(t);
    }
  }
  return mesh;
}

mesh::ExactMesh surface_of(const TriMesh& mesh) {
  mesh::ExactMesh surface;
  surface.points = mesh.points;
  surface.triangles = mesh.triangles;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    surface.sources.push_back({0, i});
  }
  return surface;
}

// The number of pairs of one surface.
std::size_t expect_all_within(const TriMesh& mesh) {
  const mesh::ExactMesh surface = surface_of(mesh);
  const mesh::ExactMesh* const operand = &surface;
  const UpwardRounding rounding;
  const ArrangementInput input = load_operands({&operand, 1}, union_rule(1), {{0, 0}});
  const Progress silent;
  const std::vector<TrianglePair> candidates =
      broad_phase(input, support::ProgressStage(silent, "test", 0, 1));
  EXPECT_TRUE(std::is_sorted(candidates.begin(), candidates.end()));
  EXPECT_EQ(std::adjacent_find(candidates.begin(), candidates.end()), candidates.end());
  std::vector<TriangleIntersection> found;
  std::size_t meeting = 0;
  for (std::uint32_t i = 0; i < input.triangles.size(); ++i) {
    for (std::uint32_t j = i + 1; j < input.triangles.size(); ++j) {
      found.clear();
      if (!input.merged[i] && !input.merged[j]) {
        intersect(input, i, j, found);
      }
      if (!found.empty()) {
        ++meeting;
        EXPECT_TRUE(std::binary_search(candidates.begin(), candidates.end(), TrianglePair{i, j}));
      }
    }
  }
  EXPECT_GT(meeting, 100U);
  return candidates.size();
}

TEST(Candidates, of_one_surface_hold_all_that_meets_in_more_than_a_corner) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    expect_all_within(random_fans(seed));
  }
  const TriMesh cones =
      test::joined({cone({0, 0, 0}, {3, 2, 1}, 400), cone({0.5, 0.2, 1}, {3, 1.5, -1}, 400)});
  EXPECT_LT(expect_all_within(cones), cones.triangles.size() * cones.triangles.size() / 20);
}

TEST(Candidates, come_in_the_same_order_every_time) {
  const std::vector<TriMesh> solids{test::tube(1, -3, 3, 40), test::cube(0, 0, 0),
                                    test::tube(0.5, -4, 4, 30)};
  const std::vector<TrianglePair> first = test::Stages(solids).candidates();
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(test::Stages(solids).candidates(), first);
}

}  // namespace
}  // namespace dupin::arrangement
