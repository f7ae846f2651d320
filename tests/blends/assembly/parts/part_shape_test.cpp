#include "dupin/blends/part_shape.h"

#include <set>
#include <string_view>

#include <gtest/gtest.h>

namespace dupin {
namespace {

TEST(PartShape, every_shape_has_the_key_that_stands_for_it) {
  const Vec3 o = Vec3::Zero();
  EXPECT_EQ(kind(PipeBetween{o, o}), "pipe");
  EXPECT_EQ(kind(PipeAlong()), "pipe");
  EXPECT_EQ(kind(PipeTo{{}, o}), "pipe");
  EXPECT_EQ(kind(ConeBetween{o, o}), "cone");
  EXPECT_EQ(kind(ConeAlong()), "cone");
  EXPECT_EQ(kind(ObliqueBetween{o, o, o}), "oblique");
  EXPECT_EQ(kind(ElbowTurning()), "elbow");
  EXPECT_EQ(kind(ElbowTo{Place(), o}), "elbow");
  EXPECT_EQ(kind(ElbowCorner{Place(), o, o}), "elbow");
  EXPECT_EQ(kind(SphereAt()), "sphere");
  EXPECT_EQ(kind(SplineBetween()), "spline");
  EXPECT_EQ(kind(SplineRound()), "spline");
  EXPECT_EQ(kind(CyclicBlendBetween()), "cyclic_blend");
  EXPECT_EQ(kind(TwoConeBlendBetween()), "two_cone_blend");
  EXPECT_EQ(kind(RingedBlendBetween()), "ringed_blend");
  EXPECT_EQ(kind(CyclideBlendBetween()), "cyclide_blend");
  EXPECT_EQ(kind(CyclideChainThrough()), "cyclide_chain");
  EXPECT_EQ(kind(JunctionOfPorts()), "junction");
  EXPECT_EQ(kind(CapAt()), "cap");
}

TEST(PartShape, keys_have_different_names) {
  std::set<std::string_view> names;
  for (const KeyName& name : PartKeys::kNames) {
    EXPECT_TRUE(names.insert(name.view()).second) << name.view();
  }
}

}  // namespace
}  // namespace dupin
