#include "dupin/kernel/rounding.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/interior_point.h"
#include "support/mesh_distance.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using testing::HasSubstr;

double distance_to_points(const Vec3& place, const TriMesh& mesh) {
  double nearest = INFINITY;
  for (const Vec3& point : mesh.points) {
    nearest = std::min(nearest, (point - place).norm());
  }
  return nearest;
}

bool holds_floats(const TriMesh& mesh) {
  for (const Vec3& p : mesh.points) {
    if (p != p.cast<float>().cast<double>()) {
      return false;
    }
  }
  return true;
}

TEST(ToMesh, copies_what_needs_no_rounding) {
  const TriMesh mesh = test::joined({test::labelled(test::box(Vec3(0, 0, 0), Vec3(1, 2, 3)), "a"),
                                     test::labelled(test::tetrahedron(Vec3(5, 5, 5)), "b")});
  for (const Coordinates target : {Coordinates::binary64, Coordinates::binary32}) {
    const Rounded rounded = to_mesh(Solid::from(mesh), target);
    EXPECT_EQ(rounded.mesh().points, mesh.points);
    EXPECT_EQ(rounded.mesh().triangles, mesh.triangles);
    EXPECT_EQ(rounded.mesh().labels, mesh.labels);
    EXPECT_EQ(rounded.mesh().names, mesh.names);
    EXPECT_EQ(rounded.sources().size(), mesh.triangles.size());
    EXPECT_EQ(rounded.sources()[3], (Source{0, 3}));
    EXPECT_EQ(rounded.report().coordinates, target);
    EXPECT_EQ(rounded.report().moved, 0);
    EXPECT_EQ(rounded.report().largest_move, 0);
    EXPECT_EQ(rounded.report().repair_reach, 0);
    EXPECT_EQ(rounded.report().removed_triangles, 0);
  }
  EXPECT_TRUE(to_mesh(Solid()).mesh().triangles.empty());
}

TEST(ToMesh, thins_out_what_floats_cannot_hold) {
  // At 10000 the floats are 2^-10 apart; the sides of the polygon are a fifth of that.
  const TriMesh mesh = test::moved(test::tube(0.03125, 0, 1, 1024), Vec3(1e4, 2e3, -1e4));
  const Rounded rounded = to_mesh(Solid::from(mesh), Coordinates::binary32);
  EXPECT_TRUE(check(rounded.mesh()).is_solid());
  EXPECT_TRUE(holds_floats(rounded.mesh()));
  EXPECT_EQ(rounded.report().moved, mesh.points.size());
  EXPECT_EQ(rounded.report().removed_triangles,
            mesh.triangles.size() - rounded.mesh().triangles.size());
  EXPECT_LE(rounded.report().largest_move, 1024 * 0x1p-10 + std::sqrt(0.75) * 0x1p-10);
  for (const Vec3& point : mesh.points) {
    EXPECT_LE(distance_to_points(point, rounded.mesh()), rounded.report().largest_move);
  }
}

TEST(ToMesh, leaves_what_is_far_from_repair_as_it_is_rounded) {
  const TriMesh thin = test::moved(test::tube(0.03125, 0, 1, 256), Vec3(1e4, 2e3, -1e4));
  const TriMesh plain = test::moved(test::tube(1000, 300, 500, 2048), Vec3(0.1, 0.2, 0.3));
  const Solid solid = Solid::from(test::joined({thin, plain}));
  const Rounded rounded = to_mesh(solid, Coordinates::binary32);
  EXPECT_TRUE(check(rounded.mesh()).is_solid());
  EXPECT_TRUE(holds_floats(rounded.mesh()));
  EXPECT_GT(rounded.report().repair_reach, 0);
  EXPECT_EQ(rounded.report().removed_triangles,
            solid.triangle_count() - rounded.mesh().triangles.size());
  const std::size_t points = rounded.mesh().points.size() - plain.points.size();
  const std::size_t triangles = rounded.mesh().triangles.size() - plain.triangles.size();
  EXPECT_LT(points, thin.points.size());
  for (std::size_t i = 0; i < plain.points.size(); ++i) {
    ASSERT_EQ(rounded.mesh().points[points + i], nearest(plain.points[i], Coordinates::binary32));
  }
  for (std::size_t i = 0; i < plain.triangles.size(); ++i) {
    const Triangle& t = rounded.mesh().triangles[triangles + i];
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(t[k], points + plain.triangles[i][k]);
    }
    ASSERT_EQ(rounded.sources()[triangles + i],
              (Source{0, static_cast<std::uint32_t>(thin.triangles.size() + i)}));
  }
}

