#include "tiles/united_districts.h"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/solid.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using cli::operand_districts;
using testing::ElementsAre;
using testing::HasSubstr;

Eigen::AlignedBox3d cube(double x, double size = 1) {
  return {Vec3(x, 0, 0), Vec3(x + size, size, size)};
}

TEST(OperandDistricts, are_what_boxes_reach) {
  const Boxes boxes{cube(0), cube(10), cube(1.5), {}, cube(11.5)};
  EXPECT_THAT(operand_districts(boxes, {}).operands,
              ElementsAre(ElementsAre(0, 3), ElementsAre(2), ElementsAre(1), ElementsAre(4)));
  EXPECT_THAT(operand_districts(boxes, {0.25, 0}).operands,
              ElementsAre(ElementsAre(0, 2, 3), ElementsAre(1, 4)));
  EXPECT_THAT(operand_districts(Boxes(boxes.rbegin(), boxes.rend()), {0.25, 0}).operands,
              ElementsAre(ElementsAre(4, 2, 1), ElementsAre(3, 0)));
  EXPECT_THAT(operand_districts(boxes, {0, 0.25 / 12.5}).operands,
              ElementsAre(ElementsAre(0, 2, 3), ElementsAre(1, 4)));
}

TEST(OperandDistricts, of_nothing_are_one) {
  EXPECT_THAT(operand_districts({}, {}).operands, ElementsAre(ElementsAre()));
  EXPECT_THAT(operand_districts(Boxes{{}, {}}, {}).operands, ElementsAre(ElementsAre(0, 1)));
}

