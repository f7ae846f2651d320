#include <map>
#include <random>
#include <set>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "arrangement/faces/constrained_triangulation.h"
#include "dupin/kernel/error.h"
#include "exact/exact_numbers.h"

namespace dupin::arrangement {
namespace {

using Planar = std::array<mpq_class, 2>;
using Vertex = ConstrainedTriangulation::Vertex;

mpq_class turn_of(const Planar& a, const Planar& b, const Planar& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Whether c lies on the segment from a to b.
bool is_on(const Planar& a, const Planar& b, const Planar& c) {
  const auto between = [&](std::size_t k) {
    return std::min(a[k], b[k]) <= c[k] && c[k] <= std::max(a[k], b[k]);
  };
  return turn_of(a, b, c) == 0 && between(0) && between(1);
}

// Points of a grid in a large triangle of the plane z = 0, and segments between them.
class Plane {
 public:
  Plane() : triangulation_(points_, {crossing(), both()}) {
    frame_ = {points_.add(Vec3(-20, -20, 0)), points_.add(Vec3(60, -20, 0)),
              points_.add(Vec3(-20, 60, 0))};
  }
  Plane(const Plane&) = delete;
  Plane& operator=(const Plane&) = delete;

  // In a square of side 9. With `lines`, vertices know on which segments they end.
  void fill(std::mt19937& random, std::size_t count, std::size_t segments, bool lines = false) {
    const std::uint32_t grid = count < 40 ? 9 : 36;
    std::set<std::array<std::uint32_t, 2>> taken;
    while (taken.size() < count) {
      taken.insert({static_cast<std::uint32_t>(random() % grid),
                    static_cast<std::uint32_t>(random() % grid)});
    }
    std::vector<PointId> ids;
    for (const auto& [x, y] : taken) {
      ids.push_back(points_.add(Vec3(x, y, 0) * (9.0 / grid)));
    }
    std::shuffle(ids.begin(), ids.end(), random);
    std::vector<std::array<std::size_t, 2>> ends;
    std::vector<ConstrainedTriangulation::Lines> known(ids.size(), 0);
    while (ends.size() < segments) {
      const std::size_t i = random() % ids.size(), k = random() % ids.size();
      if (i != k) {
        const auto line = ConstrainedTriangulation::Lines{lines ? 1U : 0U} << ends.size();
        known[i] |= line;
        known[k] |= line;
        ends.push_back({i, k});
      }
    }
    start();
    std::vector<Vertex> vertices;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      vertices.push_back(triangulation_.add(ids[i], known[i]));
      triangulation_.insert(vertices.back());
    }
    for (const auto& [i, k] : ends) {
      const auto slot = static_cast<std::uint32_t>(lines_.size());
      lines_.push_back({{ids[i], ids[k]}, {static_cast<std::uint32_t>(segments_.size())}});
      segments_.push_back(lines_.back().ends);
      triangulation_.constrain(vertices[i], vertices[k], slot);
    }
    triangulation_.improve(frame_);
  }

  // One after the other, on two lines side by side.
  void insert_two_rows(std::size_t count) {
    std::vector<PointId> ids;
    for (std::size_t i = 0; i < count; ++i) {
      ids.push_back(points_.add(Vec3(static_cast<double>(i) / 64, i % 2 == 0 ? 0 : 1, 0)));
    }
    start();
    for (const PointId id : ids) {
      triangulation_.insert(triangulation_.add(id));
    }
  }

  [[nodiscard]] Planar at(Vertex v) {
    const PointId id = triangulation_.point(v);
    const mesh::ExactPoint p =
        (id & ConstrainedTriangulation::kNewPoint) != 0
            ? evaluate_exact(
                  points_,
                  triangulation_.new_points()[id - ConstrainedTriangulation::kNewPoint].definition)
            : points_.exact_value(id);
    const mpq_class w = exact::rational(p[3]);
    return {exact::rational(p[0]) / w, exact::rational(p[1]) / w};
  }
  [[nodiscard]] const std::vector<ConstrainedTriangulation::Face>& faces() const {
    return triangulation_.faces();
  }
  [[nodiscard]] std::size_t segments() const { return segments_.size(); }
  [[nodiscard]] std::array<Planar, 2> segment(std::size_t i) const {
    return {planar(segments_[i][0]), planar(segments_[i][1])};
  }
  // The segments that a slot stands for.
  [[nodiscard]] const std::vector<std::uint32_t>& members(std::uint32_t slot) const {
    return lines_[slot].members;
  }

 private:
  struct Line {
    std::array<PointId, 2> ends;
    std::vector<std::uint32_t> members;
  };
  void start() {
    triangulation_.clear({2, 1});
    std::array<Vertex, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = triangulation_.add(frame_[static_cast<int>(i)]);
    }
    triangulation_.start(corners[0], corners[1], corners[2]);
  }
  [[nodiscard]] Planar planar(PointId id) const {
    return {mpq_class(points_.coordinates(id).x()), mpq_class(points_.coordinates(id).y())};
  }
  std::function<ImplicitPoint(std::uint32_t, std::uint32_t)> crossing() {
    return [this](std::uint32_t a, std::uint32_t b) {
      const auto &s = lines_[a].ends, &t = lines_[b].ends;
      return ImplicitPoint{ImplicitPoint::Kind::two_lines, 2, {s[0], s[1], t[0], t[1]}};
    };
  }
  std::function<std::uint32_t(std::uint32_t, std::uint32_t)> both() {
    return [this](std::uint32_t present, std::uint32_t added) {
      Line line = lines_[present];
      line.members.insert(line.members.end(), lines_[added].members.begin(),
                          lines_[added].members.end());
      lines_.push_back(std::move(line));
      return static_cast<std::uint32_t>(lines_.size() - 1);
    };
  }

