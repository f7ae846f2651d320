#include <random>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

using Corners = std::array<Vec3, 3>;
using Kind = TriangleIntersection::Kind;

// Two triangles; points of the same coordinates are one, as after import.
ArrangementInput input_of(const Corners& first, const Corners& second) {
  ArrangementInput input;
  std::vector<Vec3> points;
  for (const Corners& corners : {first, second}) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      auto at = std::find(points.begin(), points.end(), corners[k]);
      if (at == points.end()) {
        input.points.add(corners[k]);
        at = points.insert(at, corners[k]);
      }
      triangle[k] = static_cast<PointId>(at - points.begin());
    }
    input.triangles.push_back(triangle);
  }
  return input;
}

std::vector<TriangleIntersection> met(const Corners& first, const Corners& second) {
  const ArrangementInput input = input_of(first, second);
  const UpwardRounding rounding;
  std::vector<TriangleIntersection> result;
  intersect(input, 0, 1, result);
  return result;
}

constexpr Feature kEdge0 = edge_feature(0), kEdge1 = edge_feature(1), kEdge2 = edge_feature(2);

// The first triangle is always this one, in the plane z = 0.
const Corners kFlat{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};

struct Crossing {
  const char* description;
  Corners second;
  Kind kind;
  // The ends in either order.
  Feature from_first, from_second, to_first, to_second;
};

const Crossing kCrossings[] = {
    {"from edge to edge",
     {Vec3{1, 1, -1}, Vec3{1, -3, 1}, Vec3{1, 7, 1}},
     Kind::segment,
     kEdge0,
     kInside,
     kEdge1,
     kInside},
    {"an edge of each through the other",
     {Vec3{1, 1, -1}, Vec3{1, -3, 1}, Vec3{1, 2, 1}},
     Kind::segment,
     kEdge0,
     kInside,
     kInside,
     kEdge2},
    {"a corner through the inside",
     {Vec3{1, 1, -1}, Vec3{1, 1, 1}, Vec3{2, 1, 1}},
     Kind::segment,
     kInside,
     kEdge0,
     kInside,
     kEdge2},
    {"a corner on the inside",
     {Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{2, 1, 1}},
     Kind::point,
     kInside,
     0,
     kInside,
     0},
    {"an edge on the inside",
     {Vec3{1, 1, 0}, Vec3{2, 1, 0}, Vec3{1, 1, 1}},
     Kind::segment,
     kInside,
     0,
     kInside,
     1},
    {"a corner on an edge",
     {Vec3{5, 5, 1}, Vec3{2, 0, 0}, Vec3{5, 4, 1}},
     Kind::point,
     kEdge0,
     1,
     kEdge0,
     1},
    {"an edge through an edge",
     {Vec3{2, -1, -1}, Vec3{2, 1, 1}, Vec3{2, -5, 1}},
     Kind::point,
     kEdge0,
     kEdge0,
     kEdge0,
     kEdge0},
    {"an edge through a corner",
     {Vec3{0, 0, -1}, Vec3{0, 0, 1}, Vec3{-1, -1, 0}},
     Kind::point,
     0,
     kEdge0,
     0,
     kEdge0},
    {"part of an edge on an edge",
     {Vec3{1, 0, 0}, Vec3{3, 0, 0}, Vec3{2, 0, 5}},
     Kind::segment,
     kEdge0,
     0,
     kEdge0,
     1},
    {"edges that overlap",
     {Vec3{1, 0, 0}, Vec3{6, 0, 0}, Vec3{2, 0, 5}},
     Kind::segment,
     kEdge0,
     0,
     1,
     kEdge0},
    {"from a corner to the edge facing it",
     {Vec3{0, 0, 0}, Vec3{3, 3, 0}, Vec3{1, 1, 5}},
     Kind::segment,
     0,
     0,
     kEdge1,
     kEdge0},
};

TEST(TrianglePair, names_where_triangles_meet) {
  for (const Crossing& c : kCrossings) {
    SCOPED_TRACE(c.description);
    const std::vector<TriangleIntersection> found = met(kFlat, c.second);
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0].kind, c.kind);
    EXPECT_FALSE(found[0].coplanar);
    using Ends = std::set<std::pair<Feature, Feature>>;
    Ends ends;
    for (const TriangleIntersection::End& end : found[0].ends) {
      ends.emplace(end.on_first, end.on_second);
    }
    EXPECT_EQ(ends, (Ends{{c.from_first, c.from_second}, {c.to_first, c.to_second}}));
  }
}

