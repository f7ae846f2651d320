#include "dupin/kernel/districts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "support/message_of.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

using Box = Eigen::AlignedBox3d;

Box cube(double x, double y, double z, double size) {
  return {Vec3(x, y, z), Vec3(x + size, y + size, z + size)};
}

Errc code_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.code();
  }
  return Errc::internal;
}

TEST(Districts, are_boxes_that_touch) {
  const std::vector<Box> boxes{
      cube(0, 0, 0, 1),  cube(5, 0, 0, 1), cube(1, 1, 1, 1), cube(2.5, 0, 0, 1), Box(),
      cube(2, 2, 2, .75)};
  EXPECT_EQ(districts_of(boxes), (std::vector<std::uint32_t>{0, 1, 0, 2, 3, 0}));
  EXPECT_TRUE(districts_of({}).empty());
}

TEST(Districts, of_boxes_that_are_taken_for_apart_touch_through_others_only) {
  const std::vector<Box> boxes{cube(0, 0, 0, 1), cube(1, 0, 0, 1), cube(2, 0, 0, 1),
                               cube(0, 1, 0, 1)};
  EXPECT_EQ(districts_of(boxes, Pairs{{1, 2}}), (std::vector<std::uint32_t>{0, 0, 1, 0}));
  EXPECT_EQ(districts_of(boxes, Pairs{{0, 1}}), (std::vector<std::uint32_t>{0, 0, 0, 0}));
  EXPECT_EQ(districts_of(boxes, Pairs{{0, 1}, {1, 3}}), (std::vector<std::uint32_t>{0, 1, 1, 0}));
}

TEST(Districts, an_infinite_box_touches_all) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<Box> boxes{
      cube(0, 0, 0, 1), cube(5, 0, 0, 1), {Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)}};
  EXPECT_EQ(districts_of(boxes), (std::vector<std::uint32_t>{0, 0, 0}));
}

TEST(Districts, of_random_boxes_are_those_of_a_search_of_all_pairs) {
  std::mt19937 random(21);
  for (int round = 0; round < 20; ++round) {
    // Few touch, or nearly all do.
    std::uniform_int_distribution<int> place(0, 40), size(0, round % 2 == 0 ? 4 : 30);
    std::vector<Box> boxes;
    for (int i = 0; i < 300; ++i) {
      const Vec3 low(place(random), place(random), place(random));
      boxes.emplace_back(low, low + Vec3(size(random), size(random), size(random)));
    }
    Pairs touching, apart;
    for_each_touching(boxes, [&](std::uint32_t i, std::uint32_t j) { touching.push_back({i, j}); });
    Pairs expected_pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
        if (boxes[i].intersects(boxes[j])) {
          expected_pairs.push_back({i, j});
        }
      }
    }
    ASSERT_EQ(touching, expected_pairs);
    if (round % 4 > 1) {  // of which half are left out, and all but few of the first boxes
      for (const auto& pair : touching) {
        if (random() % 2 == 0 || pair[0] < 20) {
          apart.push_back(pair);
        }
      }
    }
    const std::vector<std::uint32_t> found = districts_of(boxes, apart);
    std::vector<std::uint32_t> expected(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      expected[i] = i;
      for (std::uint32_t j = 0; j < i; ++j) {
        if (boxes[i].intersects(boxes[j]) && !std::ranges::binary_search(apart, std::array{j, i})) {
          const std::uint32_t from = std::max(expected[i], expected[j]),
                              to = std::min(expected[i], expected[j]);
          std::replace(expected.begin(), expected.begin() + i + 1, from, to);
        }
      }
    }
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        ASSERT_EQ(found[i] == found[j], expected[i] == expected[j]) << i << " " << j;
      }
    }
  }
}

