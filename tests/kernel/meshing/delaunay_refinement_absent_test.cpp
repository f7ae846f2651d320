#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "dupin/kernel/fill.h"
#include "dupin/kernel/remesh.h"
#include "support/shapes.h"

namespace dupin {
namespace {

TEST(DelaunayRefinementAbsent, says_so) {
  EXPECT_FALSE(has_mesh_generator());
  const Solid box = Solid::from(test::box(Vec3::Zero(), Vec3(1, 1, 1)));
  for (const bool fills : {false, true}) {
    try {
      fills ? (void)fill(box, {.distance = 1}) : (void)remesh(box, {.distance = 1});
      FAIL() << "should have thrown";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      EXPECT_THAT(error.what(), testing::HasSubstr("DUPIN_MESHING=ON"));
    }
  }
}

}  // namespace
}  // namespace dupin
