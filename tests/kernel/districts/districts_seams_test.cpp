#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

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
  EXPECT_EQ(one.end_faces, (std::vector<std::uint32_t>{10, 11}));
  EXPECT_EQ(other.end_faces, (std::vector<std::uint32_t>{0, 1}));
  ASSERT_EQ(one.sides.size(), 1);
  EXPECT_TRUE(one.sides[0].is_end);
  EXPECT_EQ(one.sides[0].borders, (std::vector<SeamBorder>{{0, 4}}));
  EXPECT_EQ(one.report.shells.at(0).euler_number, 1);
  EXPECT_EQ(one.sides[0].near.size(), 8 * 3);
  EXPECT_EQ(other.report.shells.at(0).first_face, 0);
  EXPECT_TRUE(fit(one.sides[0], other.sides[0]));
  EXPECT_TRUE(fit(other.sides[0], one.sides[0]));
  Report all = one.report;
  append(other.report, all);
  join_shells(std::vector<SeamShells>{{{{{0, 1}, 4}}}}, all);
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
  EXPECT_TRUE(doubtful(std::vector<SeamShells>{{{{{0, 1}, 4}}, true}}).empty());
}

// Two bars that meet at both ends, as far as reports tell, make a ring.
TEST(Seams, a_ring_has_a_hole) {
  const std::vector<Seam> seams{seam("s", 1), seam("t", 0)};
  Report all = opened(bar(0, 1, "t", "s"), seams).report;
  append(all, all);
  join_shells(std::vector<SeamShells>{{{{{0, 1}, 4}}}, {{{{0, 1}, 4}}}}, all);
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
  EXPECT_FALSE(opened(bar(0, 1, "s", "s"), {seam("s", 1)}).sides.at(0).is_end) << "two of them";
  TriMesh mesh = bar(0, 1, "a", "s");
  mesh.labels[1] = 2;
  EXPECT_FALSE(opened(mesh, {seam("s", 1)}).sides.at(0).is_end) << "one and a corner";
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
  SeamSide also = one;  // a triangle of the disc that both have, seen from either side
  const std::vector<Vec3> corners(one.end.begin(), one.end.begin() + 3);
  also.near.insert(also.near.end(), corners.begin(), corners.end());
  EXPECT_FALSE(fit(also, with({corners[0], corners[2], corners[1]}))) << "in a face of both";
  EXPECT_FALSE(fit(also, with(corners))) << "in a face of both, turned alike";
}

TEST(Seams, fit_where_chords_of_discs_are_edges_of_one_side_only) {
  SeamSide one = opened(bar(0, 1, "a", "s"), {seam("s", 1)}).sides.at(0);
  SeamSide other = opened(bar(1, 3, "s", "b"), {seam("s", 1)}).sides.at(0);
  // Two corners across the disc, and a sheet of two triangles that hangs on that edge.
  const Vec3 a(1, 0, 0), b(1, 1, 1), below(.5, .5, .5), above(1.5, .5, .5);
  const auto hang = [&](SeamSide& side, const Vec3& apex) {
    side.near.insert(side.near.end(), {a, b, apex, b, a, apex + Vec3(.1, 0, 0)});
  };
  hang(one, below);
  EXPECT_TRUE(fit(one, other));
  hang(other, above);
  EXPECT_FALSE(fit(one, other)) << "four triangles have one edge";
}

// A bar with a hole of square section along it; the annuli at its ends are labelled, or the end is
// closed by a wall as thick as that around the hole.
TriMesh hollow(double from, double to, const std::string& start, const std::string& end,
               bool is_start_closed = false, bool is_end_closed = false) {
  TriMesh mesh;
  mesh.names = {"side", start, end};
  const auto corner = [&](std::uint32_t row, std::uint32_t k) { return 4 * row + k % 4; };
  const auto add_row = [&](double x, double margin) {
    for (const auto& [y, z] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      mesh.points.emplace_back(x, y == 0 ? margin : 1 - margin, z == 0 ? margin : 1 - margin);
    }
  };
  // Turned around, the same triangles.
  const auto band = [&](std::uint32_t one, std::uint32_t other, std::uint32_t label) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t a = corner(one, k), b = corner(one, k + 1), c = corner(other, k + 1),
                          d = corner(other, k);
      mesh.triangles.push_back(one < other ? Triangle{a, b, c} : Triangle{a, b, d});
      mesh.triangles.push_back(one < other ? Triangle{a, c, d} : Triangle{b, c, d});
      mesh.labels.insert(mesh.labels.end(), 2, label);
    }
  };
  const auto cap = [&](std::uint32_t row, bool is_turned) {
    const std::array<std::uint32_t, 4> c{corner(row, 0), corner(row, 1), corner(row, 2),
                                         corner(row, 3)};
    mesh.triangles.push_back(is_turned ? Triangle{c[0], c[2], c[1]} : Triangle{c[0], c[1], c[2]});
    mesh.triangles.push_back(is_turned ? Triangle{c[0], c[3], c[2]} : Triangle{c[0], c[2], c[3]});
    mesh.labels.insert(mesh.labels.end(), 2, 0);
  };
  constexpr double kWall = .25;
  add_row(from, 0);
  add_row(to, 0);
  add_row(is_end_closed ? to - kWall : to, kWall);
  add_row(is_start_closed ? from + kWall : from, kWall);
  band(0, 1, 0);
  band(2, 3, 0);
  if (is_start_closed) {
    cap(0, true);
    cap(3, false);
  } else {
    band(3, 0, 1);
  }
  if (is_end_closed) {
    cap(1, false);
    cap(2, true);
  } else {
    band(1, 2, 2);
  }
  return mesh;
}

