#include <gtest/gtest.h>

#include "pcf/wall_schedule.h"

namespace dupin::pcf {
namespace {

double wall(double inches, std::string_view schedule) {
  return wall_of(*called(inches, BoreUnit::inch), schedule).value_or(0);
}

TEST(WallSchedule, has_what_everybody_knows) {
  EXPECT_EQ(wall(0.5, "40"), 2.77);
  EXPECT_EQ(wall(2, "80"), 5.54);
  EXPECT_EQ(wall(4, "STD"), 6.02);
  EXPECT_EQ(wall(6, "xs"), 10.97);
  EXPECT_EQ(wall(8, "XXS"), 22.23);  // thinner than 160
  EXPECT_EQ(wall(12, "std"), 9.53);
  EXPECT_EQ(wall(24, "160"), 59.54);
  EXPECT_EQ(wall(3.5, "160"), 0);
  EXPECT_EQ(wall(30, "40"), 0);
  EXPECT_EQ(wall(4, "41"), 0);
  EXPECT_FALSE(is_schedule("41"));
  EXPECT_TRUE(is_schedule("Xxs"));
}

// Numbered schedules grow, STD and XS are no thicker than 40 and 80, and all leave a bore.
TEST(WallSchedule, grows_from_schedule_to_schedule) {
  for (const NominalPipe& pipe : nominal_pipes()) {
    double last = 0;
    for (const std::string_view schedule :
         {"5", "10", "20", "30", "40", "60", "80", "100", "120", "140", "160"}) {
      const double own = wall(pipe.inches, schedule);
      if (own > 0) {
        EXPECT_GT(own, last) << pipe.inches << " " << schedule;
        EXPECT_LT(own, pipe.outside / 2) << pipe.inches << " " << schedule;
        last = own;
      }
    }
    if (wall(pipe.inches, "40") > 0) {
      EXPECT_LE(wall(pipe.inches, "STD"), wall(pipe.inches, "40"));
      EXPECT_EQ(wall(pipe.inches, "STD") == wall(pipe.inches, "40"), pipe.inches <= 10);
      EXPECT_EQ(wall(pipe.inches, "XS") == wall(pipe.inches, "80"), pipe.inches <= 8);
    }
  }
}

// Within a schedule walls are no thinner for larger sizes.
TEST(WallSchedule, grows_from_size_to_size) {
  for (const std::string_view schedule :
       {"5", "10", "20", "40", "60", "80", "100", "120", "140", "160", "STD", "XS", "XXS"}) {
    double last = 0;
    for (const NominalPipe& pipe : nominal_pipes()) {
      if (const double own = wall(pipe.inches, schedule); own > 0) {
        EXPECT_GE(own, last) << pipe.inches << " " << schedule;
        last = own;
      }
    }
  }
}

}  // namespace
}  // namespace dupin::pcf
