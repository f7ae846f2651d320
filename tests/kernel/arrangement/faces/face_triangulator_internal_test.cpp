#include <gtest/gtest.h>

#include "arrangement/faces/face_triangulator.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

using Vector = std::array<mpq_class, 3>;

// Faces one by one, before their new points are numbered.
class FaceTriangulatorOf : public testing::TestWithParam<test::Meeting> {
 protected:
  [[nodiscard]] Vector at(PointId id, const FaceSubdivision& faces) const {
    const mesh::ExactPoint p =
        id < ConstrainedTriangulation::kNewPoint
            ? stages.input.points.exact_value(id)
            : evaluate_exact(stages.input.points,
                             faces.new_points[id - ConstrainedTriangulation::kNewPoint].definition);
    const mpq_class w = exact::rational(p[3]);
    return {exact::rational(p[0]) / w, exact::rational(p[1]) / w, exact::rational(p[2]) / w};
  }
  [[nodiscard]] Vector area(const Triangle& corners, const FaceSubdivision& faces) const {
    const Vector a = at(corners[0], faces), b = at(corners[1], faces), c = at(corners[2], faces);
    Vector result;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      result[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    }
    return result;
  }
  // Of the sub-triangles and outlines from those on, each as often as what covers it counts.
  [[nodiscard]] Vector covered_area(const FaceSubdivision& faces, std::size_t first,
                                    std::size_t first_outline) const {
    const auto& local = faces.local;
    std::vector<Subdivision::SubTriangle> triangles(
        local.triangles.begin() + static_cast<std::ptrdiff_t>(first), local.triangles.end());
    OutlineTriangulator triangulator(stages.input);
    for (std::size_t i = first_outline; i < local.outlines.size(); ++i) {
      triangulator.append(local, local.outlines[i], triangles);
    }
    Vector sum;
    for (const Subdivision::SubTriangle& triangle : triangles) {
      const Vector part = area(triangle.corners, faces);
      for (const SignedTriangle& t : faces.local.cover(triangle.region)) {
        for (std::size_t k = 0; k < 3; ++k) {
          sum[k] += t.sign * part[k];
        }
      }
    }
    return sum;
  }

  test::Stages stages{GetParam().solids};
  Constraints constraints = stages.incidences();
};

// One group: regions that cancel are left out, and count for nothing in the sum either.
TEST_P(FaceTriangulatorOf, members_covers_as_much_as_they_do) {
  FaceTriangulator triangulator(stages.input, stages.rule, constraints);
  FaceSubdivision faces;
  for (std::size_t f = 0; f < constraints.face_count(); ++f) {
    const std::size_t first = faces.local.triangles.size();
    const std::size_t first_outline = faces.local.outlines.size();
    triangulator.append(constraints.face(f), faces);
    Vector expected;
    std::vector<std::uint32_t> triangles;
    for (const std::uint32_t t : constraints.face(f)) {
      triangles.push_back(t);
      if (const std::uint32_t mate = constraints.facets.mate(t); mate != kNone) {
        triangles.push_back(mate);
      }
    }
    for (const std::uint32_t t : triangles) {
      for (const SignedTriangle& same : stages.input.cover(t)) {
        const Vector part = area(stages.input.triangles[t], faces);
        for (std::size_t k = 0; k < 3; ++k) {
          expected[k] += same.sign * part[k];
        }
      }
    }
    EXPECT_EQ(covered_area(faces, first, first_outline), expected) << f;
  }
}

TEST_P(FaceTriangulatorOf, members_is_the_same_after_any_other_face) {
  FaceTriangulator one(stages.input, stages.rule, constraints);
  FaceSubdivision all;
  for (std::size_t f = 0; f < constraints.face_count(); ++f) {
    FaceTriangulator fresh(stages.input, stages.rule, constraints);
    FaceSubdivision alone;
    fresh.append(constraints.face(f), alone);
    const std::size_t first = all.local.triangles.size();
    const std::size_t first_corner = all.local.outline_corners.size();
    one.append(constraints.face(f), all);
    ASSERT_EQ(all.local.triangles.size() - first, alone.local.triangles.size());
    for (std::size_t i = 0; i < alone.local.triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(at(all.local.triangles[first + i].corners[k], all),
                  at(alone.local.triangles[i].corners[k], alone));
      }
      EXPECT_EQ(all.local.triangles[first + i].open, alone.local.triangles[i].open);
    }
    ASSERT_EQ(all.local.outline_corners.size() - first_corner, alone.local.outline_corners.size());
    for (std::size_t i = 0; i < alone.local.outline_corners.size(); ++i) {
      const Subdivision::OutlineCorner& corner = all.local.outline_corners[first_corner + i];
      EXPECT_EQ(corner.point, alone.local.outline_corners[i].point);
      EXPECT_EQ(corner.apex, alone.local.outline_corners[i].apex);
      EXPECT_EQ(corner.sides, alone.local.outline_corners[i].sides);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meetings, FaceTriangulatorOf, testing::ValuesIn(test::meetings()),
                         test::meeting_name);

}  // namespace
}  // namespace dupin::arrangement