class TiledUnion : public Tool {
 protected:
  /// Pairs that cross, in two rows of files, and one whose faces touch; far from the origin.
  std::vector<std::string> put_pairs(int pairs) const {
    std::vector<std::string> first, second;
    for (int i = 0; i < pairs; ++i) {
      const double x = 2e5 + 1000.1 * i, shift = i % 3 == 0 ? 100 : 50.3;
      first.push_back("a" + std::to_string(i) + ".off");
      second.push_back("b" + std::to_string(i) + ".off");
      put(first.back(), box({x, 0, 0}, {x + 100, 100, 100}));
      put(second.back(), box({x + shift, 0, 0}, {x + shift + 90, 80.7, 100}));
    }
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  std::pair<nlohmann::json, std::string> united(std::vector<std::string> arguments,
                                                const std::vector<std::string>& options) const {
    arguments.insert(arguments.begin(), "union");
    arguments.insert(arguments.end(), {"-o", "out.stl"});
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto report = json(arguments, 0);
    return {report, folder_.read("out.stl")};
  }
};

TEST_F(TiledUnion, has_the_same_bytes_for_all_numbers_of_tiles) {
  const auto files = put_pairs(9);
  const auto [whole, bytes] = united(files, {});
  EXPECT_EQ(whole.at("check").at("components"), 9);
  EXPECT_EQ(whole.at("check").at("solid"), true);
  for (const std::string tiles : {"1", "3", "8", "64"}) {
    const auto [report, again] = united(files, {"--tiles", tiles});
    EXPECT_TRUE(again == bytes) << tiles;
    EXPECT_EQ(report.at("check").at("triangles"), whole.at("check").at("triangles"));
    EXPECT_EQ(report.at("rounding"), whole.at("rounding"));
  }
  EXPECT_TRUE(united(files, {"--memory", "1MB"}).second == bytes);
  const std::vector<std::string> ply{"--format", "ply"};
  const std::string whole_ply = united(files, ply).second;
  EXPECT_TRUE(united(files, {"--format", "ply", "--tiles", "4"}).second == whole_ply);
  EXPECT_TRUE(united(files, {"--format", "stl"}).second == bytes) << "as check needs it";
  EXPECT_EQ(json({"check", "out.stl"}, 0).at("components"), 9);
}

TEST_F(TiledUnion, shares_the_origin_and_mends_operands) {
  auto files = put_pairs(4);
  TriMesh twice = box({0, 0, 0}, {1, 1, 1});
  twice.triangles.push_back(twice.triangles.front());
  twice.triangles.push_back(twice.triangles.front());
  std::swap(twice.triangles.back()[0], twice.triangles.back()[1]);
  put("twice.off", twice);
  files.emplace_back("twice.off");
  const std::vector<std::string> options{"--origin", "auto", "--repair"};
  const auto [whole, bytes] = united(files, options);
  EXPECT_EQ(whole.at("repairs").size(), 1U);
  const auto [tiled, again] = united(files, {"--origin", "auto", "--repair", "--tiles", "3"});
  EXPECT_TRUE(again == bytes);
  EXPECT_EQ(tiled.at("repairs"), whole.at("repairs"));
  EXPECT_EQ(tiled.at("rounding").at("origin"), whole.at("rounding").at("origin"));
}

// Numbers that are large only as seen from the origin move by more than their own size tells.
TEST_F(TiledUnion, stays_in_its_boxes_whatever_the_origin) {
  const auto files = put_pairs(3);
  for (const std::string origin : {"3e8,0,0", "-1e9,0,0"}) {
    const auto bytes = united(files, {"--origin", origin}).second;
    EXPECT_TRUE(united(files, {"--origin", origin, "--tiles", "3"}).second == bytes) << origin;
  }
}

TEST_F(TiledUnion, leaves_out_what_is_too_small_and_says_so) {
  put("big.off", box({-1000, -1000, -1000}, {1000, 1000, 1000}));
  put("speck.off", box({1e5, 0, 0}, {1e5 + 1e-4, 1e-4, 1e-4}));
  put("beyond.off", box({-1e5, 0, 0}, {-1e5 + 1e-4, 1e-4, 1e-4}));
  for (const std::string tiles : {"", " --tiles 1", " --tiles 3"}) {
    SCOPED_TRACE(tiles);
    const ProcessResult result = shell("dupin union big.off speck.off -o out.stl --json" + tiles);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto report = nlohmann::json::parse(result.out);
    EXPECT_EQ(report["rounding"]["removed_shells"], 1);
    EXPECT_EQ(report["rounding"]["thin_shells"].size(), 1);
    EXPECT_EQ(report["check"]["triangles"], 12);
    const ProcessResult nothing = shell("dupin union speck.off beyond.off -o none.stl" + tiles);
    EXPECT_EQ(nothing.exit_code, 4);
    EXPECT_THAT(nothing.err, HasSubstr("rounding leaves nothing of the solid"));
    EXPECT_THAT(nothing.err, testing::Not(HasSubstr("origin auto"))) << "it is centred";
    EXPECT_THAT(folder_.files(), testing::Not(testing::Contains("none.stl")));
  }
}

// A member that came before one that threw was destroyed twice.
TEST_F(TiledUnion, ends_with_the_error_of_a_district) {
  put("a.off", box({0, 0, 0}, {0.25, 0.25, 0.25}));
  put("b.off", box({0.125, 0.125, 0.125}, {0.3, 0.3, 0.3}));
  for (int i = 0; i < 8; ++i) {
    const ProcessResult result = shell(
        "MALLOC_CONF=junk:true dupin union a.off b.off -o out.stl --grid 1 "
        "--rounding-tolerance 0.01 --tiles 1; echo $?");
    EXPECT_EQ(result.out, "4\n") << result.err;
  }
}

TEST_F(TiledUnion, says_what_it_cannot_do) {
  const auto files = put_pairs(1);
  const auto refused = [&](const std::string& command, std::vector<std::string> options) {
    options.insert(options.begin(), {command, files[0], files[1]});
    const ProcessResult result = dupin(options);
    EXPECT_EQ(result.exit_code, 2) << result.err;
    return result.err;
  };
  EXPECT_THAT(refused("union", {"-o", "a.off", "--tiles", "2"}), HasSubstr("binary STL"));
  EXPECT_THAT(refused("union", {"-", "-o", "a.stl", "--tiles", "2"}), HasSubstr("standard input"));
  const ProcessResult of_pipe =
      shell("dupin union <(cat " + files[0] + ") " + files[1] + " -o a.stl --tiles 2");
  EXPECT_EQ(of_pipe.exit_code, 3);
  EXPECT_THAT(of_pipe.err, HasSubstr("has to be a regular file"));
  EXPECT_THAT(refused("union", {"-o", "a.stl", "--tiles", "2", "--timing"}), HasSubstr("--timing"));
  EXPECT_THAT(refused("subtract", {"-o", "a.stl", "--tiles", "2"}), HasSubstr("--tiles"));
}

// Of few triangles, which cross often.
TEST_F(TiledUnion, refuses_crossings_that_do_not_fit_into_memory) {
  std::vector<std::string> command{"union"};
  for (int i = 0; i < 12; ++i) {
    const double at = 10 * i, up = 0.1 * i;
    for (const char* name : {"a", "b"}) {
      command.push_back(name + std::to_string(i) + ".off");
      put(command.back(), *name == 'a' ? box({at, -5, up}, {at + 3, 120, up + 3})
                                       : box({-5, at, up + 1}, {120, at + 3, up + 4}));
    }
  }
  command.insert(command.end(), {"-o", "out.stl", "--memory"});
  const auto with_memory = [&](const std::string& memory) {
    std::vector<std::string> all = command;
    all.push_back(memory);
    return dupin(all);
  };
  const ProcessResult refused = with_memory("1MB");
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, testing::AllOf(HasSubstr("what hangs together at ("),
                                          HasSubstr("288 triangles, of which "),
                                          HasSubstr("allowed are 1 MB; give --memory more")));
  EXPECT_THAT(folder_.files(), testing::Not(testing::Contains("out.stl")));
  const ProcessResult made = with_memory("50MB");
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(json({"check", "out.stl"}, 0).at("components"), 1);
}

