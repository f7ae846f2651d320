#include <gtest/gtest.h>

#include "drawing/center_lines.h"

namespace dupin::drawing {
namespace {

ResolvedPart part(PartSurface shape) {
  ResolvedPart result;
  result.name = "part";
  result.shape = std::move(shape);
  return result;
}

TEST(CenterLines, run_along_spines) {
  ResolvedAssembly assembly;
  const double quarter = 2 * std::atan(1.0);
  assembly.parts = {part(Chain(RingedSurface{{{0, 0, 0}, -Vec3::UnitZ(), 1},
                                             {{0, 0, 5}, Vec3::UnitZ(), 1},
                                             LineSpine{{0, 0, 0}, {0, 0, 5}},
                                             ConstantRadius{1}})),
                    part(Chain(RingedSurface{{{0, 0, 5}, -Vec3::UnitZ(), 1},
                                             {{3, 0, 8}, Vec3::UnitX(), 1},
                                             ArcSpine{{3, 0, 5}, Vec3::UnitY(), {0, 0, 5}, quarter},
                                             ConstantRadius{1}})),
                    part(Sphere{{1, 2, 3}, 4})};
  const auto axes = axes_of(assembly, 0.01);
  ASSERT_EQ(axes.size(), 3U);
  EXPECT_EQ(axes[0].line, (std::vector<Vec3>{{0, 0, 0}, {0, 0, 5}}));
  EXPECT_GT(axes[1].line.size(), 4U);
  for (const Vec3& point : axes[1].line) {
    EXPECT_NEAR((point - Vec3(3, 0, 5)).norm(), 3, 1e-12);
  }
  EXPECT_EQ(axes[2].line.size(), 1U);
  EXPECT_EQ(axes[2].diameters, std::vector<double>{8});
}

}  // namespace
}  // namespace dupin::drawing
