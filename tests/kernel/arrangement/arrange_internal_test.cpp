#include <atomic>
#include <thread>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "arrangement/arrange.h"
#include "dupin/kernel/error.h"
#include "kernel/arrangement/stages_internal.h"
#include "support/pipe_cases.h"

namespace dupin::arrangement {
namespace {

using test::box;
using test::cube;
using test::moved;
using test::tetrahedron;
using test::tube;

Solid arranged(const std::vector<TriMesh>& meshes, const BooleanRule& rule) {
  return test::arranged(test::solids_of(meshes), rule);
}

struct Expected {
  const char* volume;
  std::size_t components, shells;
  std::int64_t genus;
  std::size_t contacts;
};

struct Case {
  const char* name;
  std::vector<TriMesh> operands;
  Expected united, common, difference;
};

void expect(const Solid& solid, const Expected& expected, const char* what) {
  SCOPED_TRACE(what);
  EXPECT_EQ(solid.exact_volume(), mpq_class(expected.volume));
  EXPECT_EQ(solid.components(), expected.components);
  EXPECT_EQ(solid.shells(), expected.shells);
  EXPECT_EQ(solid.genus(), expected.genus);
  EXPECT_EQ(solid.contacts().size(), expected.contacts);
}

class Arrangement : public testing::TestWithParam<Case> {};

TEST_P(Arrangement, gives_the_expected_solids) {
  const Case& c = GetParam();
  const std::size_t n = c.operands.size();
  expect(arranged(c.operands, union_rule(n)), c.united, "union");
  expect(arranged(c.operands, intersection_rule(n)), c.common, "intersection");
  expect(arranged(c.operands, difference_rule(n)), c.difference, "difference");
}

const Expected kNothing{"0", 0, 0, 0, 0};

INSTANTIATE_TEST_SUITE_P(
    Pairs, Arrangement,
    testing::Values(
        Case{"apart",
             {cube(0, 0, 0), cube(5, 0, 0)},
             {"16", 2, 2, 0, 0},
             kNothing,
             {"8", 1, 1, 0, 0}},
        Case{"generic",
             {cube(0, 0, 0), cube(1, 1, 1)},
             {"15", 1, 1, 0, 0},
             {"1", 1, 1, 0, 0},
             {"7", 1, 1, 0, 0}},
        Case{
            "same", {cube(0, 0, 0), cube(0, 0, 0)}, {"8", 1, 1, 0, 0}, {"8", 1, 1, 0, 0}, kNothing},
        Case{"nested",
             {cube(0, 0, 0, 4), cube(1, 1, 1)},
             {"64", 1, 1, 0, 0},
             {"8", 1, 1, 0, 0},
             {"56", 1, 2, 0, 0}},
        Case{"whole_face",
             {cube(0, 0, 0), cube(2, 0, 0)},
             {"16", 1, 1, 0, 0},
             kNothing,
             {"8", 1, 1, 0, 0}},
        Case{"part_of_a_face",
             {cube(0, 0, 0, 4), cube(4, 1, 1)},
             {"72", 1, 1, 0, 0},
             kNothing,
             {"64", 1, 1, 0, 0}},
        Case{"flush_inside",
             {cube(0, 0, 0, 4), cube(2, 1, 1)},
             {"64", 1, 1, 0, 0},
             {"8", 1, 1, 0, 0},
             {"56", 1, 1, 0, 0}},
        Case{"flush_corner",
             {cube(0, 0, 0, 4), cube(0, 0, 0)},
             {"64", 1, 1, 0, 0},
             {"8", 1, 1, 0, 0},
             {"56", 1, 1, 0, 0}},
        Case{"shifted_along_faces",
             {cube(0, 0, 0), cube(1, 0, 0)},
             {"12", 1, 1, 0, 0},
             {"4", 1, 1, 0, 0},
             {"4", 1, 1, 0, 0}},
        Case{"edge",
             {cube(0, 0, 0), cube(2, 2, 0)},
             {"16", 2, 2, 0, 1},
             kNothing,
             {"8", 1, 1, 0, 0}},
        Case{"part_of_an_edge",
             {cube(0, 0, 0), cube(2, 2, 1)},
             {"16", 2, 2, 0, 1},
             kNothing,
             {"8", 1, 1, 0, 0}},
        Case{"vertex",
             {cube(0, 0, 0), cube(2, 2, 2)},
             {"16", 2, 2, 0, 1},
             kNothing,
             {"8", 1, 1, 0, 0}},
        Case{"vertex_on_face",
             {box({0, 0, -2}, {4, 4, 0}), tetrahedron({1, 1, 0})},
             {"193/6", 1, 1, 0, 0},
             kNothing,
             {"32", 1, 1, 0, 0}},
        Case{"through",
             {box({0, 0, 0}, {6, 6, 2}), box({2, 2, -1}, {4, 4, 3})},
             {"80", 1, 1, 0, 0},
             {"8", 1, 1, 0, 0},
             {"64", 1, 1, 1, 0}},
        Case{"flush_through",
             {box({0, 0, 0}, {6, 6, 2}), box({2, 2, 0}, {4, 4, 2})},
             {"72", 1, 1, 0, 0},
             {"8", 1, 1, 0, 0},
             {"64", 1, 1, 1, 0}}),
    [](const auto& test_case) { return std::string(test_case.param.name); });

// Arrangements round upward, in a thread whose first parallel loop may be theirs.
TEST(Arrange, leaves_the_rounding_of_later_tasks_alone) {
  const std::vector<Solid> solids = test::solids_of({cube(0, 0, 0), cube(1, 1, 1)});
  const volatile double one = 1, tiny = 0x1p-60;
  std::atomic<int> rounded_up = 0;
  std::thread([&] {
    (void)test::arranged(solids, union_rule(2));
    tbb::parallel_for(0, 1000, [&](int) { rounded_up += one + tiny > 1 ? 1 : 0; });
  }).join();
  EXPECT_EQ(rounded_up, 0);
}

mesh::ExactMesh surface_of(const std::vector<TriMesh>& meshes) {
  const TriMesh all = test::joined(meshes);
  mesh::ExactMesh surface;
  surface.points = all.points;
  surface.triangles = all.triangles;
  for (std::uint32_t t = 0; t < all.triangles.size(); ++t) {
    surface.sources.push_back({0, t});
  }
  return surface;
}

Solid solid_of(mesh::ExactMesh mesh) {
  return Solid(std::make_shared<const mesh::ExactMesh>(std::move(mesh)));
}

TEST(UnitedWithWinding, adds_what_the_surface_winds_around_and_takes_nothing_away) {
  const Solid solid = Solid::from(cube(0, 0, 0));
  // Two boxes that cross each other and the solid, one on a face of it, and a hole in it.
  const mesh::ExactMesh surface =
      surface_of({box(Vec3(1, 0.5, 0.5), Vec3(4, 1.5, 1.5)), box(Vec3(3, 0, 1), Vec3(5, 1, 3)),
                  box(Vec3(0.5, 0.5, 2), Vec3(1, 1, 3)),
                  test::reversed(box(Vec3(0.25, 0.25, 0.25), Vec3(0.5, 0.5, 0.5)))});
  const Solid all = solid_of(united_with_winding(solid.exact(), surface));
  // 8, and 2 x 1 x 1 of the first box, and 2 x 1 x 2 less 1 x 0.5 x 0.5, and 0.25.
  EXPECT_EQ(all.exact_volume(), mpq_class("14") - mpq_class("1/4") + mpq_class("1/4"));
  EXPECT_EQ(all.components(), 1);
  EXPECT_EQ(all.shells(), 1);
}

// Outside of the solid's bounds, where no other operand has points that could be the same.
TEST(UnitedWithWinding, welds_the_surface_with_itself) {
  const Solid solid = Solid::from(cube(0, 0, 0));
  const mesh::ExactMesh surface =
      surface_of({box(Vec3(10, 10, 10), Vec3(11, 11, 12)), box(Vec3(10, 10, 10), Vec3(12, 12, 11)),
                  box(Vec3(10, 10, 11), Vec3(12, 11, 12))});
  const Solid all = solid_of(united_with_winding(solid.exact(), surface));
  EXPECT_EQ(all.exact_volume(), solid.exact_volume() + 6);
  EXPECT_EQ(all.components(), 2);
}

TEST(PositiveWindingBoundary, looks_for_crossings_where_it_is_told_only) {
  const mesh::ExactMesh surface =
      surface_of({box(Vec3(0, 0, 0), Vec3(2, 2, 2)), box(Vec3(1, 1, 1), Vec3(3, 3, 3)),
                  box(Vec3(8, 0, 0), Vec3(9, 1, 1))});
  std::vector<std::uint8_t> crossing(36, 1);
  std::fill(crossing.begin() + 24, crossing.end(), 0);
  const mesh::ExactMesh all = positive_winding_boundary(surface);
  const mesh::ExactMesh told = wound_surface(surface, crossing).boundary;
  EXPECT_EQ(told.points, all.points);
  EXPECT_EQ(told.triangles, all.triangles);
  EXPECT_EQ(solid_of(told).exact_volume(), 16);
  EXPECT_EQ(wound_surface(surface, std::vector<std::uint8_t>(36, 0)).boundary.triangles,
            surface.triangles)
      << "nothing is cut";
}

TEST(Arrange, more_points_than_indices_are_refused) {
  const Solid tube = Solid::from(test::tube(1, 0, 1, 4096));
  // Copies of an operand share their coordinates, so this takes no memory to speak of.
  const std::vector<const mesh::ExactMesh*> copies(
      (std::size_t{1} << 31) / tube.triangle_count() + 1, &tube.exact());
  constexpr std::uint64_t kPlenty = std::uint64_t{1} << 62;
  try {
    (void)arrange(copies, union_rule(copies.size()), {}, kPlenty);
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    EXPECT_THAT(error.what(),
                testing::HasSubstr("a boolean operation takes fewer than 2147483648 of each"));
  }
}

// A few of them tell, before all are searched.
TEST(ArrangeUnlessCrowded, gives_up_without_a_search_where_all_meet_each_other) {
  const auto searched = [](const char* name) {
    const std::vector<Solid> solids = test::solids_of(test::pipe_case(name));
    std::vector<const mesh::ExactMesh*> meshes;
    for (const Solid& solid : solids) {
      meshes.push_back(&solid.exact());
    }
    int told = 0;
    const auto result = arrange_unless_crowded(meshes, union_rule(meshes.size()),
                                               [&told](std::string_view, double) {
                                                 ++told;
                                                 return true;
                                               });
    return std::pair(told > 0, result.has_value());
  };
  EXPECT_EQ(searched("star_14"), std::pair(false, false));
  EXPECT_EQ(searched("coaxial_14_rot"), std::pair(false, false));
  EXPECT_EQ(searched("header_10_rot"), std::pair(true, true));
  EXPECT_EQ(searched("coaxial_8"), std::pair(true, false)) << "by what the search has found";
}

}  // namespace
}  // namespace dupin::arrangement