TEST(Districts, triangles_lie_in_the_interior_of_one_box) {
  const Solid solid = Solid::from(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_TRUE(lies_in(solid, {cube(-.5, -.5, -.5, 2)}));
  EXPECT_FALSE(lies_in(solid, {cube(0, 0, 0, 1)}));
  EXPECT_FALSE(lies_in(solid, {}));
  // Each corner is in a box, but no face is.
  EXPECT_FALSE(lies_in(solid, {cube(-.5, -.5, -.5, 1.25), cube(.5, .5, .5, 1)}));
}

TEST(Districts, joined_solids_are_their_union) {
  const std::vector<Solid> solids{Solid::from(labelled(box({0, 0, 0}, {1, 1, 1}), "a")), Solid(),
                                  Solid::from(box({5, 0, 0}, {6, 2, 1})),
                                  Solid::from(labelled(box({0, 5, 0}, {1, 6, 3}), "b"))};
  const std::vector<Boxes> boxes{
      {cube(-.5, -.5, -.5, 2)}, {}, {cube(4.5, -.5, -.5, 3)}, {cube(-.5, 4.5, -.5, 4)}};
  const Solid all = joined(solids, boxes), united = unite(solids);
  EXPECT_EQ(all.exact_volume(), united.exact_volume());
  EXPECT_EQ(all.components(), 3);
  EXPECT_EQ(all.names(), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(all.labels().at(12), 1);
  EXPECT_EQ(all.sources().at(30).operand, 3);
  EXPECT_EQ(all.sources().at(30).triangle, 6);
  EXPECT_EQ(subtract(united, {{all}}).triangle_count(), 0);
}

TEST(Districts, joined_solids_keep_exact_points) {
  const Solid cut = unite(
      {{Solid::from(tetrahedron({0, 0, 0}, 3)), Solid::from(tetrahedron({1. / 3, .1, .1}, 3))}});
  const Solid far = Solid::from(box({20, 0, 0}, {21, 1, 1}));
  const Boxes near{cube(-1, -1, -1, 6)}, about_far{cube(19, -1, -1, 3)};
  const Solid all = joined(std::vector{far, cut}, std::vector{about_far, near});
  std::size_t between = 0;
  for (std::size_t i = 0; i < cut.triangle_count(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto exact = cut.exact_point(cut.triangles()[i][k]);
      EXPECT_EQ(all.exact_point(all.triangles()[far.triangle_count() + i][k]), exact);
      between += exact[0] == mpq_class(exact[0].get_d()) ? 0 : 1;
    }
  }
  EXPECT_GT(between, 0) << "all are doubles";
  // What is cut again is cut in the planes that it lies in.
  const Solid other = Solid::from(box({.5, -1, .5}, {1, 4, 1}));
  EXPECT_EQ(subtract(all, {{other}}).exact_volume(), subtract(cut, {{other}}).exact_volume() + 1);
}

TEST(Districts, what_lies_elsewhere_is_not_joined) {
  const std::vector<Solid> solids{Solid::from(box({0, 0, 0}, {1, 1, 1})),
                                  Solid::from(box({5, 0, 0}, {6, 1, 1}))};
  const Boxes first{cube(-.5, -.5, -.5, 2)}, second{cube(4.5, -.5, -.5, 2)};
  const auto code = [&](const std::vector<Boxes>& boxes) {
    return code_of([&] { (void)joined(solids, boxes); });
  };
  EXPECT_EQ(code({first, first}), Errc::invalid_argument);
  EXPECT_EQ(code({second, first}), Errc::invalid_argument);
  EXPECT_EQ(code({first}), Errc::invalid_argument);
  EXPECT_EQ(code({{cube(-.5, -.5, -.5, 5)}, second}), Errc::invalid_argument);  // they touch
}

// Boxes about the faces of a hollow cube, but not about what is between them.
Boxes about_faces_of_cube(double low, double high) {
  constexpr double kWall = .5;
  Boxes boxes;
  for (int k = 0; k < 3; ++k) {
    for (const double at : {low, high}) {
      Box side(Vec3::Constant(low - kWall), Vec3::Constant(high + kWall));
      side.min()[k] = at - kWall;
      side.max()[k] = at + kWall;
      boxes.push_back(side);
    }
  }
  return boxes;
}

TEST(Districts, what_lies_inside_of_another_solid_is_not_joined) {
  const Solid inner = Solid::from(box({4, 4, 4}, {6, 6, 6}));
  const Solid full = Solid::from(box({0, 0, 0}, {10, 10, 10}));
  const Boxes about_inner{cube(3, 3, 3, 4)}, about_full = about_faces_of_cube(0, 10);
  EXPECT_EQ(code_of([&] {
              (void)joined(std::vector{full, inner}, std::vector{about_full, about_inner});
            }),
            Errc::invalid_argument);
  // In a void of it, it may.
  const Solid hollow = subtract(full, {{Solid::from(box({2, 2, 2}, {8, 8, 8}))}});
  Boxes about_hollow = about_full;
  for (const Box& side : about_faces_of_cube(2, 8)) {
    about_hollow.push_back(side);
  }
  EXPECT_EQ(
      joined(std::vector{hollow, inner}, std::vector{about_hollow, about_inner}).exact_volume(),
      1000 - 216 + 8);
}

TEST(Districts, rounded_solids_are_joined_as_they_are) {
  std::vector<Solid> solids;
  std::vector<Boxes> boxes;
  for (int i = 0; i < 3; ++i) {
    const double x = 1000.1 + 10 * i;
    solids.push_back(Solid::from(labelled(tetrahedron({x, .3, .7}, 1), i == 1 ? "b" : "a")));
    boxes.push_back({cube(x - 1, -1, -1, 4)});
  }
  RoundingOptions options{.origin = {.choice = Origin::Choice::automatic}};
  options.whole = {.box = bounds_of(boxes)};
  std::vector<Rounded> rounded;
  for (const Solid& solid : solids) {
    rounded.push_back(to_mesh(solid, Coordinates::binary32, options));
  }
  const Rounded all = joined(rounded, boxes);
  EXPECT_TRUE(check(all.mesh()).is_solid());
  EXPECT_EQ(all.mesh().triangles.size(), 12);
  EXPECT_EQ(all.mesh().names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(all.report().origin, rounded[0].report().origin);
  EXPECT_EQ(all.report().moved, 12);
  EXPECT_EQ(all.sources().at(7), (Source{1, 3}));
  EXPECT_EQ(check(all).components, 3);
  // All with the origin of the whole: what is rounded at once has the same points.
  const Rounded at_once = to_mesh(joined(solids, boxes), Coordinates::binary32, options);
  EXPECT_EQ(at_once.mesh().points, all.mesh().points);
}

TEST(Districts, rounded_solids_with_several_origins_are_not_joined) {
  const Solid first = Solid::from(box({0, 0, 0}, {1, 1, 1})),
              second = Solid::from(box({50, 0, 0}, {51, 1, 1}));
  const RoundingOptions own{.origin = {.choice = Origin::Choice::automatic}};
  const std::vector<Rounded> rounded{to_mesh(first, Coordinates::binary32, own),
                                     to_mesh(second, Coordinates::binary32, own)};
  ASSERT_NE(rounded[0].report().origin, rounded[1].report().origin);
  EXPECT_EQ(
      code_of([&] {
        (void)joined(rounded, std::vector<Boxes>{{cube(-1, -1, -1, 3)}, {cube(49, -1, -1, 3)}});
      }),
      Errc::invalid_argument);
}

TEST(Districts, checks_of_all_are_that_of_all_at_once) {
  const TriMesh ring = frame(), ball = moved(tetrahedron(), Vec3(20, 0, 0));
  const Report at_once = check(joined({ring, ball, moved(ring, Vec3(0, 20, 0))}));
  Report all;
  for (const TriMesh& mesh : {ring, ball, moved(ring, Vec3(0, 20, 0))}) {
    add(check(mesh), all);
  }
  EXPECT_EQ(all.points, at_once.points);
  EXPECT_EQ(all.counts, at_once.counts);
  EXPECT_EQ(all.shells, at_once.shells);
  EXPECT_EQ(all.components, at_once.components);
  EXPECT_EQ(all.euler_number, at_once.euler_number);
  EXPECT_EQ(all.genus, 2);
  EXPECT_DOUBLE_EQ(all.volume, at_once.volume);  // a sum of rounded ones
  EXPECT_TRUE(all.is_solid());
}

TEST(Districts, checks_of_all_have_the_findings_of_all) {
  const TriMesh ball = tetrahedron();
  TriMesh torn = ball;
  torn.triangles.pop_back();
  std::vector<TriMesh> meshes;
  for (int i = 0; i < 60; ++i) {
    meshes.push_back(moved(i % 3 == 0 ? ball : torn, Vec3(20 * i, 0, 0)));
  }
  Report all;
  for (const TriMesh& mesh : meshes) {
    add(check(mesh), all);
  }
  const Report at_once = check(joined(meshes));
  ASSERT_EQ(all.findings.size(), at_once.findings.size());
  EXPECT_EQ(all.findings.size(), 100) << "as many as are kept";
  EXPECT_EQ(all.count(Defect::boundary_edge), 120);
  for (std::size_t i = 0; i < all.findings.size(); ++i) {
    EXPECT_EQ(all.findings[i].defect, at_once.findings[i].defect) << i;
    EXPECT_EQ(all.findings[i].faces, at_once.findings[i].faces) << i;
    EXPECT_EQ(all.findings[i].points, at_once.findings[i].points) << i;
    EXPECT_EQ(all.findings[i].place, at_once.findings[i].place) << i;
  }
}

TEST(Districts, nothing_may_be_left_of_a_piece_but_not_of_all) {
  const Solid speck = Solid::from(tetrahedron({1e5, 0, 0}, 1e-4));
  RoundingOptions options;
  EXPECT_EQ(code_of([&] { (void)to_mesh(speck, Coordinates::binary32, options); }),
            Errc::unroundable);
  options.whole = {.box = Box(Vec3::Constant(-1e5), Vec3::Constant(1e5))};
  const Rounded nothing = to_mesh(speck, Coordinates::binary32, options);
  EXPECT_TRUE(nothing.mesh().triangles.empty());
  EXPECT_EQ(nothing.report().removed_shells, 1);
  EXPECT_NO_THROW(require_something_left(nothing.report(), 4, options));
  EXPECT_EQ(code_of([&] { require_something_left(nothing.report(), 0, options); }),
            Errc::unroundable);
  EXPECT_NO_THROW(require_something_left({}, 0, options)) << "there was nothing";
}

TEST(Districts, recentring_is_a_remedy_for_what_is_far_as_a_whole) {
  const auto message = [&](const Box& whole) {
    RoundingOptions options;
    options.whole = {.box = whole, .largest = 0x1p20};
    RoundingReport report;
    report.removed_shells = 1;
    report.coordinates = Coordinates::binary32;
    return message_of([&] { require_something_left(report, 0, options); });
  };
  EXPECT_THAT(message({Vec3(1e6, 0, 0), Vec3(1e6 + 10, 10, 10)}),
              testing::HasSubstr("origin auto"));
  EXPECT_THAT(message({Vec3(-1e6, 0, 0), Vec3(1e6, 10, 10)}),
              testing::Not(testing::HasSubstr("origin auto")));
}

TEST(Districts, rounding_reaches_as_far_as_in_the_whole) {
  const Solid thin = Solid::from(moved(tube(0.03125, 0, 1, 256), Vec3(1e4, 2e3, -1e4)));
  const double own = to_mesh(thin, Coordinates::binary32).report().repair_reach;
  EXPECT_GT(own, 0);
  RoundingOptions options;
  options.whole = {.box = Box(Vec3::Constant(-8e4), Vec3::Constant(8e4))};
  EXPECT_EQ(to_mesh(thin, Coordinates::binary32, options).report().repair_reach, 8 * own);
}

TEST(Districts, of_bounds_that_are_not_numbers_are_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int bound = 0; bound < 6; ++bound) {
    std::vector<Box> boxes(3, cube(0, 0, 0, 1));
    (bound < 3 ? boxes[2].min() : boxes[2].max())[bound % 3] = nan;
    const std::string message = "box 2 has a bound that is not a number";
    EXPECT_EQ(message_of([&] { (void)districts_of(boxes); }, Errc::invalid_argument), message);
    EXPECT_EQ(message_of([&] { for_each_touching(boxes, [](std::uint32_t, std::uint32_t) {}); },
                         Errc::invalid_argument),
              message);
    EXPECT_EQ(message_of(
                  [&] {
                    (void)FreePlaces(boxes, {{}, {}, {}});
                  },
                  Errc::invalid_argument),
              message);
  }
}

TEST(Districts, boxes_that_nothing_lies_in_have_numbers) {
  const Solid solid = Solid::from(test::box({0, 0, 0}, {1, 1, 1}));
  Eigen::AlignedBox3d box(Vec3(-1, -1, -1), Vec3(2, 2, 2));
  box.max().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(test::message_of([&] { (void)lies_in(solid, {box}); }, Errc::invalid_argument),
            "box 0 has a bound that is not a number");
  EXPECT_THROW((void)lies_in(to_mesh(solid), {box}), Error);
}

}  // namespace
}  // namespace dupin::test
