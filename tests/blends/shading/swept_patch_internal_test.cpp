#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "shading/swept_patch.h"
#include "support/paper_surfaces.h"
#include "support/source_folder.h"

namespace dupin::shading {
namespace {

struct OnSurface {
  Vec3 point, normal;
};

OnSurface on_surface(const SectionFamily& family, double t, double angle) {
  const Section section = family.section(t);
  const Vec3 first = section.normal.unitOrthogonal();
  const Vec3 direction = std::cos(angle) * first + std::sin(angle) * section.normal.cross(first);
  return {section.center + section.radius(direction) * direction, family.normal(t, direction)};
}

// Places along the normal of a point of the surface have that point for their nearest.
void expect_feet(const SectionFamily& family, double off, const std::string& what) {
  const SweptPatch patch(family);
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j < 9; ++j) {
      const auto [point, normal] = on_surface(family, i / 40., 0.7 * j);
      const std::optional<Foot> exact = patch.foot(point);
      ASSERT_TRUE(exact) << what;
      EXPECT_LT(exact->distance, 3e-8) << what << " " << i << " " << j;
      EXPECT_LT((exact->normal - normal).norm(), 1e-8) << what << " " << i << " " << j;
      const std::optional<Foot> rough = patch.rough_foot(point);
      ASSERT_TRUE(rough) << what;
      EXPECT_LT(rough->distance, 1e-4) << what << " " << i << " " << j;
      EXPECT_LT((rough->normal - normal).norm(), 0.05) << what << " " << i << " " << j;
      EXPECT_TRUE(patch.box().contains(point)) << what;
      if (i > 0 && i < 40) {
        const std::optional<Foot> above = patch.foot(point + off * normal);
        ASSERT_TRUE(above) << what;
        EXPECT_NEAR(above->distance, off, 1e-7) << what << " " << i << " " << j;
        EXPECT_LT((above->normal - normal).norm(), 1e-5) << what << " " << i << " " << j;
      }
    }
  }
}

TEST(SweptPatch, finds_the_points_of_all_kinds_of_pieces) {
  for (const char* name : {"reducer", "skew-pipes", "oblique-nozzle", "oval-duct", "u-bend-cyclide",
                           "cone-to-pipe", "crane-hook"}) {
    const ResolvedAssembly resolved =
        resolve(read_assembly(test::source_folder() / "examples" / (std::string(name) + ".json")));
    for (const ResolvedPart& part : resolved.parts) {
      for (const Piece& piece : std::get<Chain>(part.shape).pieces) {
        expect_feet(section_family(piece), 0.01, std::string(name) + " " + part.name);
      }
    }
  }
}

TEST(SweptPatch, of_a_u_bend_is_not_deceived_by_the_other_arm) {
  const RingedSurface bend{{{4, 0, 0}, {0, -1, 0}, 1, 0},
                           {{-4, 0, 0}, {0, -1, 0}, 1, 0},
                           ArcSpine{{0, 0, 0}, {0, 0, 1}, {4, 0, 0}, std::numbers::pi},
                           ConstantRadius{1}};
  const SweptPatch patch(section_family(bend));
  for (const double angle : {0.3, 1.2, 2.9}) {
    for (const double off : {-0.1, 0.0, 0.1}) {
      const Vec3 away(std::cos(angle), std::sin(angle), 0);
      const auto inside = patch.foot((3 + off) * away);
      ASSERT_TRUE(inside);
      EXPECT_NEAR(inside->distance, std::abs(off), 1e-12);
      EXPECT_LT((inside->normal + away).norm(), 1e-12);
    }
  }
}

TEST(SweptPatch, beyond_its_ends_is_as_far_as_the_end) {
  const RingedSurface pipe{{{0, 0, 0}, {0, 0, -1}, 2, 0},
                           {{0, 0, 5}, {0, 0, 1}, 2, 0},
                           LineSpine{{0, 0, 0}, {0, 0, 5}},
                           ConstantRadius{2}};
  const SweptPatch patch(section_family(pipe));
  for (const double z : {-3.0, 8.0}) {
    const auto foot = patch.foot({0, 2, z});
    ASSERT_TRUE(foot);
    EXPECT_DOUBLE_EQ(foot->distance, 3);
    EXPECT_EQ(foot->normal, Vec3::UnitY());
  }
  EXPECT_FALSE(patch.foot({0, 0, 2}));  // no direction from the axis
  EXPECT_DOUBLE_EQ(patch.rough_foot({0, 2, 8})->distance, 3);
  EXPECT_FALSE(patch.rough_foot({0, 0, 2}));
}

TEST(SweptPatch, of_a_blend_is_found_by_the_law_of_ringed_surfaces) {
  expect_feet(section_family(Piece(test::figure6())), 1e-3, "figure 6");
  expect_feet(section_family(Piece(test::u_bend(CubicRadius{2, 4}))), 1e-3, "u-bend");
}

}  // namespace
}  // namespace dupin::shading
