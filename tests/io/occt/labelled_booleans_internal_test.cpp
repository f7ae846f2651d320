#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/occt/body_shapes_internal.h"
#include "occt/body_shape.h"
#include "occt/labelled_booleans.h"

namespace dupin::occt {
namespace {

TEST(LabelledBooleans, add_up) {
  const std::vector<LabelledShape> all = {solid_of(bent_pipe()), solid_of(branch())};
  const LabelledShape &a = all[0], &b = all[1];
  const double both = volume(fused(all, "both", "both").shape);
  const double common = volume(combined(a, b, exchange::Operation::intersect).shape);
  const double rest = volume(combined(a, b, exchange::Operation::subtract).shape);
  EXPECT_NEAR(both + common, volume(a.shape) + volume(b.shape), 1e-4);
  EXPECT_NEAR(rest + common, volume(a.shape), 1e-4);
  EXPECT_GT(common, 0);
}

TEST(LabelledBooleans, say_what_does_not_meet) {
  const std::vector<LabelledShape> pieces = {solid_of(bent_pipe()), LabelledShape()};
  try {
    (void)fused(pieces, "chain", "its own pieces");
    ADD_FAILURE() << "not refused";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.at(), "chain");
    EXPECT_THAT(refusal.what(),
                testing::StartsWith("OpenCASCADE does not find where its own pieces meet: "));
  }
}

}  // namespace
}  // namespace dupin::occt