  UpwardRounding rounding_;
  PointTable points_;
  std::vector<std::array<PointId, 2>> segments_;
  std::vector<Line> lines_;  // by slot
  ConstrainedTriangulation triangulation_;
  Triangle frame_{};
};

// Few, or so many that they are kept nearly Delaunay from the start.
std::size_t count_for(unsigned seed) { return seed < 60 ? 3 + seed % 30 : 250 + 30 * (seed - 60); }

class ConstrainedTriangulationOf : public testing::TestWithParam<unsigned> {
 protected:
  ConstrainedTriangulationOf() {
    std::mt19937 random(GetParam());
    plane.fill(random, count_for(GetParam()), GetParam() % 13);
  }
  Plane plane;
};

TEST_P(ConstrainedTriangulationOf, points_covers_the_triangle_once) {
  mpq_class sum = 0;
  for (const auto& face : plane.faces()) {
    const mpq_class area =
        turn_of(plane.at(face.corners[0]), plane.at(face.corners[1]), plane.at(face.corners[2]));
    EXPECT_GT(area, 0);
    sum += area;
  }
  EXPECT_EQ(sum, 80 * 80);
}

TEST_P(ConstrainedTriangulationOf, points_knows_what_lies_across_each_edge) {
  const auto& faces = plane.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t g = faces[f].neighbours[k];
      const Vertex from = faces[f].corners[(k + 1) % 3], to = faces[f].corners[(k + 2) % 3];
      if (g == kNone) {
        EXPECT_LT(std::max(from, to), 3U) << "an edge of the frame";
        continue;
      }
      std::size_t back = 0;
      while (back < 3 && faces[g].neighbours[back] != f) {
        ++back;
      }
      ASSERT_LT(back, 3U);
      EXPECT_EQ(faces[g].corners[(back + 1) % 3], to);
      EXPECT_EQ(faces[g].corners[(back + 2) % 3], from);
      EXPECT_EQ(faces[g].slots[back], faces[f].slots[k]);
    }
  }
}

// Edges with a slot lie on the segments it stands for, and leave no part of any segment out.
TEST_P(ConstrainedTriangulationOf, points_has_its_segments_for_edges) {
  std::vector<mpq_class> covered(plane.segments());
  for (const auto& face : plane.faces()) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (face.slots[k] == kNone) {
        continue;
      }
      const Planar from = plane.at(face.corners[(k + 1) % 3]),
                   to = plane.at(face.corners[(k + 2) % 3]);
      const auto& listed = plane.members(face.slots[k]);
      for (const std::uint32_t s : std::set(listed.begin(), listed.end())) {
        const auto [a, b] = plane.segment(s);
        EXPECT_TRUE(is_on(a, b, from) && is_on(a, b, to));
        // As a part of the whole, seen along x or y.
        const std::size_t axis = a[0] != b[0] ? 0 : 1;
        covered[s] += abs(to[axis] - from[axis]) / abs(b[axis] - a[axis]);
      }
    }
  }
  for (const mpq_class& twice : covered) {
    EXPECT_EQ(twice, 2) << "on both sides";
  }
}

TEST_P(ConstrainedTriangulationOf, points_is_the_same_with_lines_known_before) {
  std::mt19937 random(GetParam());
  Plane other;
  other.fill(random, count_for(GetParam()), GetParam() % 13, true);
  ASSERT_EQ(other.faces().size(), plane.faces().size());
  for (std::size_t f = 0; f < plane.faces().size(); ++f) {
    EXPECT_EQ(other.faces()[f].corners, plane.faces()[f].corners);
    EXPECT_EQ(other.faces()[f].slots, plane.faces()[f].slots);
  }
}

INSTANTIATE_TEST_SUITE_P(Random, ConstrainedTriangulationOf, testing::Range(0U, 68U));