TEST_F(TiledUnion, names_the_operand_that_is_no_solid) {
  auto files = put_pairs(2);
  put("open.off", open_box());
  files.insert(files.begin() + 1, "open.off");
  files.insert(files.begin(), "union");
  files.insert(files.end(), {"-o", "out.stl", "--tiles", "2"});
  const ProcessResult result = dupin(files);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("open.off"));
  EXPECT_THAT(folder_.files(), testing::Not(testing::Contains("out.stl")));
}

// Pipes along x and along y through each other: all hangs together.
class DividedUnion : public TiledUnion {
 protected:
  /// Along an axis, 0 or 1, with a bore; 48 units apart.
  TriMesh bar(int axis, int place, double from, double to) const {
    TriMesh mesh = joined({tube(9 + axis, from, to, 12), reversed(tube(4, 0, 3, 7))});
    for (Vec3& point : mesh.points) {
      point = axis == 0 ? Vec3(point.z(), point.x() + 48. * place, point.y() + .3)
                        : Vec3(point.y() + 48. * place, point.z(), point.x());
    }
    return mesh;
  }

  std::vector<std::string> put_rack(int bars) const {
    std::vector<std::string> files;
    for (int i = 0; i < bars; ++i) {
      for (const int axis : {0, 1}) {
        files.push_back("bar" + std::to_string(axis) + "_" + std::to_string(i) + ".off");
        put(files.back(), bar(axis, i, -20, 48. * bars - 24));
      }
    }
    return files;
  }

  static std::vector<std::string> in_pieces(std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--piece", "9000"});
    return more;
  }
};

