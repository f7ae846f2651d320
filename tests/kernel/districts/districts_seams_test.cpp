#include <algorithm>

#include <gtest/gtest.h>

#include "dupin/kernel/districts.h"

namespace dupin::test {
namespace {

using Box = Eigen::AlignedBox3d;

// A bar of square section along x, whose ends are labelled; either diagonal divides them.
TriMesh bar(double from, double to, const std::string& start, const std::string& end,
            bool is_start_turned = false) {
  TriMesh mesh;
  for (const double x : {from, to}) {
    for (const Vec3& corner : {Vec3(x, 0, 0), Vec3(x, 1, 0), Vec3(x, 1, 1), Vec3(x, 0, 1)}) {
      mesh.points.push_back(corner);
    }
  }
  mesh.names = {"side", start, end};
  const auto add = [&](Triangle triangle, std::uint32_t label) {
    mesh.triangles.push_back(triangle);
    mesh.labels.push_back(label);
  };
  if (is_start_turned) {
    add({0, 3, 1}, 1);
    add({1, 3, 2}, 1);
  } else {
    add({0, 2, 1}, 1);
    add({0, 3, 2}, 1);
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    add({i, j, j + 4}, 0);
    add({i, j + 4, i + 4}, 0);
  }
  add({4, 5, 6}, 2);
  add({4, 6, 7}, 2);
  return mesh;
}

Seam seam(const std::string& name, double x) {
  return {{0, 1}, name, Box(Vec3(x - .1, -1, -1), Vec3(x + .1, 2, 2))};
}

OpenPiece opened(const TriMesh& mesh, std::vector<Seam> seams) {
  const Report report = check(mesh);
  EXPECT_TRUE(report.is_solid());
  return dupin::opened(mesh, Vec3::Zero(), report, seams);
}

void append(const Report& from, Report& to) {
  to.points += from.points;
  to.triangles += from.triangles;
  to.area += from.area;
  to.volume += from.volume;
  to.euler_number += from.euler_number;
  to.shells.insert(to.shells.end(), from.shells.begin(), from.shells.end());
}

TEST(Seams, join_pieces_that_fit) {
  const OpenPiece one = opened(bar(0, 1, "a", "s"), {seam("s", 1)}),
                  other = opened(bar(1, 3, "s", "b"), {seam("s", 1)});
  EXPECT_EQ(one.disc_faces, (std::vector<std::uint32_t>{10, 11}));
  EXPECT_EQ(other.disc_faces, (std::vector<std::uint32_t>{0, 1}));
  ASSERT_EQ(one.sides.size(), 1);
  EXPECT_TRUE(one.sides[0].is_disc);
  EXPECT_EQ(border_size(one.sides[0]), 4);
  EXPECT_EQ(one.sides[0].near.size(), 8 * 3);
  EXPECT_EQ(other.report.shells.at(0).first_face, 0);
  EXPECT_TRUE(fit(one.sides[0], other.sides[0]));
  EXPECT_TRUE(fit(other.sides[0], one.sides[0]));
  Report all = one.report;
  append(other.report, all);
  join_shells(std::vector<ShellPair>{{{0, 1}, 4}}, all);
  EXPECT_EQ(all.points, 12);
  EXPECT_EQ(all.triangles, 20);
  EXPECT_EQ(all.euler_number, 2);
  EXPECT_EQ(all.components, 1);
  EXPECT_EQ(all.genus, 0);
  EXPECT_DOUBLE_EQ(all.area, 14);
  ASSERT_EQ(all.shells.size(), 1);
  EXPECT_EQ(all.shells[0].triangles, 20);
  EXPECT_EQ(all.shells[0].euler_number, 2);
  EXPECT_DOUBLE_EQ(all.shells[0].volume, 3);
}

// Two bars that meet at both ends, as far as reports tell, make a ring.
TEST(Seams, a_ring_has_a_hole) {
  const std::vector<Seam> seams{seam("s", 1), seam("t", 0)};
  Report all = opened(bar(0, 1, "t", "s"), seams).report;
  append(all, all);
  join_shells(std::vector<ShellPair>{{{0, 1}, 4}, {{0, 1}, 4}}, all);
  EXPECT_EQ(all.components, 1);
  EXPECT_EQ(all.euler_number, 0);
  EXPECT_EQ(all.genus, 1);
  EXPECT_EQ(all.points, 8);
}

TEST(Seams, the_first_face_of_a_shell_is_one_that_is_left) {
  const OpenPiece piece = opened(bar(1, 2, "s", "b"), {seam("s", 1)});
  ASSERT_EQ(piece.report.shells.size(), 1);
  EXPECT_EQ(piece.report.shells[0].first_face, 0);
  EXPECT_EQ(piece.report.shells[0].triangles, 10);
  EXPECT_EQ(piece.report.points, 8);
}

TEST(Seams, do_not_fit_where_discs_differ) {
  const SeamSide one = opened(bar(0, 1, "a", "s"), {seam("s", 1)}).sides.at(0);
  EXPECT_FALSE(fit(one, opened(bar(1, 3, "s", "b", true), {seam("s", 1)}).sides.at(0)))
      << "other triangles";
  EXPECT_FALSE(fit(one, opened(bar(1.5, 3, "s", "b"), {seam("s", 1.5)}).sides.at(0)))
      << "another place";
  EXPECT_FALSE(fit(one, one)) << "the same side";
  EXPECT_FALSE(fit(one, opened(bar(1, 3, "c", "b"), {seam("s", 1)}).sides.at(0))) << "no disc";
  EXPECT_FALSE(fit(one, SeamSide{}));
  EXPECT_FALSE(fit(SeamSide{}, SeamSide{}));
}

TEST(Seams, a_disc_is_one_and_has_one_border) {
  EXPECT_FALSE(opened(bar(0, 1, "s", "s"), {seam("s", 1)}).sides.at(0).is_disc) << "two of them";
  TriMesh mesh = bar(0, 1, "a", "s");
  mesh.labels[1] = 2;
  EXPECT_FALSE(opened(mesh, {seam("s", 1)}).sides.at(0).is_disc) << "one and a corner";
}

TEST(Seams, do_not_fit_where_triangles_beside_them_meet) {
  const SeamSide one = opened(bar(0, 1, "a", "s"), {seam("s", 1)}).sides.at(0);
  const SeamSide other = opened(bar(1, 3, "s", "b"), {seam("s", 1)}).sides.at(0);
  const auto with = [&](std::vector<Vec3> triangle) {
    SeamSide result = other;
    result.near.insert(result.near.end(), triangle.begin(), triangle.end());
    return result;
  };
  EXPECT_TRUE(fit(one, with({{1.2, 3, 0}, {1.3, 3, 0}, {1.2, 3, 1}})));
  EXPECT_FALSE(fit(one, with({{.5, .5, .5}, {.6, .5, .5}, {.5, 3, .5}}))) << "through it";
  EXPECT_FALSE(fit(one, with({{.25, 1, .5}, {.2, 2, .5}, {.3, 2, .5}}))) << "in a point";
  EXPECT_FALSE(fit(one, with({{0, 1, 1}, {0, 2, 1}, {0, 2, 2}}))) << "in a corner of both";
}

TEST(Seams, places_count_from_the_origin_of_the_mesh) {
  TriMesh mesh = bar(0, 1, "a", "s");
  const Report report = check(mesh);
  for (Vec3& point : mesh.points) {
    point -= Vec3(100, 0, 0);
  }
  const std::vector<Seam> seams{seam("s", 1)};
  EXPECT_EQ(dupin::opened(mesh, Vec3(100, 0, 0), report, seams).sides.at(0).near.size(), 8 * 3);
  EXPECT_EQ(dupin::opened(mesh, Vec3::Zero(), report, seams).sides.at(0).near.size(), 0);
}

}  // namespace
}  // namespace dupin::test
