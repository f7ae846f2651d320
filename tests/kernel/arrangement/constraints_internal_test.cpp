#include <map>
#include <set>

#include <gtest/gtest.h>

#include "arrangement/points/implicit_predicates.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

class Incidence : public testing::TestWithParam<test::Meeting> {
 protected:
  int side(std::uint32_t triangle, PointId p) const {
    const Triangle& s = stages.input.support(triangle);
    return side_of_plane(stages.input.points, s[0], s[1], s[2], p);
  }
  bool collinear(PointId a, PointId b, PointId c) const {
    const auto area = stages.area_vector({a, b, c});
    return area[0] == 0 && area[1] == 0 && area[2] == 0;
  }

  test::Stages stages{GetParam().solids};
  Constraints constraints = stages.incidences();
};

TEST_P(Incidence, points_lie_on_their_edges_in_order) {
  const PointTable& points = stages.input.points;
  for (std::size_t i = 0; i < constraints.on_edges.size(); ++i) {
    const auto& [edge, point] = constraints.on_edges[i];
    const PointId from = lower_end(edge), to = upper_end(edge);
    EXPECT_TRUE(collinear(from, to, point));
    const bool goes_on = i > 0 && constraints.on_edges[i - 1].edge == edge;
    const PointId before = goes_on ? constraints.on_edges[i - 1].point : from;
    for (int axis = 0; axis < 3; ++axis) {
      const int along = compare(points, to, from, axis);
      EXPECT_EQ(compare(points, point, before, axis), along) << "strictly after the one before";
      EXPECT_EQ(compare(points, to, point, axis), along) << "strictly before the end";
    }
  }
}

TEST_P(Incidence, points_inside_facets_lie_in_their_planes_and_off_their_sides) {
  for (const auto& [triangle, point] : constraints.insides) {
    EXPECT_EQ(side(triangle, point), 0);
    const FlatFacets::Corners t = constraints.facets.corners(stages.input, triangle);
    const Projection projection =
        projection_of(stages.input.points, stages.input.support(triangle));
    for (std::size_t k = 0; k < t.count; ++k) {
      EXPECT_EQ(turn(stages.input.points, t[k], t[t.after(k)], point, projection.axis),
                projection.orientation);
    }
  }
}

TEST_P(Incidence, segments_lie_in_both_planes) {
  for (const Constraints::Segment& s : constraints.segments) {
    for (const PointId end : {s.from, s.to}) {
      EXPECT_EQ(side(s.triangle, end), 0);
      EXPECT_EQ(side(s.partner, end), 0);
    }
    EXPECT_NE(s.from, s.to);
    EXPECT_NE(stages.input.operand_of(s.triangle), stages.input.operand_of(s.partner));
    EXPECT_TRUE(constraints.touched[s.triangle]);
  }
}

TEST_P(Incidence, segments_run_along_the_product_of_the_normals_of_both_in_order) {
  for (const Constraints::Segment& s : constraints.segments) {
    const auto n = stages.area_vector(stages.input.support(std::min(s.triangle, s.partner)));
    const auto m = stages.area_vector(stages.input.support(std::max(s.triangle, s.partner)));
    const auto from = stages.place(s.from), to = stages.place(s.to);
    mpq_class along = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      along += (to[k] - from[k]) * (n[i] * m[j] - n[j] * m[i]);
    }
    EXPECT_GT(along, 0);
  }
}

TEST_P(Incidence, points_have_one_name_per_place) {
  std::set<PointId> used;
  for (const auto& [edge, point] : constraints.on_edges) {
    used.insert(point);
  }
  for (const auto& [triangle, point] : constraints.insides) {
    used.insert(point);
  }
  for (const Triangle& t : stages.input.triangles) {
    used.insert(t.begin(), t.end());
  }
  std::set<std::array<std::string, 3>> places;
  for (const PointId id : used) {
    const auto p = stages.place(id);
    EXPECT_TRUE(places.insert({p[0].get_str(), p[1].get_str(), p[2].get_str()}).second);
  }
}

TEST_P(Incidence, faces_hold_every_touched_triangle_once) {
  std::vector<int> seen(stages.input.triangles.size(), 0);
  for (std::size_t i = 0; i < constraints.face_count(); ++i) {
    const std::span<const std::uint32_t> face = constraints.face(i);
    EXPECT_TRUE(std::is_sorted(face.begin(), face.end()));
    for (const std::uint32_t t : face) {
      ++seen[t];
      for (const PointId corner : stages.input.triangles[face[0]]) {
        EXPECT_EQ(face.size() > 1 ? side(t, corner) : 0, 0) << "members lie in one plane";
      }
    }
  }
  for (std::uint32_t t = 0; t < seen.size(); ++t) {
    EXPECT_EQ(seen[constraints.facets.of(t)], constraints.touched[t]);
  }
}

INSTANTIATE_TEST_SUITE_P(Meetings, Incidence, testing::ValuesIn(test::meetings()),
                         test::meeting_name);

TEST(Incidences, of_a_corner_in_a_corner_close_to_a_hexagon) {
  test::Stages s({test::cube(0, 0, 0), test::cube(1, 1, 1)});
  const Constraints constraints = s.incidences();
  // Each segment is handed to both of its triangles; the curve passes every point in and out.
  std::map<PointId, int> ends;
  for (const Constraints::Segment& segment : constraints.segments) {
    ++ends[segment.from];
    ++ends[segment.to];
  }
  std::size_t corners = 0;
  for (const auto& [point, count] : ends) {
    EXPECT_EQ(count % 4, 0);
    const auto p = s.place(point);
    corners += std::all_of(p.begin(), p.end(), [](const mpq_class& x) { return x == 1 || x == 2; })
                   ? 1
                   : 0;
  }
  EXPECT_EQ(corners, 6);
  EXPECT_EQ(constraints.on_edge(edge_key(kNone - 1, kNone)).size(), 0);
}

}  // namespace
}  // namespace dupin::arrangement
