#include "tiles/build_identity.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/atomic_file.h"

namespace dupin::test {
namespace {

TEST(BuildIdentity, is_that_of_the_running_program) {
  EXPECT_THAT(cli::build_identity(), testing::MatchesRegex("[0-9a-f]{16,}( [0-9a-f]{16,})*"));
  EXPECT_EQ(cli::build_identity(), cli::build_identity());
}

using BuildIdentities = Tool;

// Of the same version, but with other code, or with none that says so.
TEST_F(BuildIdentities, keep_results_of_other_builds_apart) {
  folder_.write("plant.json",
                R"({"units": "mm", "tolerance": 0.5,
                    "parts": [{"name": "a", "pipe": {"from": [0, 0, 0], "to": [100, 0, 0], "radius": 9}}]})");
  const std::string tool = read_file(tool_path());
  const std::string owner("\x03\0\0\0GNU\0", 8);  // NT_GNU_BUILD_ID
  const std::size_t place = tool.find(owner);
  ASSERT_NE(place, std::string::npos) << "linked without --build-id";
  std::string other = tool, none = tool;
  other[place + owner.size()] ^= 1;
  none[place] = 9;
  const auto kept = [&](const std::string& bytes) {
    folder_.write("tool", bytes);
    std::filesystem::permissions(folder_.path() / "tool", std::filesystem::perms::owner_all);
    const ProcessResult result =
        run_process({(folder_.path() / "tool").string(), "build", "plant.json", "-o", "out.stl",
                     "--cache", "kept", "--quiet"},
                    folder_.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::filesystem::directory_iterator files(folder_.path() / "kept");
    return std::distance(begin(files), end(files)) - 1;  // without the mark
  };
  EXPECT_EQ(kept(tool), 1);
  EXPECT_EQ(kept(tool), 1);
  EXPECT_EQ(kept(other), 2);
  EXPECT_EQ(kept(none), 3);
  EXPECT_EQ(kept(none), 3);
}

}  // namespace
}  // namespace dupin::test
