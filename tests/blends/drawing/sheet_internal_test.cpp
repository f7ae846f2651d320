#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "drawing/sheet.h"
#include "dupin/io/assembly_json.h"
#include "support/source_folder.h"

namespace dupin::drawing {
namespace {

ResolvedAssembly example(const std::string& name) {
  return resolve(read_assembly(test::source_folder() / "examples" / (name + ".json")));
}

// Normals by the differences of points, which know nothing of closed forms.
void expect_normals_fit(const Sheet& sheet, const std::string& what) {
  constexpr double kStep = 1e-6;
  for (int i = 1; i < 12; ++i) {
    for (int j = 1; j < 12; ++j) {
      const double t = i / 12., v = j / 12.;
      const Vec3 along = sheet.at(t + kStep, v).position - sheet.at(t - kStep, v).position;
      const Vec3 around = sheet.at(t, v + kStep).position - sheet.at(t, v - kStep).position;
      const Vec3 across = along.cross(around).normalized(), normal = sheet.at(t, v).normal;
      EXPECT_NEAR(std::abs(across.dot(normal)), 1, 1e-7) << what << " " << t << " " << v;
    }
  }
}

TEST(Sheet, has_the_normals_of_its_points) {
  for (const char* name : {"reducer", "skew-pipes", "oblique-nozzle", "oval-duct", "u-bend-cyclide",
                           "cone-to-pipe", "jet-engine"}) {
    const ResolvedAssembly resolved = example(name);
    for (const ResolvedPart& part : resolved.parts) {
      const auto& chain = std::get<Chain>(part.shape);
      const std::vector<Sheet> sheets = sheets_of(chain);
      EXPECT_EQ(sheets.size(), chain.pieces.size());
      for (const Sheet& sheet : sheets) {
        expect_normals_fit(sheet, part.name);
        EXPECT_LT((sheet.at(0.3, 0).position - sheet.at(0.3, 1).position).norm(), 1e-9);
      }
    }
  }
}

TEST(Sheet, of_a_piece_begins_and_ends_in_its_rings) {
  const ResolvedAssembly resolved = example("skew-pipes");
  for (const ResolvedPart& part : resolved.parts) {
    const auto& chain = std::get<Chain>(part.shape);
    const Ring &start = end_ring(chain, End::start), &end = end_ring(chain, End::end);
    for (const double v : {0., .2, .7}) {
      EXPECT_NEAR((sheets_of(chain).front().at(0, v).position - start.center).norm(), start.radius,
                  1e-9);
      EXPECT_NEAR((sheets_of(chain).back().at(1, v).position - end.center).norm(), end.radius,
                  1e-9);
    }
  }
}

// From foot to foot, the normals those of the pipes there.
TEST(Sheet, of_a_fillet_ends_tangent_on_both_pipes) {
  const ResolvedAssembly resolved = example("tee");
  ASSERT_EQ(resolved.fillets.size(), 1);
  const Fillet& fillet = resolved.fillets[0].shape;
  for (const Sheet& sheet : sheets_of(fillet)) {
    expect_normals_fit(sheet, "fillet");
    for (int i = 0; i < 20; ++i) {
      const ContactArc arc = contact_arc(
          fillet.loops[0].quadrics, ball(fillet.loops[0], 2 * std::numbers::pi * (i / 20. - 0.5)));
      EXPECT_LT((sheet.at(i / 20., 0).normal - arc.normals[0]).norm(), 1e-9);
      EXPECT_LT((sheet.at(i / 20., 1).normal - arc.normals[1]).norm(), 1e-9);
      EXPECT_LT((sheet.at(i / 20., 1).position - arc.feet[1]).norm(), 1e-9);
    }
  }
}

TEST(Sheet, is_none_of_a_cope) {
  for (const ResolvedFillet& fillet : example("cope").fillets) {
    EXPECT_TRUE(fillet.shape.is_cope());
    EXPECT_TRUE(sheets_of(fillet.shape).empty());
  }
}

}  // namespace
}  // namespace dupin::drawing