// The way to the next vertex would be as long as a fan is wide: inserted as they come, one corner
// of the frame had the faces of all vertices.
TEST(ConstrainedTriangulation, has_no_fans_between_many_vertices) {
  constexpr std::size_t kCount = 1000;
  Plane plane;
  plane.insert_two_rows(kCount);
  std::vector<std::size_t> degree(kCount + 3);
  std::size_t between = 0;
  for (const auto& face : plane.faces()) {
    for (const Vertex v : face.corners) {
      ++degree[v];
    }
    between += std::ranges::all_of(face.corners, [](Vertex v) { return v >= 3; }) ? 1 : 0;
  }
  EXPECT_EQ(between, kCount - 2);
  EXPECT_LE(*std::max_element(degree.begin() + 3, degree.end()), 8U);
}

// Three points of a line that no doubles hold, and one off it.
TEST(ConstrainedTriangulation, learns_lines_from_vertices_that_are_in_line_only) {
  const UpwardRounding rounding;
  PointTable points;
  const PointId from = points.add(Vec3(0, 0, 0)), to = points.add(Vec3(3, 0, 0));
  const PointId off = points.add(Vec3(1, 5, 0));
  std::vector<PointId> on;
  for (const double x : {0.3, 0.7, 1.1}) {
    on.push_back(points.add(Vec3(x, 1, 0)));
  }
  std::vector<PointId> crossings;
  for (const PointId id : on) {
    crossings.push_back(
        points.add(ImplicitPoint{ImplicitPoint::Kind::two_lines, 2, {from, to, off, id}}));
  }
  ConstrainedTriangulation plane(points, {});
  plane.clear({2, 1});
  const Vertex a = plane.add(crossings[0], 1), b = plane.add(off), c = plane.add(crossings[1], 1),
               d = plane.add(crossings[2]);
  EXPECT_EQ(plane.turn(a, b, a), 0);
  EXPECT_EQ(plane.turn(a, b, c), -1) << "a point and itself say nothing of a third one";
  EXPECT_EQ(plane.turn(a, c, d), 0);
  EXPECT_EQ(plane.turn(a, c, b), 1);
  EXPECT_EQ(plane.turn(a, d, c), 0);
}

TEST(ConstrainedTriangulation, of_points_without_segments_is_nearly_delaunay) {
  std::mt19937 random(99);
  Plane plane;
  plane.fill(random, 40, 0);
  int legal = 0, illegal = 0;
  for (const auto& face : plane.faces()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t g = face.neighbours[k];
      if (g == kNone) {
        continue;
      }
      std::array<Planar, 4> p;
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = plane.at(face.corners[i]);
      }
      for (const Vertex v : plane.faces()[g].corners) {
        if (std::find(face.corners.begin(), face.corners.end(), v) == face.corners.end()) {
          p[3] = plane.at(v);
        }
      }
      std::array<std::array<mpq_class, 3>, 3> m;
      for (std::size_t i = 0; i < 3; ++i) {
        m[i] = {p[i][0] - p[3][0], p[i][1] - p[3][1], 0};
        m[i][2] = m[i][0] * m[i][0] + m[i][1] * m[i][1];
      }
      const mpq_class in_circle = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                                  m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                  m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
      ++(in_circle > 0 ? illegal : legal);
    }
  }
  EXPECT_GT(legal, 200);
  EXPECT_EQ(illegal, 0);
}

// What no caller does who has no bug: the loops end nevertheless, and say where.
TEST(ConstrainedTriangulation, broken_rules_are_internal_errors_with_their_place) {
  PointTable points;
  const std::array<PointId, 3> corners{points.add(Vec3(0, 0, 0)), points.add(Vec3(8, 0, 0)),
                                       points.add(Vec3(0, 8, 0))};
  const PointId inside = points.add(Vec3(1, 2, 0)), same = points.add(Vec3(1, 2, 0)),
                outside = points.add(Vec3(7, 6, 0));
  const auto message = [&](PointId second, bool is_constrained) -> std::string {
    const UpwardRounding rounding;
    ConstrainedTriangulation triangulation(
        points, {[](auto, auto) { return ImplicitPoint(); }, [](auto a, auto) { return a; }});
    triangulation.clear({2, 1});
    std::array<Vertex, 3> frame{};
    for (std::size_t i = 0; i < 3; ++i) {
      frame[i] = triangulation.add(corners[i]);
    }
    triangulation.start(frame[0], frame[1], frame[2]);
    const Vertex first = triangulation.add(inside), last = triangulation.add(second);
    triangulation.insert(first);
    try {
      if (is_constrained) {
        triangulation.constrain(first, last, 0);
      } else {
        triangulation.insert(last);
      }
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::internal);
      return error.message();
    }
    return {};
  };
  const std::string start = "internal error, please report it: ";
  EXPECT_EQ(message(outside, false),
            start + "a vertex lies outside in the triangulation at (7, 6, 0)");
  EXPECT_EQ(message(same, false),
            start + "two vertices coincide in the triangulation at (1, 2, 0)");
  EXPECT_EQ(message(outside, true),
            start + "an end of a constraint is missing in the triangulation at (7, 6, 0)");
}

}  // namespace
}  // namespace dupin::arrangement