TEST(ToMesh, keeps_labels_through_repair) {
  const TriMesh mesh = test::joined(
      {test::labelled(test::moved(test::tube(0.03125, 0, 1, 512), Vec3(1e4, 0, 0)), "thin"),
       test::labelled(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), "box")});
  const Rounded rounded = to_mesh(Solid::from(mesh), Coordinates::binary32);
  ASSERT_EQ(rounded.mesh().labels.size(), rounded.mesh().triangles.size());
  ASSERT_EQ(rounded.sources().size(), rounded.mesh().triangles.size());
  EXPECT_LT(rounded.mesh().triangles.size(), mesh.triangles.size());
  for (std::size_t f = 0; f < rounded.mesh().triangles.size(); ++f) {
    const bool thin = rounded.mesh().points[rounded.mesh().triangles[f][0]].x() > 100;
    EXPECT_EQ(rounded.mesh().names[rounded.mesh().labels[f]], thin ? "thin" : "box");
    EXPECT_EQ(rounded.mesh().labels[f], mesh.labels[rounded.sources()[f].triangle]);
  }
}

TEST(ToMesh, is_the_same_every_time) {
  const Solid solid =
      Solid::from(test::moved(test::tube(0.03125, 0, 1, 1024), Vec3(1e4, 2e3, -1e4)));
  const Rounded first = to_mesh(solid, Coordinates::binary32);
  const Rounded second = to_mesh(solid, Coordinates::binary32);
  EXPECT_EQ(first.mesh().points, second.mesh().points);
  EXPECT_EQ(first.mesh().triangles, second.mesh().triangles);
}

TEST(ToMesh, recentres_on_demand) {
  const TriMesh mesh = test::moved(test::tube(0.03125, 0, 1, 64), Vec3(238409, 81742, 606708));
  const Solid solid = Solid::from(mesh);
  const Rounded rounded =
      to_mesh(solid, Coordinates::binary32, {.origin = {.choice = Origin::Choice::automatic}});
  EXPECT_TRUE(check(rounded.mesh()).is_solid());
  EXPECT_EQ(rounded.mesh().triangles, mesh.triangles);
  EXPECT_LT(rounded.report().largest_move, 1e-7);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    EXPECT_LE((rounded.mesh().points[v] + rounded.report().origin - mesh.points[v]).norm(),
              rounded.report().largest_move * 1.001);
  }
  EXPECT_EQ(to_mesh(Solid::from(test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1))), Coordinates::binary32,
                    {.origin = {.choice = Origin::Choice::automatic}})
                .report()
                .origin,
            Vec3(0, 0, 0));
}

TEST(ToMesh, snaps_to_a_grid_on_demand) {
  const TriMesh mesh = test::moved(test::tube(1, 0, 2, 48), Vec3(0.1, 0.2, 0.3));
  const Rounded rounded =
      to_mesh(Solid::from(mesh), Coordinates::binary64, {.output_grid = 0x1p-8});
  EXPECT_TRUE(check(rounded.mesh()).is_solid());
  for (const Vec3& p : rounded.mesh().points) {
    EXPECT_EQ(p, Vec3((p * 0x1p8).array().round() * 0x1p-8));
  }
}

TEST(ToMesh, keeps_contacts) {
  const TriMesh mesh = test::moved(test::joined({test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                                 test::box(Vec3(1, 1, 0), Vec3(2, 2, 1))}),
                                   Vec3(0.1, 0.7, 0.3));
  const Rounded rounded = to_mesh(Solid::from(mesh), Coordinates::binary32);
  const Report report = check(rounded.mesh());
  EXPECT_TRUE(report.is_solid());
  EXPECT_EQ(report.count(Defect::contact), check(mesh).count(Defect::contact));
  EXPECT_EQ(rounded.mesh().points.size(), 16);
}

