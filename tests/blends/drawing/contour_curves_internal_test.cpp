#include <algorithm>

#include <gtest/gtest.h>

#include "drawing/contour_curves.h"
#include "dupin/io/assembly_json.h"
#include "support/source_folder.h"

namespace dupin::drawing {
namespace {

const Vec3 kUp = Vec3::UnitZ();

ResolvedAssembly example(const std::string& name) {
  return resolve(read_assembly(test::source_folder() / "examples" / (name + ".json")));
}

TEST(ContourCurves, are_of_parts_fillets_and_hubs) {
  const ResolvedAssembly tee = example("tee"), junction = example("junction");
  EXPECT_EQ(contours_of(tee, kUp, 0.1, false).size(), tee.parts.size() + 1);
  const auto of_junction = contours_of(junction, kUp, 0.1, false);
  EXPECT_EQ(of_junction.back().part, junction.junctions[0].name);
  EXPECT_EQ(of_junction.back().curves.size(), 1);
}

TEST(ContourCurves, of_bores_have_their_normals_turned) {
  const ResolvedAssembly assembly = example("reducer");
  const auto outer = contours_of(assembly, kUp, 0.1, false),
             bore = contours_of(assembly, kUp, 0.1, true);
  ASSERT_EQ(outer.size(), bore.size());
  ASSERT_FALSE(outer[0].curves.empty());
  EXPECT_EQ(outer[0].curves[0][0].normal, -bore[0].curves[0][0].normal);
  EXPECT_EQ(outer[0].curves[0][0].position, bore[0].curves[0][0].position);
}

// Where pieces meet in balls, these have contours too.
TEST(ContourCurves, of_spherical_joints_are_great_circles) {
  const ResolvedAssembly arm = example("ucct-arm");
  for (const ResolvedPart& part : arm.parts) {
    const auto* chain = std::get_if<Chain>(&part.shape);
    if (chain != nullptr && chain->joints == Joints::spherical) {
      const auto curves = contours_of(part.shape, kUp, 1e-3);
      const auto circles = std::ranges::count_if(curves, [](const ZeroLine& curve) {
        return curve.front().position == curve.back().position;
      });
      EXPECT_EQ(std::size_t(circles), chain->pieces.size() - 1);
      return;
    }
  }
  FAIL() << "the example has no such joint";
}

}  // namespace
}  // namespace dupin::drawing
