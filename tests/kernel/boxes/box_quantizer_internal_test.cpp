#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "boxes/box_quantizer.h"
#include "boxes/main_directions.h"
#include "checking/self_intersection.h"
#include "predicates/triangle_overlap.h"
#include "support/pipe_cases.h"
#include "support/shapes.h"

namespace dupin::boxes {
namespace {

FramedTriangle mapped(const BoxQuantizer& frame, std::span<const Vec3> points, const Triangle& t) {
  return frame.map(points[t[0]], points[t[1]], points[t[2]]);
}

/// Half the surface of the boxes around the triangles, in all.
double box_surface(const BoxQuantizer& frame, const TriMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Box box = frame.around(mapped(frame, mesh.points, t));
    const double x = box.high[0] - box.low[0], y = box.high[1] - box.low[1],
                 z = box.high[2] - box.low[2];
    sum += x * y + y * z + z * x;
  }
  return sum;
}

/// Of all the operands.
TriMesh soup(const std::string& name) { return test::joined(test::pipe_case(name)); }

TEST(MainDirections, are_none_of_upright_pipes) {
  for (const char* name : {"tee_10k", "rack_small"}) {
    const TriMesh mesh = soup(name);
    EXPECT_FALSE(main_directions(mesh.points, mesh.triangles)) << name;
  }
}

TEST(MainDirections, of_turned_pipes_are_those_of_the_turn) {
  for (const char* name : {"tee_10k", "header_10", "rack_small"}) {
    const TriMesh mesh = soup(name), turned = soup(std::string(name) + "_rot");
    const auto axes = main_directions(turned.points, turned.triangles);
    ASSERT_TRUE(axes) << name;
    EXPECT_TRUE((*axes * axes->transpose()).isIdentity(1e-12)) << name;
    const double upright = box_surface(BoxQuantizer(mesh.points), mesh);
    const BoxQuantizer frame(turned.points, turned.triangles);
    // A turned frame has half the scale, hence a quarter of the surface. Slanted edges turn the
    // directions a little, each in its way.
    EXPECT_LT(4 * box_surface(frame, turned), 1.5 * upright) << name;
    EXPECT_GT(box_surface(BoxQuantizer(turned.points), turned), 2 * upright) << name;
  }
}

TEST(MainDirections, are_none_where_numbers_fail) {
  TriMesh mesh = soup("tee_10k_rot");
  const auto scaled = [&](double factor) {
    std::vector<Vec3> points = mesh.points;
    for (Vec3& point : points) {
      point *= factor;
    }
    return points;
  };
  EXPECT_TRUE(main_directions(scaled(0x1p100), mesh.triangles));
  EXPECT_FALSE(main_directions(scaled(0), mesh.triangles));
  EXPECT_FALSE(main_directions(scaled(1e300), mesh.triangles));
  EXPECT_FALSE(main_directions(scaled(1e-300), mesh.triangles));
  EXPECT_FALSE(main_directions({}, {}));
}

/// All pairs that meet otherwise than neighbours do and of which one is active.
std::vector<checking::FacePair> compared(const TriMesh& mesh,
                                         std::span<const std::uint8_t> active) {
  std::vector<checking::FacePair> found;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const predicates::TriangleOverlapTest probe(mesh.points, mesh.triangles[f]);
    for (std::uint32_t g = f + 1; g < mesh.triangles.size(); ++g) {
      const predicates::TriangleOverlap meeting = probe.meeting(mesh.triangles[g]);
      if ((active[f] != 0 || active[g] != 0) && meeting != predicates::TriangleOverlap::none) {
        using Kind = checking::FacePair::Kind;
        found.push_back(
            {f, g,
             meeting == predicates::TriangleOverlap::overlap ? Kind::overlap : Kind::crossing});
      }
    }
  }
  return found;
}

