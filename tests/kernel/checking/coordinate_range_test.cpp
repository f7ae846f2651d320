#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/coordinates.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/mesh_gap.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/simplify.h"
#include "dupin/kernel/solid.h"
#include "support/shapes.h"

// Coordinates from the smallest denormal to the largest double, alone and mixed, and everything
// that takes a mesh: either it computes with them, or it says which point is out of range.
namespace dupin {
namespace {

using test::box;
using ::testing::AllOf;
using ::testing::HasSubstr;

const std::vector<double>& sizes() {
  static const std::vector<double> table = {
      5e-324, 1e-310, 2.3e-308, 1e-200, 0x1p-345, 1e-90,  1e-61, 1e-60, 1e-59, 1e-45, 1e-30,  1e-12,
      1,      1e6,    1e18,     3.4e38, 1e39,     1.1e39, 1e80,  1e150, 1e200, 1e307, 8.9e307};
  return table;
}

TriMesh block(const Vec3& low, const Vec3& high) { return box(low, high); }

bool all_in_range(const TriMesh& mesh) {
  return std::ranges::all_of(mesh.points, [](const Vec3& p) { return is_in_range(p); });
}

// Done, or refused for the range.
void expect_refused_unless_in_range(const char* name, const std::vector<TriMesh>& meshes,
                                    const std::function<void()>& action) {
  SCOPED_TRACE(name);
  const bool is_allowed =
      std::ranges::all_of(meshes, [](const TriMesh& m) { return all_in_range(m); });
  try {
    action();
    EXPECT_TRUE(is_allowed) << "should have been refused";
  } catch (const Error& error) {
    EXPECT_FALSE(is_allowed) << error.what();
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    EXPECT_THAT(error.message(), AllOf(HasSubstr("point "), HasSubstr(" coordinate "),
                                       HasSubstr("must be 0 or from 1e-60 to 1e+39 in size")));
  }
}

TriMesh spoilt(TriMesh mesh) {
  mesh.triangles.push_back(mesh.triangles[0]);
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  return mesh;
}

void try_all(const TriMesh& a, const TriMesh& b) {
  const Report report = check(a);
  EXPECT_EQ(report.is_solid(), all_in_range(a));
  EXPECT_EQ(report.count(Defect::point_out_of_range) > 0, !all_in_range(a));
  EXPECT_TRUE(std::isfinite(report.volume) && std::isfinite(report.area));
  expect_refused_unless_in_range("Solid::from", {a}, [&] {
    const Solid solid = Solid::from(a);
    EXPECT_TRUE(std::isfinite(solid.volume()) && std::isfinite(solid.area()));
  });
  expect_refused_unless_in_range("unite", {a, b}, [&] {
    const Solid operands[] = {Solid::from(a), Solid::from(b)};
    const Solid both = unite(operands), common = intersect(operands);
    EXPECT_EQ(both.exact_volume() + common.exact_volume(),
              operands[0].exact_volume() + operands[1].exact_volume());
    for (const Coordinates coordinates : {Coordinates::binary64, Coordinates::binary32}) {
      try {
        const TriMesh written = to_mesh(both, coordinates).mesh();
        EXPECT_TRUE(all_in_range(written));
        const Report again = check(written);
        EXPECT_TRUE(again.is_solid())
            << (coordinates == Coordinates::binary64 ? "binary64: " : "binary32: ")
            << describe(again.findings[0], written);
      } catch (const Error& error) {  // floats cannot hold everything
        EXPECT_EQ(error.code(), Errc::unroundable) << error.what();
      }
    }
  });
  expect_refused_unless_in_range("repair", {a}, [&] {
    EXPECT_EQ(repair(spoilt(a)).solid.exact_volume(), Solid::from(a).exact_volume());
  });
  expect_refused_unless_in_range("measure_gaps", {a, b},
                                 [&] { (void)measure_gaps(a, b, {.connect = 1e-3}); });
  expect_refused_unless_in_range("simplify", {a}, [&] { (void)simplify(Solid::from(a), 1e-3); });
}

TEST(CoordinateRange, of_one_size) {
  for (const double size : sizes()) {
    SCOPED_TRACE(size);
    try_all(block({0, 0, 0}, {size, size, size}),
            block({-size, -size, -size}, {size / 2, size / 2, size / 2}));
  }
}

TEST(CoordinateRange, of_two_sizes) {
  for (const double small : sizes()) {
    for (const double large : sizes()) {
      if (small < large) {
        SCOPED_TRACE(std::to_string(std::log10(small)) + " beside " +
                     std::to_string(std::log10(large)));
        try_all(block({0, 0, 0}, {large, small, 1}), block({small, -1, 0}, {large, 1, large}));
        try_all(block({-small, -small, -small}, {small, small, small}),
                block({0, 0, 0}, {large, large, large}));
      }
    }
  }
}

TEST(CoordinateRange, is_told_with_point_and_coordinate) {
  TriMesh mesh = block({0, 0, 0}, {1, 1, 1});
  mesh.points[5].y() = -1e308;
  const Report report = check(mesh);
  ASSERT_EQ(report.count(Defect::point_out_of_range), 1U);
  EXPECT_EQ(describe(report.findings[0], mesh),
            "point 5 has the y coordinate -1e+308, which must be 0 or from 1e-60 to 1e+39 in size");
}

TEST(CoordinateRange, holds_all_of_binary32) {
  EXPECT_TRUE(is_in_range(static_cast<double>(std::numeric_limits<float>::denorm_min())));
  EXPECT_TRUE(is_in_range(static_cast<double>(std::numeric_limits<float>::max())));
  EXPECT_FALSE(is_in_range(std::numeric_limits<double>::quiet_NaN()));
}

// A soup with one far point, faces of which cross others.
TEST(CoordinateRange, of_crossing_faces) {
  for (const double far : sizes()) {
    TriMesh mesh = block({-1, -1, -1}, {1, 1, 1});
    mesh.points[3].x() = -far;
    mesh.points[6].z() = far;
    expect_refused_unless_in_range("repair", {mesh}, [&] { (void)repair(mesh); });
  }
}

}  // namespace
}  // namespace dupin
