#include "tiles/district_result.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dupin::cli {
namespace {

DistrictResult sample() {
  DistrictResult result;
  PartReport part;
  part.name = "run";
  part.index = 17;
  part.kind = "pipe";
  part.warnings = {"a warning", ""};
  part.margin_lower = .25;
  part.triangles = 12;
  result.built.parts = {part, part};
  result.built.parts[1].index = 40;
  result.built.runs = 2;
  result.built.grid = 0x1p-20;
  result.built.region = Region::fluid;
  result.built.volumes = RegionVolumes{3, 2, 1};
  Report report;
  report.points = 8;
  report.counts = {0, 1, 2};
  report.shells = {{0, 12, -1.5, 1, 2}};
  report.volume = -1.5;
  result.output.report.check = report;
  result.output.report.rounding.coordinates = Coordinates::binary32;
  result.output.report.rounding.filled_places = {Vec3(1, 2, 3)};
  result.output.report.rounding.thin_shells = {{Vec3(4, 5, 6), .5, .25}};
  result.output.report.contacts = {{Contact::Kind::edge, Vec3(1, 0, 0), Vec3(2, 0, 0), {"a", "b"}}};
  result.output.report.settled = ContactSettlement{"separate", .125, result.output.report.contacts};
  result.output.piece = {std::string(100, 'x'), {"a", "b"}, 5, 6, 7};
  result.output.piece.borders = {{"ring", {1, 2}, {Vec3(1, 2, 3)}, {"a"}}, {}};
  result.output.sides = {
      {true, true, {{3, 4}, {1, 2}}, {Vec3(1, 2, 3)}, {Vec3(4, 5, 6), Vec3(7, 8, 9)}}, {}};
  return result;
}

TEST(DistrictResult, is_read_as_it_was_written) {
  const DistrictResult given = sample();
  const std::string bytes = bytes_of(given, {3, 17, 40});
  const auto read = result_of(bytes, {3, 17, 40});
  ASSERT_TRUE(read);
  ASSERT_EQ(read->built.parts.size(), 2);
  EXPECT_EQ(read->built.parts[0].index, 17);
  EXPECT_EQ(read->built.parts[0].warnings, given.built.parts[0].warnings);
  EXPECT_EQ(read->built.parts[0].margin_lower, .25);
  EXPECT_EQ(read->built.parts[0].margin_upper, std::nullopt);
  EXPECT_EQ(read->built.region, Region::fluid);
  EXPECT_EQ(read->built.volumes->fluid, 1);
  EXPECT_EQ(read->output.report.check->shells, given.output.report.check->shells);
  EXPECT_EQ(read->output.report.check->counts, given.output.report.check->counts);
  EXPECT_EQ(read->output.report.rounding.filled_places, given.output.report.rounding.filled_places);
  EXPECT_EQ(read->output.report.rounding.thin_shells.at(0).move, .25);
  EXPECT_EQ(read->output.report.contacts.at(0).names, given.output.report.contacts.at(0).names);
  EXPECT_EQ(read->output.report.settled->policy, "separate");
  EXPECT_EQ(read->output.report.settled->contacts.at(0).to, Vec3(2, 0, 0));
  EXPECT_EQ(read->output.piece.bytes, given.output.piece.bytes);
  EXPECT_EQ(read->output.piece.points, 5);
  EXPECT_EQ(read->output.piece.triangles, 6);
  EXPECT_EQ(read->output.piece.labels, 7);
  EXPECT_EQ(read->output.piece.names, given.output.piece.names);
  ASSERT_EQ(read->output.piece.borders.size(), 2);
  EXPECT_EQ(read->output.piece.borders[0].name, "ring");
  EXPECT_EQ(read->output.piece.borders[0].points, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(read->output.piece.borders[0].corners, std::vector<Vec3>{Vec3(1, 2, 3)});
  EXPECT_EQ(read->output.piece.borders[0].labels, std::vector<std::string>{"a"});
  EXPECT_EQ(read->output.sides, given.output.sides);
  EXPECT_EQ(bytes_of(*read, {3, 17, 40}), bytes);
}

TEST(DistrictResult, counts_parts_as_the_document_does_now) {
  const std::string bytes = bytes_of(sample(), {3, 17, 40});
  const auto read = result_of(bytes, {4, 18, 41});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->built.parts[0].index, 18);
  EXPECT_EQ(read->built.parts[1].index, 41);
  EXPECT_FALSE(result_of(bytes, {4, 18})) << "there are more of them";
}

TEST(DistrictResult, of_damaged_bytes_is_none) {
  const std::string bytes = bytes_of(sample(), {3, 17, 40});
  const std::vector<std::uint32_t> parts{3, 17, 40};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 4);
    EXPECT_FALSE(result_of(damaged, parts)) << i;
    EXPECT_FALSE(result_of(bytes.substr(0, i), parts)) << i;
  }
  EXPECT_FALSE(result_of(bytes + "x", parts));
}

}  // namespace
}  // namespace dupin::cli
