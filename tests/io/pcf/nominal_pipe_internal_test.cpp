#include <gtest/gtest.h>

#include "pcf/nominal_pipe.h"

namespace dupin::pcf {
namespace {

TEST(NominalPipe, grows_from_size_to_size) {
  const auto pipes = nominal_pipes();
  for (std::size_t i = 1; i < pipes.size(); ++i) {
    EXPECT_LT(pipes[i - 1].inches, pipes[i].inches);
    EXPECT_LT(pipes[i - 1].nominal, pipes[i].nominal);
    EXPECT_LT(pipes[i - 1].outside, pipes[i].outside);
  }
}

// ASME B36.10M: from 14 inches on the size is the outside diameter, before it is less.
TEST(NominalPipe, is_its_outside_diameter_from_14_inches_on) {
  for (const NominalPipe& pipe : nominal_pipes()) {
    if (pipe.inches >= 14) {
      EXPECT_NEAR(pipe.outside, pipe.inches * 25.4, .65) << pipe.inches;
    } else {
      EXPECT_GT(pipe.outside, pipe.inches * 25.4 + 5) << pipe.inches;
    }
    EXPECT_NEAR(pipe.nominal, pipe.inches * 25, .11 * pipe.inches * 25 + 2.9) << pipe.inches;
  }
}

TEST(NominalPipe, is_found_by_each_of_its_names) {
  for (const NominalPipe& pipe : nominal_pipes()) {
    EXPECT_EQ(called(pipe.inches, BoreUnit::inch), &pipe);
    EXPECT_EQ(called(pipe.nominal, BoreUnit::millimetre), &pipe);
    EXPECT_EQ(called(pipe.inches * 25.4, BoreUnit::millimetre), &pipe);
    EXPECT_EQ(of_outside(pipe.outside), &pipe);
  }
  EXPECT_EQ(called(102.375, BoreUnit::millimetre), nullptr);
  EXPECT_EQ(called(100, BoreUnit::inch), nullptr);
  EXPECT_EQ(of_outside(100), nullptr);
  EXPECT_EQ(of_outside(273.1)->nominal, 250);
}

}  // namespace
}  // namespace dupin::pcf
