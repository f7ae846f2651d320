#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"

namespace dupin {
namespace {

Assembly bend_and_pipe() {
  return parse_assembly(R"({"units": "mm", "tolerance": 0.1, "parts": [
      {"name": "run", "pipe": {"from": [0, 0, -5], "to": [0, 0, 0], "radius": 1}},
      {"name": "bend", "elbow": {"from": "run.end", "bend_radius": 3, "angle": 90, "toward": [1, 0, 0]}}]})");
}

TEST(MarginPlaces, lie_on_the_axis_of_their_part) {
  const auto places = margin_places(bend_and_pipe());
  ASSERT_EQ(places.size(), 2);
  EXPECT_EQ(places[0].part, "run");
  EXPECT_EQ(places[1].part, "bend");
  EXPECT_NEAR((places[1].center - Vec3(3, 0, 0)).norm(), 3, 1e-9);
  for (const MarginPlace& place : places) {
    EXPECT_NEAR(place.radius, 1, 1e-9);
    EXPECT_GE(place.parameter, 0);
    EXPECT_LE(place.parameter, 1);
  }
}

}  // namespace
}  // namespace dupin
