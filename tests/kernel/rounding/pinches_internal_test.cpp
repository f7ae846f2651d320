#include <tuple>

#include "kernel/rounding/edits/edit_fixture_internal.h"
#include "rounding/pinches.h"

namespace dupin::rounding {
namespace {

struct Pinches : Edit {
  Pinches() : Edit(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1))), moved(shape.points.size(), 0) {
    std::tie(first, second, third) =
        std::tuple(shape.triangles[0][0], shape.triangles[0][1], shape.triangles[0][2]);
  }
  /// With the first corner at the place of the second one.
  [[nodiscard]] std::vector<Vec3> places() {
    shape.points[first] = shape.points[second];
    EditedMesh edited = mesh();
    edited.find_faults(std::vector<std::uint8_t>(shape.triangles.size(), 1));
    EXPECT_FALSE(edited.faults().empty());
    return pinched_places(edited, representatives, moved);
  }

  std::vector<std::uint8_t> moved;
  std::uint32_t first = 0, second = 0, third = 0;
};

TEST_F(Pinches, are_where_a_copy_has_moved_to_a_neighbour) {
  representatives[first] = third;
  moved[first] = 1;
  EXPECT_EQ(places(), std::vector<Vec3>{shape.points[second]});
}

TEST_F(Pinches, are_where_what_has_a_copy_has_moved_to_a_neighbour) {
  representatives[third] = first;
  moved[first] = 1;
  EXPECT_EQ(places(), std::vector<Vec3>{shape.points[second]});
}

TEST_F(Pinches, have_copies) {
  moved[first] = 1;
  EXPECT_TRUE(places().empty());
}

TEST_F(Pinches, have_moved) {
  representatives[first] = third;
  EXPECT_TRUE(places().empty());
}

// Two triangles on three places, of one of which there are copies.
TEST_F(Pinches, are_corners_of_two_triangles_in_one_place) {
  shape = {{Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(0, 9, 0), Vec3(0, 0, 0)}, {{0, 1, 2}, {3, 2, 1}}};
  labels.assign(2, 0);
  representatives = {0, 1, 2, 0};
  moved = {1, 1, 1, 1};
  const std::vector<std::uint8_t> all(2, 1);
  EditedMesh twice(shape.points, shape.triangles, labels, representatives);
  twice.find_faults(all);
  EXPECT_EQ(pinched_places(twice, representatives, moved), std::vector<Vec3>{shape.points[0]});
  shape.points[2] = Vec3(1, 1, 5);  // no longer
  shape.points.emplace_back(2, 2, -5);
  shape.triangles[1] = {3, 4, 1};
  representatives.push_back(4);
  moved.push_back(1);
  EditedMesh once(shape.points, shape.triangles, labels, representatives);
  once.find_faults(all);
  EXPECT_TRUE(pinched_places(once, representatives, moved).empty());
}

TEST_F(Pinches, are_closed_by_the_nearest_corner) {
  const std::vector<Vec3> places{shape.points[first]};
  std::vector<Fault> faults;
  TriMesh surface = shape;
  EXPECT_EQ(close_pinches(places, .5, surface, faults), 0) << "all corners are further away";
  EXPECT_EQ(surface.points, shape.points);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(close_pinches(places, 1, surface, faults), 1);
  EXPECT_NE(surface.points[first], shape.points[first]);
  EXPECT_EQ((surface.points[first] - shape.points[first]).norm(), 1);
  EXPECT_FALSE(faults.empty()) << "faces without area";
}

TEST_F(Pinches, are_not_closed_by_each_other) {
  std::vector<Vec3> all(shape.points.begin(), shape.points.end());
  std::vector<Fault> faults;
  TriMesh surface = shape;
  EXPECT_EQ(close_pinches(all, 9, surface, faults), 0);
}

}  // namespace
}  // namespace dupin::rounding
