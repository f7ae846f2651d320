#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/solid.h"
#include "rounding/open_slits.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr double kStep = 0x1p-10;

/// Two boxes one above the other, the upper one as wide as the lower one less `inset` on all sides,
/// the bottom of it from `gap` to `gap + tilt` above the lower one's top.
Solid boxes(double gap, double tilt, double inset = 1) {
  TriMesh upper = test::box(Vec3(inset, inset, 4 + gap), Vec3(8 - inset, 8 - inset, 8));
  for (Vec3& point : upper.points) {
    point.z() += point.z() < 7 && point.x() > 4 ? tilt : 0;
  }
  return Solid::from(test::joined({test::box(Vec3(0, 0, 0), Vec3(8, 8, 4)), upper}));
}

/// All pairs of triangles of different boxes, as if rounding made them cross.
std::vector<Fault> all_pairs(const Solid& solid) {
  std::vector<Fault> faults;
  for (std::uint32_t f = 0; f < 12; ++f) {
    for (std::uint32_t g = 12; g < solid.triangle_count(); ++g) {
      faults.push_back({f, g});
    }
  }
  return faults;
}

Solid solid(mesh::ExactMesh mesh) {
  return Solid(std::make_shared<const mesh::ExactMesh>(std::move(mesh)));
}

TEST(OpenSlits, between_parallel_ends_are_closed_exactly) {
  const Solid apart = boxes(kStep, 0);
  EXPECT_EQ(apart.components(), 2);
  const auto filled = fill_open_slits(apart.exact(), all_pairs(apart), kStep, 16 * kStep);
  ASSERT_TRUE(filled);
  EXPECT_THAT(filled->places, SizeIs(1));
  EXPECT_EQ(filled->reach, (1 + kSlitOverlap) * kStep);
  const Solid whole = solid(filled->mesh);
  EXPECT_EQ(whole.components(), 1);
  EXPECT_EQ(whole.genus(), 0);
  // The smaller one goes on to the other, with its own outline.
  EXPECT_EQ(whole.exact_volume(), apart.exact_volume() + mpq_class(36 * kStep));
  EXPECT_THAT(whole.contacts(), IsEmpty());
}

TEST(OpenSlits, that_are_wedges_are_closed_as_far_as_they_open) {
  const Solid apart = boxes(kStep, 8 * kStep);
  const auto filled = fill_open_slits(apart.exact(), all_pairs(apart), kStep, 16 * kStep);
  ASSERT_TRUE(filled);
  EXPECT_GE(filled->reach, (9 + kSlitOverlap) * kStep);
  EXPECT_LE(filled->reach, (10 + kSlitOverlap) * kStep);
  const Solid whole = solid(filled->mesh);
  EXPECT_EQ(whole.components(), 1);
  EXPECT_NEAR(whole.volume() - apart.volume(), 36 * 5 * kStep, 36 * kStep * 0x1p-4);
}

TEST(OpenSlits, are_filled_along_implicit_points_as_well) {
  // The end that is extended has corners at the cut of a slanted plane, which no double holds.
  const Solid part = boxes(kStep, 0);
  TriMesh cutter = test::tetrahedron(Vec3(0.3, 0.1, 3.9), 5.7);
  const Solid cut = subtract(part, std::vector{Solid::from(cutter)});
  ASSERT_FALSE(cut.exact().implicit.empty());
  std::vector<Fault> faults;
  for (std::uint32_t f = 0; f < cut.triangle_count(); ++f) {
    for (std::uint32_t g = f + 1; g < cut.triangle_count(); ++g) {
      faults.push_back({f, g});
    }
  }
  const auto filled = fill_open_slits(cut.exact(), faults, kStep, 16 * kStep);
  ASSERT_TRUE(filled);
  const Solid whole = solid(filled->mesh);
  EXPECT_EQ(whole.components(), 1);
  EXPECT_GT(whole.exact_volume(), cut.exact_volume());
  EXPECT_LT(whole.volume() - cut.volume(), 36 * kStep + 64 * kSlitOverlap * kStep);
}

TEST(OpenSlits, are_between_triangles_that_face_each_other) {
  const Solid apart = boxes(kStep, 8 * kStep);
  const FacingTriangles facing(apart.exact(), kStep);
  std::vector<Fault> faults = all_pairs(apart);
  const auto of_all = fill_open_slits(apart.exact(), faults, kStep, 16 * kStep);
  std::erase_if(faults, [&](const Fault& fault) { return !facing(fault.second, fault.first); });
  // Of the upper box and the lower one, two triangles each of opposite sides; none of one box.
  EXPECT_THAT(faults, SizeIs(6 * 4));
  EXPECT_FALSE(facing(0, 1));
  const auto filled = fill_open_slits(apart.exact(), faults, kStep, 16 * kStep);
  ASSERT_TRUE(of_all && filled);
  EXPECT_EQ(filled->mesh.points, of_all->mesh.points);
  EXPECT_EQ(filled->mesh.triangles, of_all->mesh.triangles);
  // What is lower than a step shows its front to nobody.
  const FacingTriangles coarse(apart.exact(), 16);
  EXPECT_TRUE(std::ranges::none_of(
      faults, [&](const Fault& fault) { return coarse(fault.first, fault.second); }));
}

TEST(OpenSlits, wider_than_allowed_and_sheets_of_material_stay) {
  const Solid apart = boxes(32 * kStep, 0);
  EXPECT_FALSE(fill_open_slits(apart.exact(), all_pairs(apart), kStep, 16 * kStep));
  const Solid sheet = Solid::from(test::box(Vec3(0, 0, 0), Vec3(8, 8, kStep)));
  std::vector<Fault> faults;
  for (std::uint32_t f = 0; f < 12; ++f) {
    for (std::uint32_t g = f + 1; g < 12; ++g) {
      faults.push_back({f, g});
    }
  }
  EXPECT_FALSE(fill_open_slits(sheet.exact(), faults, kStep, 16 * kStep));
}

// A beam that lies on others is no end of a part: what faces each other is a small part of it.
TEST(OpenSlits, between_beams_that_cross_stay) {
  std::vector<TriMesh> beams = {test::box(Vec3(-40, 0, kStep), Vec3(40, 1, 1))};
  for (int i = -3; i < 4; ++i) {
    beams.push_back(test::box(Vec3(10 * i, -40, -1), Vec3(10 * i + 1, 40, 0)));
  }
  const Solid rack = Solid::from(test::joined(beams));
  EXPECT_FALSE(fill_open_slits(rack.exact(), all_pairs(rack), kStep, 16 * kStep));
}

TEST(OpenSlits, keep_names_and_sources) {
  const Solid apart = Solid::from(
      test::joined({test::labelled(test::box(Vec3(0, 0, 0), Vec3(8, 8, 4)), "low"),
                    test::labelled(test::box(Vec3(1, 1, 4 + kStep), Vec3(7, 7, 8)), "high")}));
  const auto filled = fill_open_slits(apart.exact(), all_pairs(apart), kStep, 16 * kStep);
  ASSERT_TRUE(filled);
  const Solid whole = solid(filled->mesh);
  EXPECT_THAT(whole.names(), testing::ElementsAre("low", "high"));
  for (std::size_t i = 0; i < whole.triangle_count(); ++i) {
    EXPECT_EQ(whole.sources()[i].operand, 0U);
    EXPECT_EQ(whole.labels()[i], whole.sources()[i].triangle < 12 ? 0U : 1U);
  }
}

}  // namespace
}  // namespace dupin::rounding