TEST(ToMesh, leaves_out_shells_that_are_too_small) {
  const TriMesh box = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const TriMesh mesh = test::joined({box, test::tetrahedron(Vec3(5, 5, 5), 1e-9)});
  const Rounded rounded = to_mesh(Solid::from(mesh), Coordinates::binary32);
  EXPECT_EQ(rounded.mesh().triangles, box.triangles);
  EXPECT_EQ(rounded.report().removed_shells, 1);
  EXPECT_EQ(rounded.report().removed_triangles, 4);
}

/// Tetrahedra of a few float steps that rounding may flatten or turn inside out.
// Of a box and a plate that is thinner than a step and lies askew, all but some scraps may go.
TEST(ToMesh, loses_nothing_further_away_than_it_says) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> angle(0, .6), thickness(.05, .9);
  std::size_t refused = 0, gone = 0;
  for (int round = 0; round < 30; ++round) {
    TriMesh plate = test::box(Vec3(0, 0, 0), Vec3(100, 100, thickness(random)));
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(angle(random), Vec3::UnitX()) *
                                  Eigen::AngleAxisd(angle(random), Vec3::UnitY()))
                                     .toRotationMatrix();
    for (Vec3& point : plate.points) {
      point = turn * point + Vec3(0, 0, 50);
    }
    const TriMesh box = test::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
    const TriMesh whole = test::joined({box, plate});
    RoundingOptions options{.tolerance = round % 2 == 0 ? 0.0 : 20, .output_grid = 1};
    try {
      const Rounded rounded = to_mesh(Solid::from(whole), Coordinates::binary64, options);
      const TriMesh& mesh = rounded.mesh();
      for (const auto& [a, b, c] : plate.triangles) {
        const Vec3 &p = plate.points[a], &q = plate.points[b], &r = plate.points[c];
        for (const Vec3& place : {p, Vec3((p + q) / 2), Vec3((p + q + r) / 3)}) {
          EXPECT_LE(test::distance_to(place, mesh), rounded.report().largest_move) << round;
        }
      }
      EXPECT_EQ(check(mesh).components + rounded.report().removed_shells, 2) << round;
      gone += rounded.report().removed_shells;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::unroundable);
      EXPECT_THAT(error.what(), testing::HasSubstr("lost"));
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(gone, 0);
}

TEST(ToMesh, loses_no_more_of_a_thin_flange_than_it_says) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> angle(0, 1.5), thickness(2e-4, 6e-4);
  for (int round = 0; round < 24; ++round) {
    std::vector<TriMesh> parts{test::tube(30, 0, 80, 13),
                               test::tube(50, 40, 40 + thickness(random), 16)};
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(angle(random), Vec3::UnitX()) *
                                  Eigen::AngleAxisd(angle(random), Vec3::UnitY()))
                                     .toRotationMatrix();
    std::vector<Solid> solids;
    for (TriMesh& part : parts) {
      for (Vec3& point : part.points) {
        point = turn * point + Vec3(8000, -8000, 8000);
      }
      solids.push_back(Solid::from(part));
    }
    const Rounded rounded = to_mesh(unite(solids), Coordinates::binary32);
    const auto& [flange, mesh] = std::pair(parts[1], rounded.mesh());
    for (const auto& [a, b, c] : flange.triangles) {
      const Vec3 &p = flange.points[a], &q = flange.points[b], &r = flange.points[c];
      for (const Vec3& place :
           {p, Vec3((p + q) / 2), Vec3((q + r) / 2), Vec3((r + p) / 2), Vec3((p + q + r) / 3)}) {
        if (winding_number(mesh, place) == 0) {
          EXPECT_LE(test::distance_to(place, mesh), rounded.report().largest_move) << round;
        }
      }
    }
  }
}

TEST(ToMesh, turns_no_shell_inside_out) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> offset(0, 3 * 0x1p-23);
  const TriMesh box = test::box(Vec3(2, 2, 2), Vec3(3, 3, 3));
  std::size_t kept = 0, removed = 0;
  for (int round = 0; round < 300; ++round) {
    TriMesh tiny = test::tetrahedron();
    for (Vec3& p : tiny.points) {
      p = Vec3(1 + offset(random), 1 + offset(random), 1 + offset(random));
    }
    TriMesh mesh = test::joined({box, tiny});
    if (!check(mesh).is_solid()) {
      mesh = test::joined({box, test::reversed(tiny)});
    }
    const Rounded rounded = to_mesh(Solid::from(mesh), Coordinates::binary32);
    ASSERT_TRUE(check(rounded.mesh()).is_solid()) << round;
    ++(rounded.report().removed_shells == 1 ? removed : kept);
  }
  EXPECT_GT(kept, 20);
  EXPECT_GT(removed, 20);
}