std::vector<SeamShells> along(const SeamSide& one, const SeamSide& other, std::size_t before) {
  SeamShells result;
  for (std::size_t k = 0; k < one.borders.size(); ++k) {
    result.pairs.push_back(
        {{one.borders[k].shell, before + other.borders.at(k).shell}, one.borders[k].points});
  }
  return {result};
}

TEST(Seams, of_what_is_hollow_are_annuli) {
  const OpenPiece one = opened(hollow(0, 1, "a", "s"), {seam("s", 1)}),
                  other = opened(hollow(1, 3, "s", "b"), {seam("s", 1)});
  EXPECT_TRUE(one.sides.at(0).is_end);
  EXPECT_EQ(one.sides[0].borders, (std::vector<SeamBorder>{{0, 4}, {0, 4}}));
  EXPECT_EQ(one.report.euler_number, 0);
  EXPECT_TRUE(fit(one.sides[0], other.sides.at(0)));
  Report all = one.report;
  append(other.report, all);
  join_shells(along(one.sides[0], other.sides[0], 1), all);
  ASSERT_EQ(all.shells.size(), 1);
  EXPECT_EQ(all.points, 24);
  EXPECT_EQ(all.genus, 1);
  EXPECT_DOUBLE_EQ(all.shells[0].volume, 3 * .75);
  EXPECT_DOUBLE_EQ(all.volume, 3 * .75);
}

// Without the annulus, what is outside and what is inside no longer hang together.
TEST(Seams, join_what_encloses_a_void) {
  const OpenPiece one = opened(hollow(0, 1, "a", "s", true), {seam("s", 1)}),
                  other = opened(hollow(1, 3, "s", "b", false, true), {seam("s", 1)});
  EXPECT_EQ(one.sides.at(0).borders, (std::vector<SeamBorder>{{0, 4}, {1, 4}}));
  ASSERT_EQ(one.report.shells.size(), 2);
  EXPECT_FALSE(one.sides[0].has_others);
  EXPECT_DOUBLE_EQ(one.report.shells[0].volume, 1);
  EXPECT_DOUBLE_EQ(one.report.shells[1].volume, -.75 / 4);
  std::vector<SeamShells> seams = along(one.sides[0], other.sides.at(0), 2);
  EXPECT_TRUE(doubtful(seams).empty());
  Report all = one.report;
  append(other.report, all);
  join_shells(seams, all);
  ASSERT_EQ(all.shells.size(), 2);
  EXPECT_EQ(all.components, 1);
  EXPECT_EQ(all.euler_number, 4);
  EXPECT_EQ(all.genus, 0);
  EXPECT_EQ(all.shells[0].depth, 0);
  EXPECT_EQ(all.shells[1].depth, 1);
  EXPECT_DOUBLE_EQ(all.shells[0].volume, 3);
  EXPECT_DOUBLE_EQ(all.shells[1].volume, -2.5 / 4);
  EXPECT_DOUBLE_EQ(all.volume, 3 - 2.5 / 4);
  // In a void of what is no piece.
  Report deeper = one.report;
  append(other.report, deeper);
  for (ShellReport& shell : deeper.shells) {
    shell.depth += 2;
  }
  join_shells(seams, deeper);
  EXPECT_EQ(deeper.shells.at(0).depth, 2);
  EXPECT_EQ(deeper.shells.at(1).depth, 3);
  seams[0].has_others = true;
  EXPECT_EQ(doubtful(seams), std::vector<std::size_t>{0});
}

TEST(Seams, know_of_shells_that_end_at_none) {
  TriMesh mesh = hollow(0, 1, "a", "s");
  const TriMesh beside = bar(0, 1, "c", "d");
  for (const auto& [a, b, c] : beside.triangles) {
    mesh.triangles.push_back({a + 16, b + 16, c + 16});
    mesh.labels.push_back(0);
  }
  for (const Vec3& point : beside.points) {
    mesh.points.emplace_back(point + Vec3(0, 5, 0));
  }
  const OpenPiece piece = opened(mesh, {seam("s", 1)});
  EXPECT_TRUE(piece.sides.at(0).is_end);
  EXPECT_TRUE(piece.sides[0].has_others);
  EXPECT_EQ(piece.report.shells.at(1).volume, 1);
  EXPECT_EQ(piece.report.shells[1].first_face, 24);
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