TEST(TrianglePair, says_nothing_of_what_the_mesh_says_already) {
  const struct {
    const char* description;
    Corners second;
  } table[] = {
      {"a common corner", {Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 1}}},
      {"a common edge", {Vec3{4, 0, 0}, Vec3{0, 0, 0}, Vec3{0, 0, 1}}},
      {"a common edge in one plane", {Vec3{4, 0, 0}, Vec3{0, 0, 0}, Vec3{0, -1, 0}}},
      {"apart in one plane", {Vec3{5, 0, 0}, Vec3{6, 0, 0}, Vec3{5, 1, 0}}},
      {"above", {Vec3{0, 0, 1}, Vec3{4, 0, 1}, Vec3{0, 4, 2}}},
      {"beside", {Vec3{3, 3, -1}, Vec3{3, 3, 1}, Vec3{4, 4, 0}}},
      {"one step above", {Vec3{1, 1, 0x1p-1074}, Vec3{4, 0, 1}, Vec3{0, 4, 2}}},
  };
  for (const auto& row : table) {
    EXPECT_TRUE(met(kFlat, row.second).empty()) << row.description;
    EXPECT_TRUE(met(row.second, kFlat).empty()) << row.description << ", exchanged";
  }
}

TEST(TrianglePair, tells_overlap_in_a_plane_from_contact) {
  const struct {
    const char* description;
    Corners second;
    std::size_t points;
    bool overlap;
  } table[] = {
      {"a star of six", {Vec3{3, 3, 0}, Vec3{-1, 3, 0}, Vec3{3, -1, 0}}, 6, true},
      {"inside", {Vec3{1, 1, 0}, Vec3{2, 1, 0}, Vec3{1, 2, 0}}, 3, true},
      {"the same turned over", {Vec3{0, 0, 0}, Vec3{0, 4, 0}, Vec3{4, 0, 0}}, 0, true},
      {"corner on edge", {Vec3{2, 0, 0}, Vec3{1, -1, 0}, Vec3{3, -1, 0}}, 1, false},
      {"edge on edge", {Vec3{1, 0, 0}, Vec3{2, -1, 0}, Vec3{3, 0, 0}}, 2, false},
      {"edge beyond edge", {Vec3{-1, 0, 0}, Vec3{2, -1, 0}, Vec3{3, 0, 0}}, 2, false},
  };
  for (const auto& row : table) {
    SCOPED_TRACE(row.description);
    const std::vector<TriangleIntersection> found = met(kFlat, row.second);
    std::size_t points = 0, overlaps = 0;
    for (const TriangleIntersection& e : found) {
      EXPECT_TRUE(e.coplanar);
      points += e.kind == Kind::point ? 1 : 0;
      overlaps += e.kind == Kind::overlap ? 1 : 0;
    }
    EXPECT_EQ(points, row.points);
    EXPECT_EQ(overlaps, row.overlap ? 1 : 0);
  }
}

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

Exact::Triangle_3 exact_triangle(const Corners& t) {
  const auto point = [](const Vec3& p) { return Exact::Point_3(p.x(), p.y(), p.z()); };
  return {point(t[0]), point(t[1]), point(t[2])};
}

// -1 apart, else the dimension of what the triangles have in common.
int common_dimension(const Corners& a, const Corners& b) {
  const auto common = CGAL::intersection(exact_triangle(a), exact_triangle(b));
  if (!common) {
    return -1;
  }
  return boost::get<Exact::Point_3>(&*common) != nullptr     ? 0
         : boost::get<Exact::Segment_3>(&*common) != nullptr ? 1
                                                             : 2;
}

int dimension(const std::vector<TriangleIntersection>& intersections) {
  int result = -1;
  for (const TriangleIntersection& e : intersections) {
    result = std::max(result, e.kind == Kind::point ? 0 : e.kind == Kind::segment ? 1 : 2);
  }
  return result;
}

TEST(TrianglePair, finds_what_exact_constructions_find_on_a_coarse_grid) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(0, 3);
  const auto corners = [&] {
    Corners c;
    do {
      for (Vec3& p : c) {
        p = Vec3(coordinate(random), coordinate(random), coordinate(random) / 2);
      }
    } while ((c[1] - c[0]).cross(c[2] - c[0]).isZero(0));
    return c;
  };
  std::array<std::size_t, 4> seen{};
  for (int round = 0; round < 6000; ++round) {
    const Corners a = corners(), b = corners();
    const std::size_t shared = static_cast<std::size_t>(std::count_if(
        a.begin(), a.end(), [&b](const Vec3& p) { return std::count(b.begin(), b.end(), p) > 0; }));
    const int expected = common_dimension(a, b), found = dimension(met(a, b));
    ++seen[static_cast<std::size_t>(expected + 1)];
    // Collinear contact of coplanar triangles comes as its end points; common corners not at all.
    const bool coplanar = met(a, b).empty() ? false : met(a, b)[0].coplanar;
    if (shared == 0 && !(coplanar && expected == 1)) {
      EXPECT_EQ(found, expected) << round;
    } else {
      EXPECT_LE(found, expected) << round;
      EXPECT_EQ(found == 2, expected == 2) << round;
    }
    EXPECT_EQ(dimension(met(b, a)), found) << round;
  }
  for (const std::size_t count : seen) {
    EXPECT_GT(count, 50) << "all dimensions occur";
  }
}

}  // namespace
}  // namespace dupin::arrangement
