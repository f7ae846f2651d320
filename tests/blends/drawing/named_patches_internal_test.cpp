#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawing/named_patches.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "support/source_folder.h"

namespace dupin::drawing {
namespace {

using shading::PatchTable;
using testing::ElementsAre;
using testing::Key;
using testing::Pair;
using testing::SizeIs;

PatchTable table_of(const std::string& parts,
                    const std::map<std::string, std::string>& renamed = {}) {
  PatchTable result;
  add_patches(resolve(parse_assembly(
                  R"({"units": "mm", "tolerance": 0.01, "parts": [)" + parts + "]}", "test")),
              renamed, result);
  return result;
}

PatchTable table_of_example(const std::string& name) {
  PatchTable result;
  add_patches(resolve(read_assembly(test::source_folder() / "examples" / (name + ".json"))), {},
              result);
  return result;
}

const std::string kPipe =
    R"({"name": "p", "pipe": {"from": [0, 0, 0], "to": [0, 0, 9], "radius": 2}})";
const std::string kElbow = R"(, {"name": "e", "elbow": {"from": "p.end", "bend_radius": 5, "angle":
      90, "toward": [1, 0, 0]}})";

TEST(NamedPatches, has_the_discs_of_open_ends) {
  const PatchTable table = table_of(kPipe);
  EXPECT_THAT(table.of_name, ElementsAre(Pair("p", SizeIs(1)), Pair("p.end", SizeIs(1)),
                                         Pair("p.start", SizeIs(1))));
  EXPECT_TRUE(table.neighbours.empty());
}

TEST(NamedPatches, parts_that_share_a_ring_are_neighbours_and_have_no_discs_there) {
  const PatchTable table = table_of(kPipe + kElbow);
  EXPECT_THAT(table.of_name, ElementsAre(Key("e"), Key("e.end"), Key("p"), Key("p.start")));
  EXPECT_TRUE(table.are_neighbours(table.of_name.at("p").front(), table.of_name.at("e").front()));
  EXPECT_EQ(table.neighbours.size(), 1);
}

TEST(NamedPatches, has_names_as_they_are_told) {
  const PatchTable table = table_of(kPipe + kElbow, {{"p", "all"}, {"e", "all"}, {"none", "x"}});
  EXPECT_THAT(table.of_name, ElementsAre(Pair("all", SizeIs(2)), Key("e.end"), Key("p.start")));
}

TEST(NamedPatches, fillets_and_hubs_are_neighbours_of_what_they_join) {
  const PatchTable tee = table_of_example("tee");
  const std::uint32_t throat = tee.of_name.at("throat").front();
  EXPECT_TRUE(tee.are_neighbours(throat, tee.of_name.at("run").front()));
  EXPECT_TRUE(tee.are_neighbours(throat, tee.of_name.at("branch").front()));
  EXPECT_FALSE(tee.are_neighbours(tee.of_name.at("run").front(), tee.of_name.at("branch").front()));
  // A loop of two halves.
  EXPECT_EQ(table_of_example("equal-tee").of_name.at("throat").size(), 2);
  const PatchTable junction = table_of_example("junction");
  const std::uint32_t hub = junction.of_name.at("hub").front();
  EXPECT_TRUE(junction.are_neighbours(hub, junction.of_name.at("hub.1").back()));
}

}  // namespace
}  // namespace dupin::drawing
