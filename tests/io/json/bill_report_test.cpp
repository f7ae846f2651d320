#include "dupin/io/bill_report.h"

#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/io/assembly_json.h"

namespace dupin {
namespace {

using std::numbers::pi;

BillReport report(const std::string& units) {
  return {bill_of_materials(parse_assembly(R"({"units": ")" + units +
                                               R"(", "tolerance": 0.01, "wall": 0.2, "parts": [
      {"name": "a", "pipe": {"from": [0, 0, 0], "to": [0, 0, 10], "radius": 1}},
      {"name": "b", "elbow": {"from": "a.end", "bend_radius": 3, "angle": 90, "toward": [1, 0, 0]}},
      {"name": "c", "elbow": {"from": "b.end", "bend_radius": 3, "angle": 90, "toward": [0, 1, 0]}},
      {"name": "d", "pipe": {"from": "c.end", "length": 5}}]})",
                                           "test"))};
}

TEST(SizeText, is_the_nominal_size_where_there_is_one) {
  EXPECT_EQ(size_text({{114.3, 114.3}, {114.3, 114.3}}, Unit::millimetre), "DN100");
  EXPECT_EQ(size_text({{4.5, 4.5}, {3.5, 3.5}}, Unit::inch), "DN100 / DN80");
  EXPECT_EQ(size_text({{12.5, 12.5}}, Unit::millimetre), "OD 12.5");
  EXPECT_EQ(size_text({{24, 12}, {24, 12}}, Unit::millimetre), "24 x 12");
  EXPECT_EQ(size_text({}, Unit::millimetre), "");
}

TEST(TakeOff, counts_what_is_alike_and_adds_lengths) {
  const std::vector<TakeOff> all = take_off(report("mm"));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].kind, "elbow");
  EXPECT_EQ(all[0].count, 2U);
  EXPECT_EQ(all[0].bend_radius, 3);
  EXPECT_EQ(all[0].bend_angle, 90);
  EXPECT_EQ(all[1].kind, "pipe");
  EXPECT_EQ(all[1].count, 2U);
  EXPECT_NEAR(all[1].length, 15, 1e-12);
}

TEST(TakeOff, keeps_components_of_a_file_apart) {
  BillReport both = report("mm");
  both.origins = {{"p", "PIPE", 3}, {"e", "ELBOW", 7}, {"e2", "ELBOW", 9}, {"f", "FLANGE", 12}};
  const std::vector<TakeOff> all = take_off(both);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].component, "ELBOW");
  EXPECT_EQ(all[1].component, "FLANGE");
  EXPECT_NEAR(all[1].length, 5, 1e-12);
  EXPECT_EQ(all[2].component, "PIPE");
  EXPECT_NEAR(all[2].length, 10, 1e-12);
}

// A hundred centimetres are a metre.
TEST(BillReport, weighs_in_kilograms_whatever_the_unit) {
  for (const auto& [units, metres] : {std::pair("m", 1.), {"cm", 0.01}, {"in", 0.0254}}) {
    BillReport heavy = report(units);
    heavy.density = 7850;
    const double expected = 7850 * pi * (1 - 0.64) * 10 * metres * metres * metres;
    EXPECT_NEAR(*mass(heavy, heavy.bill.rows[0].metal->volume), expected, 1e-12 * expected);
  }
  EXPECT_FALSE(mass(report("m"), 1).has_value());
}

TEST(BillReport, as_json_has_all_rows_and_their_sum) {
  const auto json = nlohmann::json::parse(to_json(report("mm")));
  EXPECT_EQ(json.at("unit"), "mm");
  EXPECT_TRUE(json.at("density").is_null());
  ASSERT_EQ(json.at("parts").size(), 4U);
  const auto& pipe = json.at("parts")[0];
  EXPECT_TRUE(pipe.at("metal").at("mass").is_null());
  EXPECT_NEAR(pipe.at("fluid").at("volume").get<double>(), 6.4 * pi, 1e-12);
  double metal = 0;
  for (const auto& part : json.at("parts")) {
    metal += part.at("metal").at("volume").get<double>();
    EXPECT_NEAR(
        part.at("metal").at("volume").get<double>() + part.at("fluid").at("volume").get<double>(),
        part.at("outer_volume").get<double>(), 1e-12);
  }
  EXPECT_NEAR(json.at("sum").at("metal").at("volume").get<double>(), metal, 1e-12);
  EXPECT_EQ(json.at("sum").at("without_volume"), 0);
}

}  // namespace
}  // namespace dupin
