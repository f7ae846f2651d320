#include <cstdlib>
#include <set>

#include <gtest/gtest.h>

#include "text/label_colour.h"

namespace dupin::text {
namespace {

TEST(LabelColour, tells_neighbours_apart_and_does_not_return) {
  std::set<Colour> seen;
  for (std::size_t label = 0; label < 64; ++label) {
    const Colour colour = label_colour(label), next = label_colour(label + 1);
    int difference = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      EXPECT_GE(colour[channel], 120);
      EXPECT_LE(colour[channel], 240);
      difference += std::abs(colour[channel] - next[channel]);
    }
    EXPECT_GE(difference, 100) << label;
    EXPECT_TRUE(seen.insert(colour).second) << label;
  }
}

TEST(LabelColour, is_written_in_hexadecimal) {
  EXPECT_EQ(colour_code({0, 10, 255}), "#000AFF");
  EXPECT_EQ(colour_code(label_colour(0)).size(), 7U);
}

}  // namespace
}  // namespace dupin::text
