#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "blends/assembly/hollow_regions.h"
#include "dupin/io/assembly_json.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

// Of large examples: the thinner a wall, the finer both of its sides have to be.
const std::map<std::string, double> kThick{
    {"plant-run.json", 3}, {"header_forty.json", 1}, {"vessel.json", 2}, {"around.json", 0.5}};

TEST(Bore, is_that_of_every_example_that_has_room_for_it) {
  for (const auto& file : std::filesystem::directory_iterator(test::source_folder() / "examples")) {
    const std::string name = file.path().filename().string();
    // They fold; or a plate that a flare lies on would be hollow.
    if (file.path().extension() != ".json" || name == "tight.json" ||
        name == "oblique-nozzle.json") {
      continue;
    }
    SCOPED_TRACE(name);
    Assembly assembly = read_assembly(file);
    if (!assembly.wall) {
      const auto thick = kThick.find(name);
      assembly.wall = thick == kThick.end() ? 0.02 : thick->second;
    }
    const test::Regions made = test::regions(assembly);
    // A bore is no wider than the tube about it.
    EXPECT_EQ(made.fluid.solid.components(), made.outer.solid.components());
  }
}

}  // namespace
}  // namespace dupin
