#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/decimal.h"
#include "io/json/document_fault.h"
#include "json/nominal_size.h"

namespace dupin {
namespace {

using test::document;
using test::read_last;

std::string pipe(const std::string& section, const std::string& more = {}) {
  return document(R"({"name": "a", )" + more + R"("pipe": {"from": [0, 0, 0], "to": [9, 0, 0], )" +
                  section + "}}");
}

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string message_of(const std::string& text) {
  return message_of([&] { (void)parse_assembly(text, "d.json"); });
}

// ASME B36.10M, table 1.
TEST(NominalSize, gives_radius_and_wall) {
  EXPECT_EQ(read_last<PipeBetween>(pipe(R"("size": "DN100")")).radius, 114.3 / 2);
  EXPECT_EQ(read_last<PipeBetween>(pipe(R"("size": "NPS 4")")).radius, 114.3 / 2);
  EXPECT_EQ(parse_assembly(pipe(R"("size": "DN100", "schedule": 40)")).parts[0].wall, 6.02);
  EXPECT_EQ(parse_assembly(pipe(R"("size": "NPS4", "schedule": "xs")")).parts[0].wall, 8.56);
  EXPECT_EQ(parse_assembly(pipe(R"("size": "DN100")")).parts[0].wall, std::nullopt);
}

TEST(NominalSize, may_be_a_fraction) {
  const std::pair<const char*, double> rows[] = {
      {"NPS 1/8", 10.3},   {"NPS 1/2", 21.3}, {"NPS1/2", 21.3},    {"NPS 1 1/2", 48.3},
      {"NPS 1-1/2", 48.3}, {"NPS 2-1/2", 73}, {"NPS 3 1/2", 101.6}};
  for (const auto& [size, outside] : rows) {
    const std::string section = R"("size": ")" + std::string(size) + "\"";
    EXPECT_EQ(read_last<PipeBetween>(pipe(section)).radius, outside / 2) << size;
  }
  for (const char* size : {"NPS /2", "NPS 1/", "NPS 1/0", "NPS -1/2", "NPS 1/2/2", "NPS 1 /2",
                           "DN 1/2", "NPS 1/3", "NPS 1--1/2"}) {
    EXPECT_THAT(message_of(pipe(R"("size": ")" + std::string(size) + "\"")),
                testing::HasSubstr("is no size"))
        << size;
  }
}

// ASME B36.10M, table 1: 3/8 inch thick up to NPS 48.
TEST(NominalSize, has_walls_of_the_largest_and_least_pipes) {
  const auto wall = [](const std::string& size, const std::string& schedule) {
    return *parse_assembly(pipe(R"("size": ")" + size + R"(", "schedule": ")" + schedule + "\""))
                .parts[0]
                .wall;
  };
  for (int nominal = 26; nominal <= 48; nominal += 2) {
    const std::string size = "NPS " + std::to_string(nominal);
    EXPECT_EQ(wall(size, "STD"), 9.53) << size;
    EXPECT_EQ(wall(size, "XS"), 12.70) << size;
  }
  EXPECT_EQ(wall("DN750", "5"), 6.35);
  EXPECT_EQ(wall("DN900", "40"), 19.05);
  EXPECT_EQ(wall("DN6", "STD"), 1.73);
  EXPECT_EQ(wall("NPS 3/8", "80"), 3.20);
}

TEST(NominalSize, is_of_elbows_too_and_in_the_documents_unit) {
  const Assembly assembly = parse_assembly(
      R"({"units": "in", "tolerance": 0.1, "parts": [{"name": "e", "elbow": {"from": [0, 0, 0],
          "direction": [1, 0, 0], "to": [9, 9, 0], "size": "NPS 4", "schedule": "40"}}]})");
  EXPECT_DOUBLE_EQ(std::get<Place>(std::get<ElbowTo>(assembly.parts[0].shape).from).radius, 2.25);
  EXPECT_DOUBLE_EQ(*assembly.parts[0].wall, 6.02 / 25.4);
}

