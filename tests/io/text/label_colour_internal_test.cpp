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

TEST(LabelColour, is_read_in_hexadecimal) {
  EXPECT_EQ(colour_of_code("#000aFF"), (Colour{0, 10, 255}));
  for (const char* const text : {"", "#000aF", "000aFF0", "#000aFG", "#000aFF0", "#+00aFF"}) {
    EXPECT_FALSE(colour_of_code(text)) << text;
  }
}

TEST(LabelColour, of_a_part_is_that_of_its_patches_unless_they_have_their_own) {
  const auto colours =
      label_colours({"run", "tee", "run.start", "tee.bore.end", "tee.end"},
                    {{"tee", "#010203"}, {"tee.bore", "#040506"}, {"x", "#ffffff"}});
  EXPECT_EQ(colours[0], label_colour(0));
  EXPECT_EQ(colours[2], label_colour(0));
  EXPECT_EQ(colours[1], (Colour{1, 2, 3}));
  EXPECT_EQ(colours[3], (Colour{4, 5, 6}));
  EXPECT_EQ(colours[4], (Colour{1, 2, 3}));
}

}  // namespace
}  // namespace dupin::text
