#include "tiles/district_voids.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/kernel/boolean.h"
#include "support/shapes.h"

namespace dupin::cli {
namespace {

using testing::ElementsAre;

const Vec3 kOrigin(0, 0, 1024);

// What is around a void from (1, 1, 1) to (9, 9, 9), in a box that is not in the void's way.
Rounded room() {
  const Vec3 less = -kOrigin;
  const Solid solid =
      subtract(Solid::from(test::box(kOrigin, kOrigin + Vec3(10, 10, 10))),
               std::vector{Solid::from(test::box(kOrigin + Vec3(1, 1, 1), Vec3(9, 9, 9) - less))});
  return to_mesh(solid, Coordinates::binary64,
                 {.origin = {.choice = Origin::Choice::given, .place = kOrigin}});
}

std::vector<Boxes> boxes_around(const std::vector<Vec3>& places) {
  std::vector<Boxes> boxes(1);  // the room's, which are not asked for
  for (const Vec3& place : places) {
    const Vec3 own = place + kOrigin;
    boxes.push_back({{Vec3(own.array() - .125), Vec3(own.array() + .125)}});
  }
  return boxes;
}

TEST(DistrictVoids, are_what_other_districts_lie_in) {
  const Rounded rounded = room();
  const DistrictPlaces places(boxes_around({{5, 5, 5}, {20, 5, 5}, {2, 2, 2}}));
  const auto voids = voids_of(rounded, check(rounded), 0, places);
  ASSERT_EQ(voids.size(), 1);
  EXPECT_EQ(Vec3(voids[0].box.min()), Vec3(1, 1, 1) + kOrigin);
  EXPECT_THAT(voids[0].is_within, ElementsAre(1, 1));
  DistrictDepths depths;
  depths.add(voids);
  const std::vector<Vec3>& all = places.by_district();
  EXPECT_EQ(depths.at(all[1]), 2);
  EXPECT_EQ(depths.at(all[2]), 0);
  EXPECT_EQ(depths.at(all[3]), 2);
  // A district is not in its own.
  EXPECT_EQ(voids_of(rounded, check(rounded), 1, places).at(0).places.size(), 1);
}

TEST(DistrictVoids, are_known_as_long_as_others_stay) {
  const Rounded rounded = room();
  const DistrictPlaces before(boxes_around({{5, 5, 5}, {20, 5, 5}}));
  const auto voids = voids_of(rounded, check(rounded), 0, before);
  EXPECT_TRUE(are_known(voids, 0, before));
  EXPECT_TRUE(are_known(voids, 0, DistrictPlaces(boxes_around({{5, 5, 5}, {30, 5, 5}}))));
  EXPECT_FALSE(are_known(voids, 0, DistrictPlaces(boxes_around({{5, 5, 6}, {20, 5, 5}}))));
  EXPECT_FALSE(are_known(voids, 0, DistrictPlaces(boxes_around({{5, 5, 5}, {2, 5, 5}}))));
  EXPECT_FALSE(are_known(voids, 0, DistrictPlaces(boxes_around({{20, 5, 5}}))));
}

using DistrictVoidsOfBuilds = test::Tool;

// Six plates around a ball, which is a district of its own.
std::string plates_and_ball(const std::string& centre) {
  std::string text = R"({"units": "mm", "tolerance": 0.1, "parts": [)";
  int name = 0;
  for (const std::string axis : {"1, 0, 0", "0, 1, 0", "0, 0, 1"}) {
    for (const std::string side : {"-10", "10"}) {
      std::string place = axis;
      place.replace(place.find('1'), 1, side);
      text += R"({"name": "p)" + std::to_string(name++) + R"(", "flange": {"center": [)" + place +
              R"(], "normal": [)" + axis + R"(], "radius": 20, "thickness": 1}},)";
    }
  }
  return text + R"({"name": "ball", "sphere": {"center": [)" + centre + R"(], "radius": 2}}]})";
}

TEST_F(DistrictVoidsOfBuilds, are_told_with_tiles_and_from_a_cache) {
  for (const auto& [centre, depth] :
       std::vector<std::pair<std::string, int>>{{"0, 0, 0", 2}, {"1, 0, 0", 2}, {"50, 0, 0", 0}}) {
    folder_.write("room.json", plates_and_ball(centre));
    const auto whole = json({"build", "room.json", "-o", "a.stl"}, 0);
    std::vector<int> depths;
    for (const auto& shell : whole.at("output").at("check").at("shells")) {
      depths.push_back(shell.at("depth"));
    }
    EXPECT_THAT(depths, ElementsAre(0, 1, depth)) << centre;
    for (const std::vector<std::string>& tiles :
         {std::vector<std::string>{"--tiles", "1"}, {"--tiles", "2"}, {"--cache", "c"}}) {
      std::vector<std::string> arguments{"build", "room.json", "-o", "a.stl"};
      arguments.insert(arguments.end(), tiles.begin(), tiles.end());
      EXPECT_EQ(json(arguments, 0).at("output").at("check").at("shells"),
                whole.at("output").at("check").at("shells"))
          << centre << " " << tiles[1];
    }
  }
}

}  // namespace
}  // namespace dupin::cli