TEST(SelfIntersection, of_turned_pipes_is_found_in_turned_boxes) {
  std::mt19937 random(20261122);
  std::size_t pairs = 0;
  for (const char* name : {"tee_n128_rot", "steinmetz_rot", "tangent_perp_rot"}) {
    const TriMesh mesh = soup(name);
    ASSERT_TRUE(main_directions(mesh.points, mesh.triangles)) << name;
    std::vector<std::uint32_t> apart(mesh.points.size());  // points that coincide are not the same
    std::iota(apart.begin(), apart.end(), 0U);
    for (const unsigned share : {100U, 60U, 30U, 10U}) {  // of active triangles, per cent
      std::vector<std::uint8_t> active(mesh.triangles.size());
      for (std::uint8_t& is_active : active) {
        is_active = random() % 100 < share ? 1 : 0;
      }
      const auto found =
          checking::find_self_intersections(mesh.points, mesh.triangles,
                                            {.active = active, .representatives = apart})
              .pairs;
      EXPECT_TRUE(found == compared(mesh, active)) << name << " " << share;
      pairs += found.size();
    }
  }
  EXPECT_GT(pairs, 1000);
}

class TurnedFrame : public testing::Test {
 protected:
  TriMesh mesh_ = soup("tee_10k_rot");
  BoxQuantizer frame_{mesh_.points, mesh_.triangles};
  std::mt19937 random_{5};

  Vec3 any(double reach) {
    std::uniform_real_distribution<double> coordinate(-reach, reach);
    return {coordinate(random_), coordinate(random_), coordinate(random_)};
  }
};

TEST_F(TurnedFrame, maps_to_less_than_one) {
  for (const FramedPoint& point : frame_.map(mesh_.points)) {
    ASSERT_LT(point.cwiseAbs().maxCoeff(), 1);
  }
}

TEST_F(TurnedFrame, has_boxes_that_overlap_where_triangles_meet) {
  int meeting = 0;
  for (int round = 0; round < 20000; ++round) {
    const Vec3 a = any(1), b = any(1);
    // Half of the pairs touch in one point only.
    const std::vector<Vec3> points = {a, a + any(1), a + any(1e-3),
                                      b, b + any(1), round % 2 == 0 ? a : Vec3(b + any(1))};
    if (round % 2 != 0 && predicates::TriangleOverlapTest(points, {0, 1, 2}).meeting({3, 4, 5}) ==
                              predicates::TriangleOverlap::none) {
      continue;
    }
    ++meeting;
    ASSERT_TRUE(frame_.around(mapped(frame_, points, {0, 1, 2}))
                    .overlaps(frame_.around(mapped(frame_, points, {3, 4, 5}))));
  }
  EXPECT_GT(meeting, 10100);
}

TEST_F(TurnedFrame, has_wider_boxes_around_what_may_move) {
  for (const double margin : {0.0, 1e-9, 1e-6, 1e-2}) {
    for (int round = 0; round < 1000; ++round) {
      std::vector<Vec3> points = {any(1), any(1), any(1)};
      const Box wide = frame_.around(mapped(frame_, points, {0, 1, 2}), margin);
      for (Vec3& point : points) {
        point += any(1).normalized() * margin;
      }
      ASSERT_TRUE(wide.contains(frame_.around(mapped(frame_, points, {0, 1, 2}))));
    }
  }
}

TEST(BoxQuantizer, has_boxes_about_boxes_along_any_axes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random));
  };
  const TriMesh turned = soup("rack_small_rot");
  ASSERT_TRUE(main_directions(turned.points, turned.triangles));
  for (const BoxQuantizer& frame :
       {BoxQuantizer(turned.points), BoxQuantizer(turned.points, turned.triangles)}) {
    for (int i = 0; i < 100; ++i) {
      Eigen::AlignedBox3d box(point());
      box.extend(point());
      const Box around = frame.around(box);
      for (int k = 0; k < 20; ++k) {
        const FramedPoint inside = frame.map(box.sample());
        EXPECT_TRUE(around.contains(frame.around(FramedTriangle{inside, inside, inside})));
      }
    }
  }
}

}  // namespace
}  // namespace dupin::boxes
