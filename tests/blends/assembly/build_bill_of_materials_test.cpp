#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using std::numbers::pi;

Assembly document(const std::string& parts, const std::string& wall = {}) {
  return parse_assembly(
      R"({"units": "mm", "tolerance": 0.01, )" + wall + R"("parts": [)" + parts + "]}", "test");
}

constexpr const char* kLine = R"(
  {"name": "a", "pipe": {"from": [0, 0, 0], "to": [0, 0, 50], "radius": 5}},
  {"name": "b", "elbow": {"from": "a.end", "bend_radius": 15, "angle": 90, "toward": [1, 0, 0]}},
  {"name": "c", "cone": {"from": "b.end", "length": 10, "end_radius": 4}})";

TEST(BillOfMaterials, says_what_a_line_measures) {
  const BillOfMaterials bill = bill_of_materials(document(kLine));
  ASSERT_EQ(bill.rows.size(), 3U);
  const auto& [a, b, c] = std::tie(bill.rows[0], bill.rows[1], bill.rows[2]);
  EXPECT_EQ(a.kind, "pipe");
  EXPECT_NEAR(*a.length, 50, 1e-12);
  EXPECT_FALSE(a.bend_radius.has_value());
  EXPECT_EQ(a.sizes, (std::vector<EndSize>{{10, 10}, {10, 10}}));
  EXPECT_NEAR(*b.bend_radius, 15, 1e-12);
  EXPECT_NEAR(*b.bend_angle, pi / 2, 1e-15);
  EXPECT_NEAR(*b.length, 15 * pi / 2, 1e-12);
  EXPECT_EQ(c.sizes, (std::vector<EndSize>{{10, 10}, {8, 8}}));
  for (const BillRow& row : bill.rows) {
    EXPECT_EQ(row.metal->volume, row.outer->volume);
    EXPECT_FALSE(row.fluid.has_value());
    EXPECT_TRUE(row.remarks.empty());
  }
}

TEST(BillOfMaterials, of_a_head_has_all_of_its_surface) {
  const BillOfMaterials bill = bill_of_materials(document(R"(
      {"name": "a", "pipe": {"from": [0, 0, 0], "to": [0, 0, 50], "radius": 8}},
      {"name": "b", "head": {"from": "a.end", "form": "ellipsoidal"}})"));
  const double e = std::sqrt(1 - .25);  // half an oblate spheroid, twice as wide as high
  const double area = pi * 64 * (1 + (1 - e * e) / e * std::atanh(e));
  EXPECT_NEAR(*bill.rows.at(1).area / area, 1, 1e-9);
  EXPECT_NEAR(bill.rows.at(1).outer->volume, 2 * pi / 3 * 64 * 4, 1e-6);
}

TEST(BillOfMaterials, of_a_wall_subtracts_the_bore) {
  const BillOfMaterials bill = bill_of_materials(document(kLine, R"("wall": 1, )"));
  const BillRow &pipe = bill.rows[0], &elbow = bill.rows[1];
  EXPECT_EQ(pipe.wall, 1);
  EXPECT_NEAR(pipe.fluid->volume, pi * 16 * 50, 1e-9);
  EXPECT_NEAR(pipe.metal->volume, pi * 9 * 50, 1e-9);
  EXPECT_NEAR(elbow.fluid->volume, pi * 16 * 15 * pi / 2, 1e-9);
  // A hollow cylinder's moments, about its middle.
  EXPECT_NEAR(inertia(*pipe.metal)(2, 2), pi * 9 * 50 * (25 + 16) / 2., 1e-7);
}

// Parts that only meet: the built regions' volumes are the sums, up to the mesh.
TEST(BillOfMaterials, agrees_with_the_regions_that_are_built) {
  const Assembly line = document(kLine, R"("wall": 1, )");
  SolidMoments outer, metal, fluid;
  double area = 0;
  for (const BillRow& row : bill_of_materials(line).rows) {
    outer = outer + *row.outer;
    metal = metal + *row.metal;
    fluid = fluid + *row.fluid;
    area += *row.area;
  }
  const RegionVolumes built = *build(line).volumes;
  EXPECT_NEAR(built.outer, outer.volume, line.tolerance * area);
  EXPECT_NEAR(built.fluid, fluid.volume, line.tolerance * area);
  EXPECT_NEAR(built.metal, metal.volume, line.tolerance * area);
}

TEST(BillOfMaterials, has_one_row_for_a_junction_and_its_arms) {
  for (const char* wall : {"", R"("wall": 0.2, )"}) {
    const Assembly assembly = document(R"(
      {"name": "x", "pipe": {"from": [9, 0, 0], "to": [6, 0, 0], "radius": 1}},
      {"name": "y", "pipe": {"from": [0, 9, 0], "to": [0, 6, 0], "radius": 1}},
      {"name": "z", "pipe": {"from": [0, 0, 9], "to": [0, 0, 6], "radius": 1}},
      {"name": "j", "junction": {"ends": ["x.end", "y.end", "z.end"]}})",
                                       wall);
    const BillOfMaterials bill = bill_of_materials(assembly);
    ASSERT_EQ(bill.rows.size(), 4U);
    EXPECT_EQ(bill.rows[3].kind, "junction");
    EXPECT_EQ(bill.rows[3].sizes.size(), 3U);
    SolidMoments metal;
    for (const BillRow& row : bill.rows) {
      metal = metal + *row.metal;
    }
    const double built = build(assembly).solid.volume();
    EXPECT_NEAR(built, metal.volume, 0.01 * metal.volume);
    EXPECT_NEAR(metal.centroid.x(), metal.centroid.y(), 1e-9);
    EXPECT_NEAR(metal.centroid.y(), metal.centroid.z(), 1e-9);
  }
}

TEST(BillOfMaterials, says_what_it_does_not_compute) {
  const BillOfMaterials bill = bill_of_materials(document(R"(
    {"name": "run", "pipe": {"from": [-9, 0, 0], "to": [9, 0, 0], "radius": 3}},
    {"name": "branch", "pipe": {"from": [0, 0, 0], "to": [0, 0, 9], "radius": 1}},
    {"name": "f", "fillet": {"between": ["run", "branch"], "radius": 0.5}})"));
  ASSERT_EQ(bill.rows.size(), 3U);
  EXPECT_EQ(bill.rows[1].remarks,
            std::vector<std::string>{"its start lies inside another part and is not trimmed here"});
  EXPECT_FALSE(bill.rows[2].outer.has_value());
  EXPECT_FALSE(bill.rows[2].area.has_value());
  EXPECT_EQ(bill.rows[2].remarks.size(), 1U);
}

TEST(BillOfMaterials, refuses_what_build_refuses) {
  try {
    (void)bill_of_materials(document(kLine, R"("wall": 4, )"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "c");
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
  }
}

}  // namespace
}  // namespace dupin
