#include "dupin/kernel/remesh.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/fill.h"
#include "dupin/kernel/patch.h"
#include "dupin/kernel/rounding.h"
#include "kernel/meshing/solver_mesh_checks.h"
#include "support/mesh_distance.h"
#include "support/pipe_unions.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::box;
using test::kDegree;
using test::labelled;
using test::moved;
using test::tube;

/// What every remeshing must do; the mesh that it made.
TriMesh expect_remeshed(const Solid& solid, const RemeshOptions& options, Remeshed& made) {
  made = remesh(solid, options);
  const TriMesh before = to_mesh(solid).mesh(), after = to_mesh(made.solid).mesh();
  EXPECT_TRUE(check(after).is_solid());
  EXPECT_EQ(made.solid.euler_number(), solid.euler_number());
  EXPECT_EQ(made.solid.shells(), solid.shells());
  EXPECT_LE(made.report.deviation, options.distance);
  EXPECT_LE(test::sampled_distance(before, after), made.report.deviation + 1e-9);
  EXPECT_LE(test::sampled_distance(after, before), made.report.deviation + 1e-9);
  EXPECT_NEAR(test::smallest_angle(after), made.report.smallest_angle, 1e-9);
  EXPECT_NEAR(made.solid.volume(), solid.volume(), solid.area() * options.distance);
  return after;
}

TEST(Remesh, of_a_box_keeps_it_exactly) {
  Remeshed made;
  expect_remeshed(Solid::from(box(Vec3::Zero(), Vec3(4, 2, 1))),
                  {.distance = 0.01, .largest_edge = 0.5}, made);
  EXPECT_NEAR(made.solid.volume(), 8, 1e-12);
  EXPECT_EQ(made.report.poor_triangles, 0U);
  EXPECT_LE(made.report.longest_edge, 0.5);
  EXPECT_GE(made.report.smallest_angle, 25 * kDegree);
}

// It was one region, of edges as short as it is thick, which was made again and again.
TEST(Remesh, of_a_plate_has_rims_whatever_is_sharp) {
  const Solid plate = Solid::from(box(Vec3::Zero(), Vec3(100, 100, 1)));
  Remeshed made;
  expect_remeshed(plate, {.distance = 0.1, .feature_angle = 90 * kDegree}, made);
  EXPECT_EQ(made.report.poor_triangles, 0U);
  EXPECT_LT(made.solid.triangle_count(), 8000U);
}

TEST(Remesh, of_a_tube_has_the_angle_asked_for) {
  Remeshed made;
  const Solid given = Solid::from(tube(10, 0, 60, 128));
  const TriMesh after = expect_remeshed(given, {.distance = 0.1}, made);
  EXPECT_EQ(made.report.poor_triangles, 0U);
  EXPECT_GE(test::smallest_angle(after), 25 * kDegree);
  EXPECT_LT(test::smallest_angle(to_mesh(given).mesh()), 3 * kDegree);
}

TEST(Remesh, of_a_prism_keeps_its_creases_rather_than_to_have_tiny_triangles_there) {
  const Solid given = Solid::from(tube(5, 0, 20, 10));
  Remeshed made;
  const TriMesh after =
      expect_remeshed(given, {.distance = 0.01, .largest_edge = 1}, made);  // turns by 36 degrees
  EXPECT_EQ(made.report.poor_triangles, 0U);
  EXPECT_LT(static_cast<double>(after.triangles.size()), 20 * given.area());
}

TEST(Remesh, keeps_the_patches_of_a_union) {
  const Solid run = Solid::from(labelled(tube(10, 0, 60, 96), "run"));
  const Solid branch = Solid::from(labelled(moved(tube(4, 0, 60, 64), Vec3(3, 0, 30)), "branch"));
  const Solid both = unite(std::vector{run, branch});
  Remeshed made;
  const TriMesh after = expect_remeshed(both, {.distance = 0.05}, made);
  std::map<std::string, double> areas;
  for (const Patch& patch : patches_of(to_mesh(both).mesh())) {
    areas[patch.name] = patch.area;
  }
  for (const Patch& patch : patches_of(after)) {
    EXPECT_NEAR(patch.area, areas.at(patch.name), 0.01 * areas.at(patch.name)) << patch.name;
    areas.erase(patch.name);
  }
  EXPECT_TRUE(areas.empty());
  EXPECT_EQ(made.report.poor_triangles, 0U);
}

