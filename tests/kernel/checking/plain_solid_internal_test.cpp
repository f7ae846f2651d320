#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "checking/inspection.h"
#include "checking/plain_solid.h"
#include "dupin/kernel/solid.h"
#include "kernel/same_report.h"
#include "kernel/wedges.h"
#include "mesh/exact_mesh.h"
#include "support/nasty_shapes.h"
#include "support/shapes.h"

namespace dupin::checking {
namespace {

constexpr double kMargin = 0x1p-30;

/// What closer inspection finds too, in all respects.
void expect_as_inspected(const TriMesh& mesh) {
  const auto plain = plain_solid(mesh, kMargin);
  const Inspection inspection = inspect(mesh, {.limit = 1}, kMargin);
  const Report& report = inspection.report;
  EXPECT_EQ(plain.has_value(), report.is_solid() && inspection.contacts.empty());
  if (plain) {
    EXPECT_EQ(plain->uses_all_points, report.count(Defect::isolated_point) == 0);
    if (plain->uses_all_points) {  // a point in the place of another one keeps inspection from it
      EXPECT_EQ(plain->stable, inspection.stable);
    }
  }
}

TEST(PlainSolid, is_reported_as_inspection_does) {
  std::size_t reported = 0;
  for (const test::NastyShape& shape : test::nasty_shapes()) {
    SCOPED_TRACE(shape.name);
    const Inspection inspection = inspect(shape.mesh, {.limit = 1}, kMargin);
    const auto report = plain_report(shape.mesh);
    if (inspection.report.is_solid() && inspection.contacts.empty() &&
        inspection.report.count(Defect::isolated_point) == 0) {
      ASSERT_TRUE(report.has_value());
      test::expect_same_report(*report, inspection.report);
      EXPECT_TRUE(report->findings.empty());
      ++reported;
    } else if (report) {  // all that it looks at is right
      EXPECT_GT(inspection.report.count(Defect::self_intersection) + inspection.contacts.size(), 0);
    }
  }
  EXPECT_GT(reported, 20);
}

TEST(PlainSolid, of_a_shell_the_wrong_way_has_no_report) {
  const TriMesh outer = test::box(Vec3(-3, -3, -3), Vec3(3, 3, 3)), inner = test::tetrahedron();
  EXPECT_FALSE(plain_report(test::joined({outer, inner})));
  TriMesh hollow = test::joined({outer, test::reversed(inner)});
  const auto report = plain_report(hollow);
  ASSERT_TRUE(report);
  test::expect_same_report(*report, inspect(hollow, {}, 0).report);
  EXPECT_TRUE(report->findings.empty());
  EXPECT_EQ(report->components, 1);
  EXPECT_EQ(report->shells[1].depth, 1);
  hollow.points.emplace_back(1, 2, 9);
  EXPECT_FALSE(plain_report(hollow)) << "a point that no triangle has";
  hollow.points.pop_back();
  hollow.triangles.pop_back();
  EXPECT_FALSE(plain_report(hollow)) << "open";
}

TEST(PlainSolid, is_what_has_no_fault_and_no_contact) {
  std::size_t plain = 0;
  for (const test::NastyShape& shape : test::nasty_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_as_inspected(shape.mesh);
    plain += plain_solid(shape.mesh, kMargin) ? 1 : 0;
  }
  EXPECT_GT(plain, 20);
}

TEST(PlainSolid, has_points_that_no_face_uses_and_shells_in_each_other) {
  TriMesh mesh = test::joined({test::box(Vec3(-3, -3, -3), Vec3(3, 3, 3)),
                               test::reversed(test::box(Vec3(-2, -2, -2), Vec3(2, 2, 2))),
                               test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1))});
  expect_as_inspected(mesh);
  EXPECT_TRUE(plain_solid(mesh, kMargin)->uses_all_points);
  mesh.points.emplace_back(9, 9, 9);
  EXPECT_FALSE(plain_solid(mesh, kMargin)->uses_all_points);
}

TEST(PlainSolid, does_not_touch_itself) {
  const TriMesh first = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  for (const Vec3& by : {Vec3(1, 1, 0), Vec3(1, 1, 1)}) {  // at an edge, at a corner
    TriMesh mesh = test::joined({first, test::moved(first, by)});
    EXPECT_TRUE(inspect(mesh, {}).report.is_solid());
    EXPECT_FALSE(plain_solid(mesh, kMargin));
  }
  // The corner in common as one point, with two fans.
  TriMesh mesh = test::joined({first, test::moved(first, Vec3(1, 1, 1))});
  for (Triangle& t : mesh.triangles) {
    std::ranges::replace(t, 8U, 7U);
  }
  EXPECT_EQ(mesh.points[7], mesh.points[8]);
  expect_as_inspected(mesh);
}

/// A many-sided tube, so that there are points with long fans, with something done to it.
TriMesh damaged(std::mt19937& random) {
  TriMesh mesh = test::tube(1, 0, 1, 24);
  const auto any = [&](std::size_t count) {
    return static_cast<std::uint32_t>(random() % static_cast<std::uint32_t>(count));
  };
  const std::uint32_t face = any(mesh.triangles.size());
  Triangle& t = mesh.triangles[face];
  switch (any(10)) {
    case 0:
      std::swap(t[0], t[1]);
      break;
    case 1:
      mesh.triangles.erase(mesh.triangles.begin() + face);
      break;
    case 2:
      mesh.triangles.push_back(mesh.triangles[face]);
      break;
    case 3:
      mesh.triangles.push_back({t[0], t[2], t[1]});
      break;
    case 4:
      t[any(3)] = any(mesh.points.size() + 2);
      break;
    case 5:
      mesh.points[any(mesh.points.size())] = mesh.points[any(mesh.points.size())];
      break;
    case 6:
      mesh.points[any(mesh.points.size())] += Vec3(any(3), any(3), any(3)) / 2;
      break;
    case 7:
      mesh.points[any(mesh.points.size())].z() = any(2) == 0 ? HUGE_VAL : 1e-70;
      break;
    case 8:
      mesh = test::reversed(std::move(mesh));
      break;
    default:
      mesh.points.push_back(mesh.points[any(mesh.points.size())]);
  }
  return mesh;
}

TEST(PlainSolid, is_found_exactly_where_inspection_finds_one) {
  std::mt19937 random(20261123);
  std::size_t plain = 0, not_plain = 0;
  for (int i = 0; i < 1000; ++i) {
    const TriMesh mesh = damaged(random);
    expect_as_inspected(mesh);
    (plain_solid(mesh, kMargin) ? plain : not_plain) += 1;
  }
  EXPECT_GT(plain, 100);
  EXPECT_GT(not_plain, 500);
}

// One pair that meets tells that a mesh is no plain solid: the millions here took half a minute.
TEST(PlainSolid, is_given_up_at_the_first_of_many_pairs_that_meet) {
  constexpr int kWedges = 2000;
  const TriMesh mesh = test::wedges(kWedges);
  EXPECT_FALSE(plain_solid(mesh, kMargin));
  const Solid solid = Solid::from(mesh);
  EXPECT_EQ(solid.components(), kWedges);
  EXPECT_FALSE(solid.contacts().empty());
  EXPECT_TRUE(solid.exact().stable.classes.empty());
}

}  // namespace
}  // namespace dupin::checking