// DN100 is 114.3 across outside, wherever the walls of others are.
TEST(NominalSize, is_the_outside_diameter_whatever_the_side_of_walls) {
  const auto of = [](const std::string& parts) {
    return parse_assembly(R"({"units": "mm", "tolerance": 0.1, "wall": 2, "wall_side": "outwards",
        "parts": [)" + parts +
                          "]}");
  };
  const std::string ends = R"("from": [0, 0, 0], "to": [9, 0, 0], )";
  for (const std::string section :
       {R"("size": "DN100")", R"("outside_diameter": 114.3)", R"("size": "DN100", "schedule": 40)",
        R"("outside_diameter": 114.3, "inside_diameter": 100)"}) {
    const std::string part = R"({"name": "a", "pipe": {)" + ends + section + "}}";
    EXPECT_EQ(of(part).parts[0].wall_side, WallSide::inwards);
    EXPECT_EQ(of(R"({"wall_side": "centred", "parts": [)" + part + "]}").parts[0].wall_side,
              WallSide::inwards);
    EXPECT_THAT(message_of(pipe(section, R"("wall_side": "outwards", )")),
                testing::AllOf(testing::StartsWith("d.json#/parts/0/wall_side: the "),
                               testing::HasSubstr(" says the outside diameter")));
    EXPECT_EQ(message_of(pipe(section, R"("wall_side": "inwards", )")), "accepted");
    EXPECT_THAT(document_text(parse_assembly(pipe(section))),
                testing::Not(testing::HasSubstr("wall_side")));
    EXPECT_THAT(document_text(of(part)), testing::HasSubstr(R"("wall_side":"inwards")"));
  }
  EXPECT_EQ(of(R"({"name": "a", "pipe": {)" + ends + R"("radius": 5}})").parts[0].wall_side,
            std::nullopt);
  const Assembly tee = of(R"({"name": "t", "tee": {"from": [0, 0, 0], "direction": [1, 0, 0],
      "radius": 60, "length": 400, "branch": {"direction": [0, 0, 1], "length": 200, "size": "DN50"}}})");
  EXPECT_EQ(tee.parts[0].wall_side, std::nullopt);
  EXPECT_EQ(tee.parts[1].wall_side, WallSide::inwards);
}

TEST(NominalSize, says_what_there_is) {
  EXPECT_THAT(message_of(pipe(R"("size": "DN101")")),
              testing::StartsWith("d.json#/parts/0/pipe/size: 'DN101' is no size of ASME B36.10M: "
                                  "DN6, DN8, DN10, "));
  for (const char* size : {"4", "DN1e2", "DN 1E2", "NPS 4e0", "DN+100", "DN0x64", "DNinf", "DN"}) {
    EXPECT_THAT(message_of(pipe(R"("size": ")" + std::string(size) + "\"")),
                testing::HasSubstr("is no size"))
        << size;
  }
  EXPECT_EQ(message_of(pipe(R"("size": 100)")),
            "d.json#/parts/0/pipe/size: must be a string, not number");
  EXPECT_EQ(
      message_of(pipe(R"("size": "DN100", "schedule": 20)")),
      "d.json#/parts/0/pipe/schedule: DN100 is not made in schedule '20' of ASME B36.10M, but "
      "5, 10, 30, STD, 40, XS, 80, 120, 160, XXS");
  EXPECT_THAT(message_of(pipe(R"("size": "DN100", "schedule": true)")),
              testing::HasSubstr("must be a string, not boolean"));
  EXPECT_THAT(message_of(pipe(R"("size": "DN100", "radius": 3)")),
              testing::HasSubstr("give either a size or a radius"));
  EXPECT_THAT(message_of(pipe(R"("size": "DN100", "schedule": 40)", R"("wall": 2, )")),
              testing::HasSubstr("give either a schedule or a wall"));
  EXPECT_THAT(message_of(pipe(R"("radius": 3, "schedule": 40)")),
              testing::HasSubstr("the key 'size' is missing"));
}

TEST(NominalSize, diameters_out_of_range_are_told_by_the_key_that_was_written) {
  for (const char* number : {"0", "-5", "1e13", "1e-300"}) {
    EXPECT_EQ(message_of(pipe(R"("outside_diameter": )" + std::string(number))),
              "d.json#/parts/0/pipe/outside_diameter: must be a positive number between 2e-12 and "
              "2e12, not " +
                  std::string(number == std::string("1e13") ? "1e+13" : number));
  }
  // Where a radius is refused, and no sooner.
  for (const char* radius : {"1e-12", "1e12", "0.9e-12", "1.1e12"}) {
    const bool is_taken = std::string(radius)[1] == 'e';
    const double diameter = 2 * std::stod(radius);
    const auto resolved = [&](const std::string& text) {
      return message_of([&] { (void)resolve(parse_assembly(text, "d.json")); });
    };
    const std::string of_radius = resolved(pipe(R"("radius": )" + std::string(radius)));
    const std::string of_diameter = resolved(pipe(R"("outside_diameter": )" + decimal(diameter)));
    EXPECT_EQ(of_radius.find("must be a positive number") == std::string::npos, is_taken);
    EXPECT_EQ(of_diameter.find("must be a positive number") == std::string::npos, is_taken);
  }
  EXPECT_THAT(message_of(document(R"({"name": "t", "tee": {"from": [0, 0, 0],
                  "direction": [1, 0, 0], "length": 9, "outside_diameter": 4, "branch": {
                  "direction": [0, 0, 1], "length": 9, "outside_diameter": -3}}})")),
              testing::HasSubstr("/tee/branch/outside_diameter: must be"));
}

}  // namespace
}  // namespace dupin