constexpr double kFloatStep = 0x1p-23;  // from 1 to 2

/// A tetrahedron between (1, 1, 1) and (2, 2, 2), all but its first corner held by floats, and
/// beside a side of it at that corner a tiny one, of floats or not, that touches nothing: outside
/// as material, inside as a void. None if that fails.
std::optional<TriMesh> neighbours(std::mt19937& random, bool of_floats) {
  std::uniform_real_distribution<double> in(1, 2), offset(-0.5, 0.5), part(0.05, 0.5);
  const auto vector = [&](auto& number) {
    return Vec3(number(random), number(random), number(random));
  };
  const auto to_floats = [](const Vec3& p) { return Vec3(p.cast<float>().cast<double>()); };
  TriMesh large = test::tetrahedron();
  for (Vec3& p : large.points) {
    p = to_floats(vector(in));
  }
  large.points[0] += kFloatStep * vector(offset);
  const auto& p = large.points;
  const Vec3 centre = p[0] + part(random) * (p[1] - p[0]) + part(random) * (p[2] - p[0]);
  const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
  TriMesh tiny = test::tetrahedron();
  for (Vec3& q : tiny.points) {
    do {
      q = centre + 8 * kFloatStep * vector(offset);
      q = of_floats ? to_floats(q) : q;
    } while (!(std::abs(normal.dot(q - centre)) < 0.4 * kFloatStep));
  }
  // So that few of all triangles move, as in most unions.
  TriMesh rest = test::tube(1, 5, 6, 128);
  std::ranges::transform(rest.points, rest.points.begin(), to_floats);
  for (const TriMesh& a : {large, test::reversed(large)}) {
    for (const TriMesh& b : {tiny, test::reversed(tiny)}) {
      if (check(test::joined({a, b})).is_solid()) {
        return test::joined({rest, a, b});
      }
    }
  }
  return std::nullopt;
}

// Its sign it keeps; but material within material, or a void outside, is no solid.
TEST(ToMesh, takes_no_shell_through_another) {
  std::mt19937 random(29);
  std::size_t made = 0;
  for (int round = 0; round < 4000; ++round) {
    if (const auto mesh = neighbours(random, round % 2 == 0)) {
      const Rounded rounded = to_mesh(Solid::from(*mesh), Coordinates::binary32);
      ASSERT_TRUE(check(rounded.mesh()).is_solid()) << round;
      ++made;
    }
  }
  EXPECT_GT(made, 300);
}

/// Heights of a ring, in float steps above 0.25, for pyramids with a void between them that turns
/// inside out when rounded to floats, and one that stays.
constexpr std::array<double, 4> kTurningVoid = {0.6, 1.4, 0.6, 0.4}, kLastingVoid = {0, 2, 0, 3};

Solid pyramids(std::array<double, 4> steps) {
  for (double& height : steps) {
    height = 0.25 + height * 0x1p-25;
  }
  const std::vector<TriMesh> parts = test::pyramids(steps);
  return Solid::from(test::joined({parts[0], parts[1]}));
}

TEST(ToMesh, fills_slits_that_rounding_turns_inside_out) {
  const Solid solid = pyramids(kTurningVoid);
  EXPECT_EQ(solid.contacts().size(), 4);
  EXPECT_EQ(to_mesh(solid).report().filled_places.size(), 0U) << "doubles hold it as it is";
  const Rounded rounded = to_mesh(solid, Coordinates::binary32);
  EXPECT_EQ(rounded.report().filled_places.size(), 1U);
  EXPECT_EQ(rounded.report().removed_triangles, 4);
  EXPECT_TRUE(rounded.contacts().empty());
  EXPECT_EQ(rounded.mesh().points.size(), 6);
  EXPECT_TRUE(check(rounded.mesh()).is_solid());
  EXPECT_GE(rounded.report().largest_move, rounded.report().slit_width / 2);
}