TEST(Remesh, of_crossing_pipes_has_few_poor_triangles) {
  for (const test::UnionKind kind : {test::UnionKind::equal, test::UnionKind::rotated}) {
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(std::string(test::name(kind)) + " " + std::to_string(seed));
      const Solid both = unite(test::pipes(kind, 32, seed));
      Remeshed made;
      expect_remeshed(both, {.distance = std::cbrt(both.volume()) / 100}, made);
      // Sharp edges leave some triangles little room where parts of a facet's width end.
      EXPECT_LE(made.report.poor_triangles, made.solid.triangle_count() / 100);
      EXPECT_GE(made.report.smallest_angle, 20 * kDegree);
    }
  }
}

TEST(Remesh, of_a_solid_without_sharp_edges_begins_at_seeds) {
  // A torus of 48 rings: there is no curve, and no ray from the middle meets it.
  TriMesh torus;
  constexpr std::uint32_t kRings = 48, kSegments = 24;
  for (std::uint32_t i = 0; i < kRings; ++i) {
    for (std::uint32_t k = 0; k < kSegments; ++k) {
      const double u = 2 * M_PI * i / kRings, v = 2 * M_PI * k / kSegments;
      const double r = 10 + std::cos(v);
      torus.points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
      const auto at = [&](std::uint32_t ring, std::uint32_t segment) {
        return ring % kRings * kSegments + segment % kSegments;
      };
      torus.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      torus.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  Remeshed made;
  expect_remeshed(Solid::from(torus), {.distance = 0.05}, made);
  EXPECT_EQ(made.solid.genus(), 1);
  EXPECT_EQ(made.report.poor_triangles, 0U);
}

TEST(Remesh, of_cavities_and_of_several_pieces_keeps_them) {
  const Solid room = subtract(Solid::from(box(Vec3::Zero(), Vec3(6, 6, 6))),
                              std::vector{Solid::from(box(Vec3(2, 2, 2), Vec3(4, 4, 4)))});
  const Solid both = unite(std::vector{room, Solid::from(box(Vec3(6.05, 0, 0), Vec3(8, 6, 6)))});
  Remeshed made;
  expect_remeshed(both, {.distance = 0.02}, made);
  EXPECT_EQ(made.solid.shells(), 3U);
}

TEST(Remesh, of_a_groove_shallower_than_its_edges_is_long_comes_to_an_end) {
  // A rim that overhangs a ball by little: balls about it must not reach the ball's surface.
  const Solid stepped =
      unite(std::vector{Solid::from(tube(10, 0, 20, 48)), Solid::from(tube(10.05, 20, 40, 48))});
  Remeshed made;
  expect_remeshed(stepped, {.distance = 0.1, .largest_edge = 5}, made);
}

TEST(Remesh, of_a_thin_plate_does_not_make_it_cross_itself) {
  Remeshed made;
  expect_remeshed(Solid::from(box(Vec3::Zero(), Vec3(1, 1, 0.02))), {.distance = 0.1}, made);
}

TEST(Remesh, of_nothing_is_nothing) { EXPECT_TRUE(remesh(Solid(), {.distance = 1}).solid.empty()); }

void expect_refused(const Solid& solid, const RemeshOptions& options, Errc code,
                    const std::vector<std::string>& said) {
  try {
    (void)remesh(solid, options);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    for (const std::string& text : said) {
      EXPECT_THAT(error.what(), testing::HasSubstr(text));
    }
  }
}

TEST(Remesh, refuses_a_solid_that_touches_itself) {
  const Solid touching = unite(std::vector{Solid::from(box(Vec3::Zero(), Vec3(1, 1, 1))),
                                           Solid::from(box(Vec3(1, 1, 0), Vec3(2, 2, 1)))});
  ASSERT_FALSE(touching.contacts().empty());
  expect_refused(touching, {.distance = 0.1}, Errc::contact, {"near (1, 1, "});
}

TEST(Remesh, can_be_cancelled) {
  try {
    (void)remesh(Solid::from(tube(10, 0, 60, 128)),
                 {.distance = 0.01,
                  .progress = [](std::string_view stage, double) { return stage != "mesh"; }});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::cancelled);
  }
}

TEST(Remesh, names_the_place_where_curves_ask_for_too_many_points) {
  // Two labels whose borders run close to each other.
  TriMesh mesh = box(Vec3::Zero(), Vec3(1, 1, 1));
  const Solid strip =
      unite(std::vector{Solid::from(labelled(mesh, "a")),
                        Solid::from(labelled(box(Vec3(0, 0, 1), Vec3(1, 1, 1 + 0x1p-28)), "b"))});
  expect_refused(strip, {.distance = 0x1p-31, .largest_edge = 0.5, .most_points = 5000},
                 Errc::limit_exceeded, {"come within 3.72529e-09 of each other near ("});
}

// Without trying for minutes, and with the reason.
TEST(Remesh, says_that_sides_are_nearer_than_the_distance_tells_apart) {
  const Solid sheet = Solid::from(box(Vec3::Zero(), Vec3(100, 100, 0.001)));
  expect_refused(sheet, {.distance = 0.5}, Errc::unroundable,
                 {"sides of the solid that are 0.001 apart near (", "allow a distance below that"});
  expect_refused(sheet, {.distance = 0.001}, Errc::limit_exceeded,
                 {"come within 0.001 of each other near "});
}

TEST(Remesh, takes_lengths_that_are_larger_than_the_solid) {
  const Solid solid = Solid::from(box(Vec3::Zero(), Vec3(1, 1, 1)));
  for (const double length : {1e9, 1e40, 1e300}) {
    EXPECT_EQ(remesh(solid, {.distance = 0.01, .largest_edge = length}).solid.euler_number(), 2);
    EXPECT_EQ(remesh(solid, {.distance = length}).solid.euler_number(), 2);
    EXPECT_FALSE(fill(solid, {.distance = 0.01, .largest_edge = length}).mesh.tetrahedra.empty());
  }
}

// The least distance that is named does; below it the generator would refine its own rounding.
TEST(Remesh, refuses_a_distance_that_doubles_do_not_tell) {
  for (const double size : {1., 1e12, 1e-9}) {
    const Solid solid = Solid::from(box(size * Vec3(1000, 0, 3), size * Vec3(1001, 1, 4)));
    for (const double share : {1e-12, 1e-11, 1e-30}) {
      try {
        (void)remesh(solid, {.distance = share * size});
        ADD_FAILURE();
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::invalid_argument);
        const std::string said = error.what(), begin = "must be at least ";
        const double least = std::stod(said.substr(said.find(begin) + begin.size()));
        EXPECT_EQ(remesh(solid, {.distance = least}).solid.euler_number(), 2) << said;
      }
    }
  }
}

