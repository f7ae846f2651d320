#include <map>

#include <gtest/gtest.h>

#include "arrangement/faces/constrained_triangulation.h"
#include "arrangement/intersection_points.h"
#include "kernel/arrangement/stages_internal.h"
#include "support/disjoint_sets.h"

namespace dupin::arrangement {
namespace {

// Each operand in a group of its own: nothing cancels.
BooleanRule separate_rule(std::size_t operands) {
  BooleanRule rule = union_rule(operands);
  rule.groups = static_cast<std::uint32_t>(operands);
  for (std::uint32_t o = 0; o < operands; ++o) {
    rule.group_of_operand[o] = o;
  }
  return rule;
}

using Vector = std::array<mpq_class, 3>;

void add(Vector& sum, const Vector& summand, int sign) {
  for (std::size_t k = 0; k < 3; ++k) {
    sum[k] += sign * summand[k];
  }
}

class Face : public testing::TestWithParam<test::Meeting> {
 protected:
  test::Stages stages{GetParam().solids, separate_rule(GetParam().solids.size())};
  Constraints constraints = stages.incidences();
  Subdivision subdivision = stages.triangulated(stages.subdivision(constraints));
};

// The facets that are one sheet where others overlap them count for the first of them.
support::DisjointSets sheets_of(const ArrangementInput& input, const Constraints& constraints) {
  support::DisjointSets sheets(input.triangles.size());
  for (const Triangle& corners : input.triangles) {
    for (Feature f = 3; f < kInside; ++f) {
      if (const TrianglePair* sides = constraints.sheets.at(edge_of(corners, f))) {
        sheets.unite(constraints.facets.of(sides->first), constraints.facets.of(sides->second));
      }
    }
  }
  return sheets;
}

TEST_P(Face, pieces_add_up_to_each_facet) {
  std::vector<Vector> sums(stages.input.triangles.size()), areas(sums.size());
  support::DisjointSets sheets = sheets_of(stages.input, constraints);
  for (const Subdivision::SubTriangle& triangle : subdivision.triangles) {
    const Vector area = stages.area_vector(triangle.corners);
    for (const SignedTriangle& t : subdivision.cover(triangle.region)) {
      add(sums[t.triangle], area, t.sign);
    }
  }
  for (std::uint32_t t = 0; t < sums.size(); ++t) {
    if (constraints.touched[t] && !stages.input.merged[t]) {
      add(areas[sheets.find(constraints.facets.of(t))],
          stages.area_vector(stages.input.triangles[t]), 1);
    }
  }
  for (std::uint32_t t = 0; t < sums.size(); ++t) {
    if (constraints.touched[t] && !stages.input.merged[t]) {
      EXPECT_EQ(sums[t], areas[t]) << t;
    }
  }
}

TEST_P(Face, pieces_are_proper_and_turned_like_their_support) {
  for (const Subdivision::SubTriangle& triangle : subdivision.triangles) {
    const Vector area = stages.area_vector(triangle.corners);
    const Vector whole =
        stages.area_vector(stages.input.support(subdivision.regions[triangle.region].support));
    EXPECT_GT(area[0] * whole[0] + area[1] * whole[1] + area[2] * whole[2], 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3;
      EXPECT_EQ(area[k] * whole[i], area[i] * whole[k]) << "parallel";
    }
  }
}

// An edge of a piece within its region has the same edge, run backwards, on its other side.
TEST_P(Face, edges_within_a_region_have_two_sides) {
  std::map<std::array<PointId, 3>, int> sides;
  for (const Subdivision::SubTriangle& triangle : subdivision.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((triangle.open >> k & 1u) == 0) {
        const PointId from = triangle.corners[(k + 1) % 3], to = triangle.corners[(k + 2) % 3];
        sides[{triangle.region, std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
      }
    }
  }
  for (const auto& [edge, balance] : sides) {
    EXPECT_EQ(balance, 0);
  }
}

TEST_P(Face, segments_are_edges_of_pieces) {
  std::map<std::array<PointId, 2>, int> edges;
  for (const Subdivision::SubTriangle& triangle : subdivision.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId from = triangle.corners[(k + 1) % 3], to = triangle.corners[(k + 2) % 3];
      ++edges[{std::min(from, to), std::max(from, to)}];
    }
  }
  for (const Constraints::Segment& s : constraints.segments) {
    // Where nothing else lies on it, the segment is one edge.
    bool is_cut = false;
    for (const auto& [triangle, point] : constraints.insides) {
      const Vector area = stages.area_vector({s.from, s.to, point});
      is_cut = is_cut || (point != s.from && point != s.to && area == Vector{});
    }
    if (!is_cut && constraints.segments_of(s.triangle).size() == 1) {
      EXPECT_EQ(edges.count({std::min(s.from, s.to), std::max(s.from, s.to)}), 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meetings, Face, testing::ValuesIn(test::meetings()), test::meeting_name);

// A square grid of constraints across a triangle, in the plane z = 0.
class Constraints : public testing::Test {
 protected:
  Constraints() {
    const PointId a = points.add(Vec3(0, 0, 0)), b = points.add(Vec3(16, 0, 0)),
                  c = points.add(Vec3(0, 16, 0));
    for (const double k : {1.0, 2.0, 3.0}) {
      ends.push_back({points.add(Vec3(k, 0, 0)), points.add(Vec3(k, 9, 0))});
      ends.push_back({points.add(Vec3(0, k, 0)), points.add(Vec3(9, k, 0))});
    }
    triangulation.clear({2, 1});
    triangulation.start(triangulation.add(a), triangulation.add(b), triangulation.add(c));
    for (const auto& [from, to] : ends) {
      vertices.push_back({triangulation.add(from), triangulation.add(to)});
      triangulation.insert(vertices.back()[0]);
      triangulation.insert(vertices.back()[1]);
    }
    for (std::uint32_t slot = 0; slot < ends.size(); ++slot) {
      triangulation.constrain(vertices[slot][0], vertices[slot][1], slot);
    }
  }
  ImplicitPoint crossing(std::uint32_t i, std::uint32_t j) const {
    return {ImplicitPoint::Kind::two_lines, 2, {ends[i][0], ends[i][1], ends[j][0], ends[j][1]}};
  }

  UpwardRounding rounding;
  PointTable points;
  std::vector<std::array<PointId, 2>> ends;
  std::vector<std::array<ConstrainedTriangulation::Vertex, 2>> vertices;
  ConstrainedTriangulation triangulation{
      points,
      {[this](auto i, auto j) { return crossing(i, j); },
       [](std::uint32_t present, std::uint32_t) { return present; }}};
};

TEST_F(Constraints, make_a_vertex_where_they_cross) {
  EXPECT_EQ(triangulation.new_points().size(), 9);
  std::map<std::uint32_t, int> constrained;
  for (const ConstrainedTriangulation::Face& face : triangulation.faces()) {
    for (const std::uint32_t slot : face.slots) {
      if (slot != kNone) {
        ++constrained[slot];
      }
    }
  }
  for (std::uint32_t slot = 0; slot < ends.size(); ++slot) {
    EXPECT_EQ(constrained[slot], 2 * 4) << "four parts, each with two sides";
  }
}

TEST_F(Constraints, leave_a_triangulation) {
  const auto& faces = triangulation.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t n = faces[f].neighbours[k];
      if (n != kNone) {
        const auto& back = faces[n].neighbours;
        EXPECT_EQ(std::count(back.begin(), back.end(), f), 1);
      }
    }
  }
  // 3 corners, 6 points on sides, 6 inside, 9 crossings; Euler: F = 2 V - 2 - boundary.
  const std::size_t boundary = 3 + 6;
  EXPECT_EQ(faces.size(), 2 * (3 + 6 + 6 + 9) - 2 - boundary);
}

}  // namespace
}  // namespace dupin::arrangement
