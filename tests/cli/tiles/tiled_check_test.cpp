#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "kernel/tiles/facet_scene.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

class TiledChecks : public Tool {
 protected:
  void put_facets(const std::string& name, const std::vector<Facet>& facets) const {
    std::string bytes(80, '\0');
    const auto append = [&](const auto& number) {
      bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
    };
    append(static_cast<std::uint32_t>(facets.size()));
    for (const Facet& facet : facets) {
      append(std::array<float, 3>{});
      append(facet);
      append(std::uint16_t{0});
    }
    folder_.write(name, bytes);
  }
  /// The same bytes and exit code, in words and as JSON.
  void expect_same(const std::string& file) const {
    for (const std::vector<std::string>& form :
         {std::vector<std::string>{}, {"--json"}, {"--quiet"}}) {
      std::vector<std::string> command{"check", file};
      command.insert(command.end(), form.begin(), form.end());
      const ProcessResult whole = dupin(command);
      for (const std::string tiles : {"1", "3", "8", "64"}) {
        std::vector<std::string> in_tiles = command;
        in_tiles.insert(in_tiles.end(), {"--tiles", tiles});
        const ProcessResult result = dupin(in_tiles);
        EXPECT_EQ(result.exit_code, whole.exit_code) << tiles;
        EXPECT_TRUE(result.out == whole.out) << file << " in " << tiles << " tiles";
        EXPECT_EQ(result.err, whole.err);
      }
    }
  }
};

TEST_F(TiledChecks, print_the_bytes_of_check) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    put_facets("a.stl", facet_scene(1000 + seed, 0.01 * seed));
    expect_same("a.stl");
  }
  put_facets("a.stl", {});
  expect_same("a.stl");
  folder_.write("a.stl", "short");
  expect_same("a.stl");
  expect_same("missing.stl");
}

TEST_F(TiledChecks, say_what_they_cannot_do) {
  const TriMesh cube = box({0, 0, 0}, {1, 1, 1});
  put("a.off", cube);
  folder_.write("a.stl", mesh_bytes(cube, kStlBinary));
  const auto refused = [&](std::vector<std::string> arguments, int exit_code) {
    arguments.insert(arguments.begin(), "check");
    const ProcessResult result = dupin(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  EXPECT_THAT(refused({"a.off", "--tiles", "2"}, 3), HasSubstr("a.off: is no binary STL"));
  EXPECT_THAT(refused({"-", "--tiles", "2"}, 2), HasSubstr("standard input"));
  EXPECT_THAT(refused({"a.stl", "--tiles", "0"}, 2), HasSubstr("--tiles"));
  EXPECT_THAT(refused({"a.stl", "--tiles", "2", "--memory", "1GB"}, 2), HasSubstr("--memory"));
  EXPECT_THAT(refused({"a.stl", "--memory", "some"}, 2), HasSubstr("--memory"));
  EXPECT_THAT(refused({"a.stl", "--memory", "1kB"}, 3),
              AllOf(HasSubstr("'a.stl': the largest"), ContainsRegex("need [0-9.]+ kB; give")));
  EXPECT_THAT(shell("TMPDIR=/nowhere dupin check a.stl --tiles 2").err, HasSubstr("TMPDIR"));
  EXPECT_EQ(shell("TMPDIR=/nowhere dupin check a.stl --tiles 2").exit_code, 5);
}

// A file of at most a thousand bytes takes the place of a full disk.
TEST_F(TiledChecks, end_where_the_disk_does) {
  put_facets("a.stl", facet_scene(7, 0));
  const ProcessResult result = shell("ulimit -f 1; dupin check a.stl --tiles 2");
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.err, HasSubstr("cannot write a temporary file"));
  EXPECT_EQ(result.out, "");
}

}  // namespace
}  // namespace dupin::test