TEST(Remesh, refuses_edges_that_are_far_too_short_at_once) {
  for (const double largest : {1e-9, 1e-4}) {
    try {
      (void)remesh(Solid::from(box(Vec3::Zero(), Vec3(1, 1, 1))),
                   {.distance = 0.01, .largest_edge = largest});
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::limit_exceeded);
      EXPECT_THAT(error.what(), testing::HasSubstr("more than 4000000 points"));
    }
  }
}

TEST(Remesh, refuses_options_outside_their_range) {
  const Solid solid = Solid::from(box(Vec3::Zero(), Vec3(1, 1, 1)));
  const double nan = std::nan("");
  const std::pair<RemeshOptions, const char*> cases[] = {
      {{.distance = 0}, "distance of a mesh"},
      {{.distance = nan}, "distance of a mesh"},
      {{.distance = 1, .largest_edge = -1}, "largest edge"},
      {{.distance = 1, .largest_edge = nan}, "largest edge"},
      {{.distance = 1, .smallest_angle = 1}, "between 0 and 30 degrees"},
      {{.distance = 1, .smallest_angle = nan}, "between 0 and 30 degrees"},
      {{.distance = 1, .feature_angle = 0}, "between 0 and 180 degrees"},
      {{.distance = 1, .most_points = 0}, "number of points"},
  };
  for (const auto& [options, words] : cases) {
    try {
      (void)remesh(solid, options);
      ADD_FAILURE() << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      EXPECT_THAT(error.what(), testing::HasSubstr(words));
    }
  }
}

}  // namespace
}  // namespace dupin
