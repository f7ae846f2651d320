#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

TEST(BuildProgress, tells_its_stages_and_stops_at_any) {
  const Assembly header = read_assembly(test::source_folder() / "examples/header.json");
  std::vector<std::string> stages;
  (void)build(header, {.progress = [&](std::string_view stage, double fraction) {
                EXPECT_TRUE(fraction >= 0 && fraction <= 1) << stage;
                if (std::ranges::find(stages, stage) == stages.end()) {
                  stages.emplace_back(stage);
                }
                return true;
              }});
  ASSERT_GT(stages.size(), 3);
  EXPECT_EQ((std::vector(stages.begin(), stages.begin() + 3)),
            (std::vector<std::string>{"resolve", "certify", "mesh"}));
  for (const std::string& stop : stages) {
    try {
      (void)build(header,
                  {.progress = [&](std::string_view stage, double) { return stage != stop; }});
      FAIL() << stop;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::cancelled) << stop;
    }
  }
}

}  // namespace
}  // namespace dupin
