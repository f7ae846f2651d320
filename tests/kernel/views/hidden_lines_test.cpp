#include "dupin/kernel/hidden_lines.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using Line = std::vector<Vec3>;

void expect_stretches(const std::vector<Stretch>& found, const std::vector<Stretch>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].from, wanted[i].from, 1e-14);
    EXPECT_NEAR(found[i].to, wanted[i].to, 1e-14);
  }
}

TEST(HiddenLines, of_a_box_are_those_behind_and_inside) {
  const HiddenLines scene(test::box({0, 0, 0}, {1, 1, 1}), view_along(-Vec3::UnitZ()));
  const auto seen = [&](double z) { return scene.seen(Line{{-1, .25, z}, {3, .25, z}}, 0); };
  expect_stretches(seen(-1).covered, {{.25, .5}});
  expect_stretches(seen(-1).inside, {});
  expect_stretches(seen(.5).covered, {{.25, .5}});
  expect_stretches(seen(.5).inside, {{.25, .5}});
  expect_stretches(seen(2).covered, {});
  // Down through the box: it is covered as soon as it is in.
  const SeenLine down = scene.seen(Line{{.5, .25, 3}, {.25, .5, -1}, {-4, .5, -1}}, 0);
  expect_stretches(down.covered, {{.5, 1 + .25 / 4.25}});
  expect_stretches(down.inside, {{.5, .75}});
}

TEST(HiddenLines, leave_out_what_is_shorter_than_asked) {
  const TriMesh two =
      test::joined({test::box({0, 0, 0}, {1, 1, 1}), test::box({1.1, 0, 0}, {2, 1, 1}),
                    test::box({5, 0, 0}, {5.1, 1, 1})});
  const HiddenLines scene(two, view_along(-Vec3::UnitZ()));
  const Line line{{-.1, .3, -1}, {9.9, .3, -1}};
  expect_stretches(scene.seen(line, .05).covered, {{.01, .11}, {.12, .21}, {.51, .52}});
  expect_stretches(scene.seen(line, .15).covered, {{0, .21}});
  expect_stretches(scene.seen(Line{{0, 0, 0}}, 0).covered, {});
}

// Against counting triangles before a point, one by one.
TEST(HiddenLines, agree_with_rays_at_points) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> at(-1, 1);
  const auto point = [&] { return Vec3(at(random), at(random), at(random)); };
  for (int round = 0; round < 20; ++round) {
    std::vector<TriMesh> parts;
    for (int i = 0; i < 6; ++i) {
      const Vec3 a = point(), b = point();
      parts.push_back(i % 2 == 0 ? test::box(a.cwiseMin(b), a.cwiseMax(b))
                                 : test::tetrahedron(a, .8));
    }
    const TriMesh mesh = test::joined(parts);
    const View view = view_along(point());
    const HiddenLines scene(mesh, view);
    for (int i = 0; i < 50; ++i) {
      const Line line{point(), point(), point()};
      const SeenLine found = scene.seen(line, 0);
      const auto contains = [](const std::vector<Stretch>& all, double parameter) {
        return std::ranges::any_of(
            all, [&](const Stretch& one) { return one.from < parameter && parameter < one.to; });
      };
      for (int k = 0; k < 20; ++k) {
        const double parameter = 1 + at(random);
        const auto segment = std::size_t(parameter);
        const Vec3 p =
            line[segment] + (parameter - double(segment)) * (line[segment + 1] - line[segment]);
        int count = 0, winding = 0;
        for (const auto& [a, b, c] : mesh.triangles) {
          Eigen::Matrix3d axes;
          axes << mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a], -view.towards;
          const Vec3 x = axes.fullPivLu().solve(p - mesh.points[a]);
          if (x[0] > 0 && x[1] > 0 && x[0] + x[1] < 1 && x[2] > 0) {
            ++count;
            winding += axes.determinant() < 0 ? 1 : -1;
          }
        }
        EXPECT_EQ(contains(found.covered, parameter), count > 0);
        EXPECT_EQ(contains(found.inside, parameter), winding != 0);
      }
    }
  }
}

// The diagonals of the box's faces, or its sides, are edges of triangles on either side of the
// line.
TEST(HiddenLines, are_hidden_along_edges_too) {
  const TriMesh box = test::box({0, 0, 0}, {1, 1, 1});
  for (const Vec3& towards : {Vec3(0, 0, 1), Vec3(1, 2, 5), Vec3(-3, 1, 2)}) {
    const HiddenLines scene(box, view_along(-towards.normalized()));
    for (const bool is_other : {false, true}) {
      const auto corner = [&](double t, double z) { return Vec3(t, is_other ? 1 - t : t, z); };
      SCOPED_TRACE(testing::Message() << towards.transpose() << ' ' << is_other);
      const Vec3 below = -2 * towards;
      const Line line{corner(0, 1) + below, corner(1, 1) + below};
      expect_stretches(scene.seen(line, 1e-9).covered, {{0, 1}});
      expect_stretches(scene.seen(line, 1e-9).inside, {});
      const Line within{corner(0, .5), corner(1, .5)};
      expect_stretches(scene.seen(within, 1e-9).inside, {{0, 1}});
    }
  }
  // The box's own upper sides have it on one side only.
  const HiddenLines scene(box, view_along(-Vec3::UnitZ()));
  for (const Vec3& to : {Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    for (const Vec3& from : {Vec3(0, 0, 0), Vec3(1, 1, 0)}) {
      const Line side{from, from + (from.x() > 0 ? Vec3(-to) : to)};
      EXPECT_TRUE(scene.seen(side, 1e-9).covered.empty());
      EXPECT_TRUE(scene.seen(side, 1e-9).inside.empty());
    }
  }
}

TEST(HiddenLines, are_of_finite_numbers) {
  const TriMesh box = test::box({0, 0, 0}, {1, 1, 1});
  const std::vector<Vec3> line = {{0, 0, -1}, {1, 1, -1}};
  for (const double number : {std::nan(""), double(INFINITY)}) {
    TriMesh bad = box;
    bad.points[0].x() = number;
    View view;
    view.up.x() = number;
    EXPECT_THROW(HiddenLines(bad, {}), Error);
    EXPECT_THROW(HiddenLines(box, view), Error);
    EXPECT_THROW((void)HiddenLines(box, {}).seen(std::vector<Vec3>{line[0], {0, number, 0}}, 0),
                 Error);
    EXPECT_THROW((void)HiddenLines(box, {}).seen(line, number), Error);
  }
  TriMesh bad = box;
  bad.triangles[0][0] = 8;
  EXPECT_THROW(HiddenLines(bad, {}), Error);
}

}  // namespace
}  // namespace dupin
