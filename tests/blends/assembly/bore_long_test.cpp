#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "blends/assembly/hollow_regions.h"
#include "dupin/io/assembly_json.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

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
      assembly.wall = name == "plant-run.json" ? 3 : 0.02;
    }
    const test::Regions made = test::regions(assembly);
    // A bore is no wider than the tube about it.
    EXPECT_EQ(made.fluid.solid.components(), made.outer.solid.components());
  }
}

}  // namespace
}  // namespace dupin
