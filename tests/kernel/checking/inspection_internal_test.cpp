#include <algorithm>
#include <array>
#include <random>

#include <gtest/gtest.h>

#include "checking/inspection.h"
#include "checking/self_intersection.h"
#include "dupin/kernel/check.h"
#include "kernel/torus.h"
#include "support/shapes.h"

namespace dupin::checking {
namespace {

bool same(const Report& a, const Report& b) {
  const auto same_findings = [](const Finding& f, const Finding& g) {
    return f.defect == g.defect && f.faces == g.faces && f.points == g.points && f.place == g.place;
  };
  return a.counts == b.counts && a.shells == b.shells && a.volume == b.volume && a.area == b.area &&
         std::ranges::equal(a.findings, b.findings, same_findings);
}

TEST(Inspection, has_the_report_of_check_whatever_the_margin) {
  const TriMesh cube = test::box(Vec3::Constant(0), Vec3::Constant(2));
  for (const TriMesh& mesh :
       {cube, test::joined({cube, test::moved(cube, {1, 1, 1})}),  // cross each other
        test::joined({cube, test::moved(cube, {2, 2, 2})}),        // touch in a point
        test::joined({cube, test::moved(cube, {2, 2, 0})}),        // along an edge
        test::reversed(cube), test::torus(12, 24, 2, 1)}) {
    const Report report = check(mesh);
    EXPECT_TRUE(same(inspect(mesh, {}).report, report));
    EXPECT_TRUE(same(inspect(mesh, {}, 1e-9).report, report));
  }
}

TEST(Inspection, places_contacts) {
  const TriMesh cube = test::box(Vec3::Constant(0), Vec3::Constant(2));
  const Inspection point = inspect(test::joined({cube, test::moved(cube, {2, 2, 2})}), {});
  ASSERT_EQ(point.contacts.size(), 1);
  EXPECT_EQ(point.contacts[0].kind, Contact::Kind::vertex);
  EXPECT_EQ(point.contacts[0].from, 7) << "the corner of the first one";
  const Inspection edge = inspect(test::joined({cube, test::moved(cube, {2, 2, 0})}), {});
  ASSERT_EQ(edge.contacts.size(), 1);
  EXPECT_EQ(edge.contacts[0].kind, Contact::Kind::edge);
  EXPECT_TRUE(edge.contacts[0].alternating);
  EXPECT_EQ(edge.contacts[0].faces.size(), 4);
}

TEST(Inspection, names_the_place_that_the_boxes_of_crossing_faces_have_in_common) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {1, 1, -2}, {3, 1, 4}, {1, 3, 4}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const Report report = inspect(mesh, {}).report;
  const auto found =
      std::ranges::find(report.findings, Defect::self_intersection, &Finding::defect);
  ASSERT_NE(found, report.findings.end());
  EXPECT_EQ(found->place, Vec3(2, 2, 0));
  EXPECT_EQ(found->faces, (std::vector<std::uint32_t>{0, 1}));
}

TEST(Inspection, seeks_stable_triangles_only_with_a_margin) {
  const TriMesh mesh = test::torus(24, 48, 2, 1);
  EXPECT_TRUE(inspect(mesh, {}).stable.empty());
  const auto stable = inspect(mesh, {}, 1e-9).stable;
  EXPECT_EQ(stable.size(), mesh.triangles.size());
  EXPECT_EQ(std::ranges::count(stable, 1), mesh.triangles.size());
}

/// Tetrahedra that cross, with copies of some of their faces: of the same corners, or of twins.
TriMesh crossing_copies(std::mt19937& random) {
  const auto step = [&] { return static_cast<double>(random() % 3); };
  std::vector<TriMesh> shells;
  for (int i = 0; i < 6; ++i) {
    shells.push_back(test::tetrahedron(Vec3(step(), step(), step()) / 4, 1));
  }
  TriMesh mesh = test::joined(shells);
  for (int i = 0; i < 40; ++i) {
    Triangle copy = mesh.triangles[random() % mesh.triangles.size()];
    std::rotate(copy.begin(), copy.begin() + i % 3, copy.end());
    if (i % 5 == 0) {
      const Vec3 corner = mesh.points[copy[0]];
      mesh.points.push_back(corner);
      copy[0] = static_cast<std::uint32_t>(mesh.points.size() - 1);
    }
    mesh.triangles.push_back(copy);
  }
  return mesh;
}

TEST(Inspection, counts_the_crossings_of_each_copy) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    const TriMesh mesh = crossing_copies(random);
    const auto places = [&](std::uint32_t face) {
      std::array<std::array<double, 3>, 3> corners;
      std::ranges::transform(mesh.triangles[face], corners.begin(), [&](std::uint32_t v) {
        return std::array{mesh.points[v].x(), mesh.points[v].y(), mesh.points[v].z()};
      });
      std::ranges::sort(corners);
      return corners;
    };
    auto expected = find_self_intersections(mesh.points, mesh.triangles).pairs;
    std::erase_if(expected, [&](const FacePair& p) {
      return p.kind == FacePair::Kind::contact || places(p.first) == places(p.second);
    });
    ASSERT_GT(expected.size(), 20U);
    for (const std::size_t limit : {std::size_t{7}, std::size_t{100000}}) {
      const Report report = check(mesh, {.limit = limit});
      EXPECT_EQ(report.count(Defect::self_intersection), expected.size());
      std::vector<std::vector<std::uint32_t>> listed, lowest;
      for (const Finding& finding : report.findings) {
        if (finding.defect == Defect::self_intersection) {
          listed.push_back(finding.faces);
        }
      }
      for (std::size_t i = 0; i < std::min(limit, expected.size()); ++i) {
        lowest.push_back({expected[i].first, expected[i].second});
      }
      EXPECT_EQ(listed, lowest);
    }
  }
}

TEST(Inspection, of_thousands_of_copies_takes_a_moment) {
  const Report report = check(test::joined(std::vector(20000, test::tetrahedron(Vec3::Zero(), 1))));
  EXPECT_EQ(report.count(Defect::duplicate_face), 4U);
  EXPECT_EQ(report.count(Defect::self_intersection), 0U);
}

}  // namespace
}  // namespace dupin::checking