TEST_F(DividedUnion, has_the_same_bytes_for_all_numbers_of_tiles) {
  const auto files = put_rack(17);
  const auto [whole, whole_bytes] = united(files, {});
  const auto [report, bytes] = united(files, in_pieces());
  EXPECT_FALSE(bytes == whole_bytes);
  const auto again = json({"check", "out.stl"}, 0);
  for (const std::string key : {"solid", "components", "euler_number", "genus"}) {
    EXPECT_EQ(report.at("check").at(key), whole.at("check").at(key)) << key;
    EXPECT_EQ(again.at(key), whole.at("check").at(key)) << key;
  }
  EXPECT_EQ(again.at("triangles"), report.at("check").at("triangles"));
  EXPECT_EQ(report.at("check").at("genus"), 256);
  for (const std::string key : {"volume", "area"}) {
    const double expected = whole.at("check").at(key).get<double>();
    EXPECT_NEAR(report.at("check").at(key).get<double>(), expected, 1e-6 * expected) << key;
  }
  for (const std::string tiles : {"1", "3", "8"}) {
    EXPECT_TRUE(united(files, in_pieces({"--tiles", tiles})).second == bytes) << tiles;
  }
  EXPECT_TRUE(united(files, in_pieces({"--memory", "6MB"})).second == bytes);
  EXPECT_TRUE(united({files.rbegin(), files.rend()}, in_pieces()).second == bytes);
  std::vector<std::string> without{"union", "-o", "out.stl", "--memory", "6MB"};
  without.insert(without.end(), files.begin(), files.end());
  EXPECT_EQ(dupin(without).exit_code, 3);
  const auto [of_whole_ply, whole_ply] = united(files, {"--format", "ply"});
  const auto [of_ply, ply] = united(files, in_pieces({"--format", "ply"}));
  EXPECT_EQ(of_ply.at("check").at("genus"), 256);
  EXPECT_EQ(ply.find("label") == std::string::npos, whole_ply.find("label") == std::string::npos);
  EXPECT_TRUE(united(files, in_pieces({"--format", "ply", "--tiles", "4"})).second == ply);
}

// Each operand is read for every piece that it reaches into.
TEST_F(DividedUnion, mends_every_operand_once) {
  auto files = put_rack(17);
  TriMesh twice = bar(0, 5, -20, 48 * 17 - 24);
  for (int i = 0; i < 2; ++i) {
    twice.triangles.push_back(twice.triangles.front());
  }
  std::swap(twice.triangles.back()[0], twice.triangles.back()[1]);
  put(files[10], twice);
  const auto [whole, whole_bytes] = united(files, {"--repair"});
  const auto [report, bytes] = united(files, in_pieces({"--repair", "--tiles", "2"}));
  EXPECT_FALSE(bytes == whole_bytes);
  EXPECT_EQ(report.at("repairs"), whole.at("repairs"));
  EXPECT_EQ(report.at("repairs").size(), 1U);
}

TEST_F(DividedUnion, names_the_operand_that_is_no_solid) {
  auto files = put_rack(17);
  TriMesh open = bar(1, 5, -20, 48 * 17 - 24);
  open.triangles.erase(open.triangles.begin());
  put(files[11], open);
  files.insert(files.begin(), "union");
  files.insert(files.end(), {"-o", "out.stl", "--piece", "9000", "--tiles", "2"});
  const ProcessResult result = dupin(files);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr(files[12]));
}

TEST_F(DividedUnion, is_not_cut_where_an_operand_can_be_read_only_once) {
  const auto files = put_rack(17);
  const auto whole = united(files, {}).second;
  std::string line = "dupin union --quiet --piece 9000 -o of_pipes.stl <(cat " + files[0] + ")";
  for (std::size_t i = 1; i < files.size(); ++i) {
    line += " " + files[i];
  }
  const ProcessResult result = shell(line);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(folder_.read("of_pipes.stl") == whole);
}

// A bow that a plane goes through twice is more than one pipe there.
TEST_F(DividedUnion, is_not_cut_where_pieces_do_not_fit) {
  auto files = put_rack(17);
  const double end = 48 * 17 - 24;
  std::vector<Solid> parts{Solid::from(bar(0, 5, -20, end)),
                           Solid::from(moved(bar(0, 5, -20, end), Vec3(0, 0, 200))),
                           Solid::from(box({-15, 48 * 5 - 5, 0}, {-10, 48 * 5 + 5, 200}))};
  const Solid bow = unite(parts);
  put(files[10], {bow.nearest_points(), bow.triangles(), {}, {}});
  const auto [whole, whole_bytes] = united(files, {});
  const auto [report, bytes] = united(files, in_pieces());
  EXPECT_FALSE(bytes == whole_bytes);
  EXPECT_EQ(report.at("check").at("genus"), whole.at("check").at("genus"));
  EXPECT_EQ(json({"check", "out.stl"}, 0).at("genus"), whole.at("check").at("genus"));
  EXPECT_TRUE(united(files, in_pieces({"--tiles", "5"})).second == bytes);
}

}  // namespace
}  // namespace dupin::test