TEST(ToMesh, keeps_slits_that_rounding_keeps) {
  const Solid solid = pyramids(kLastingVoid);
  const Rounded rounded = to_mesh(solid, Coordinates::binary32);
  EXPECT_EQ(rounded.report().filled_places.size(), 0U);
  EXPECT_EQ(rounded.contacts().size(), 4);
  EXPECT_TRUE(check(rounded.mesh()).is_solid());
}

TEST(ToMesh, refuses_slits_wider_than_the_tolerance) {
  try {
    static_cast<void>(
        to_mesh(pyramids(kTurningVoid), Coordinates::binary32, {.tolerance = 0x1p-28}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::unroundable);
    EXPECT_EQ(error.where(), "(0, 0, 0.25000003)") << "to as many digits as tell a plant's places";
    EXPECT_THAT(error.message(), HasSubstr("larger tolerance"));
  }
}

TEST(ToMesh, says_what_would_help_where_it_cannot) {
  const Solid solid =
      Solid::from(test::moved(test::tube(0.03125, 0, 1, 1024), Vec3(1e4, 2e3, -1e4)));
  try {
    static_cast<void>(to_mesh(solid, Coordinates::binary32, {.tolerance = 0x1p-12}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::unroundable);
    EXPECT_THAT(error.where(), HasSubstr("(10000"));
    EXPECT_THAT(error.message(), HasSubstr("origin auto"));
    EXPECT_THAT(error.message(), HasSubstr("doubles"));
    EXPECT_THAT(error.message(), HasSubstr("larger tolerance"));
  }
  EXPECT_THROW(static_cast<void>(to_mesh(Solid::from(test::tetrahedron(Vec3(0, 0, 0), 1e39)),
                                         Coordinates::binary32)),
               Error);
}

// No tolerance helps, so none is named: a cube that is far out, a tetrahedron that is small.
TEST(ToMesh, says_so_where_nothing_would_be_left) {
  for (const TriMesh& mesh :
       {test::tetrahedron(Vec3(1e6, 0, 0), 1e-6), test::box(Vec3(1e9, 1, 1), Vec3(1e9 + 1, 2, 2)),
        test::box(Vec3(0, 0, 0), Vec3(1e-50, 1e-50, 1e-50))}) {
    try {
      static_cast<void>(to_mesh(Solid::from(mesh), Coordinates::binary32));
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::unroundable);
      EXPECT_THAT(error.message(), HasSubstr("leaves nothing"));
      EXPECT_THAT(error.message(), HasSubstr("doubles"));
      EXPECT_THAT(error.message(), testing::Not(HasSubstr("tolerance")));
    }
  }
}

// With the tolerance that is asked for, a grid keeps a thin tube from being rounded: neither
// another origin nor another format would help, but the tolerance named would.
TEST(ToMesh, names_a_tolerance_that_does_on_a_coarse_grid) {
  const Solid solid = Solid::from(test::moved(test::tube(2, 0, 4, 64), Vec3(1e4, 2e3, -1e4)));
  RoundingOptions options{.tolerance = 0x1p-12, .output_grid = 0.5};
  try {
    static_cast<void>(to_mesh(solid, Coordinates::binary32, options));
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.message(), HasSubstr("a finer grid"));
    EXPECT_THAT(error.message(), testing::Not(HasSubstr("doubles")));
    EXPECT_THAT(error.message(), HasSubstr("a larger tolerance (512 would do)"));
  }
  options.tolerance = 512;
  EXPECT_TRUE(check(to_mesh(solid, Coordinates::binary32, options).mesh()).is_solid());
}

TEST(ToMesh, refuses_senseless_options) {
  const Solid solid = Solid::from(test::tetrahedron());
  const RoundingOptions table[] = {
      {.tolerance = -1},
      {.tolerance = NAN},
      {.tolerance = INFINITY},
      {.output_grid = 0.1},
      {.output_grid = -0.5},
      {.output_grid = NAN},
      {.origin = {Origin::Choice::given, Vec3(0, NAN, 0)}},
  };
  for (const RoundingOptions& options : table) {
    try {
      static_cast<void>(to_mesh(solid, Coordinates::binary64, options));
      ADD_FAILURE() << options.tolerance << " " << options.output_grid;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace dupin
