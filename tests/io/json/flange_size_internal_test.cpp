#include <gtest/gtest.h>

#include "json/flange_size.h"

namespace dupin::json {
namespace {

TEST(FlangeSize, of_classes_grows_with_the_size) {
  for (const char* pressure_class : {"150", "300"}) {
    double outside = 0, thickness = 0;
    int count = 0;
    for (double inches = 0.5; inches <= 24; inches += 0.25) {
      if (const auto flange = flange_of(inches, pressure_class)) {
        EXPECT_GT(flange->outside, outside) << inches;
        EXPECT_GE(flange->thickness, thickness) << inches;
        outside = flange->outside;
        thickness = flange->thickness;
        ++count;
      }
    }
    EXPECT_EQ(count, 20);
  }
  EXPECT_EQ(flange_of(8, "150")->outside, 345);
  EXPECT_EQ(flange_of(8, "300")->outside, 380);
  EXPECT_FALSE(flange_of(22, "150"));
  EXPECT_FALSE(flange_of(8, "600"));
}

}  // namespace
}  // namespace dupin::json
