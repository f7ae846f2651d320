#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/vtu.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

using TiledBuild = Tool;

// Lines of pipes of two sizes with branches, each apart from the next, far from the origin.
std::string plant(int lines) {
  std::string text = R"({"units": "mm", "tolerance": 0.5, "parts": [)";
  for (int i = 0; i < lines; ++i) {
    const std::string n = std::to_string(i), y = std::to_string(1000 * i + 7 * (i % 3));
    text += (i == 0 ? "" : ",");
    text += R"({"name": "run)" + n + R"(", "pipe": {"from": [200000.1, )" + y +
            R"(, 0.3], "to": [201000, )" + y + R"(, 20], "radius": 100}},)" +
            R"({"name": "branch)" + n + R"(", "pipe": {"from": [200500, )" + y +
            R"(, 10], "to": [200510, )" + y + R"(, 300], "radius": 100}})";
  }
  return text + "]}";
}

TEST_F(TiledBuild, gives_the_same_bytes_for_all_numbers_of_tiles) {
  folder_.write("plant.json", plant(20));
  for (const std::string region : {"outer", "metal", "fluid"}) {
    const std::vector<std::string> common{"--region", region, "--wall", "8mm"};
    const auto build = [&](std::vector<std::string> own) {
      own.insert(own.begin(), {"build", "plant.json", "-o", "out.stl"});
      own.insert(own.end(), common.begin(), common.end());
      const auto report = json(own, 0);
      EXPECT_EQ(report.at("output").at("check").at("solid"), true);
      EXPECT_EQ(report.at("output").at("check").at("components"), 20);
      return folder_.read("out.stl");
    };
    const std::string whole = build({});
    EXPECT_GT(whole.size(), 50000);
    for (const std::string tiles : {"1", "3", "8", "64"}) {
      EXPECT_TRUE(build({"--tiles", tiles}) == whole) << region << " " << tiles;
    }
    EXPECT_TRUE(build({"--memory", "2MB"}) == whole) << region;
    EXPECT_EQ(shell("taskset -cp 0 $BASHPID > /dev/null; dupin build plant.json -o out.stl --quiet "
                    "--tiles 5 --wall 8mm "
                    "--region " +
                    region)
                  .exit_code,
              0);
    EXPECT_TRUE(folder_.read("out.stl") == whole) << region << " on one core";
  }
  EXPECT_EQ(json({"check", "out.stl"}, 0).at("solid"), true);
}

// With normals, which are those of the whole's surfaces, and colours.
TEST_F(TiledBuild, gives_the_same_bytes_of_ply) {
  std::string text = plant(12);
  for (std::size_t i = 0; (i = text.find("{\"name\": \"run", i)) != std::string::npos; i += 30) {
    text.insert(i + 1, R"("colour": "#1020)" + std::to_string(10 + i % 80) + R"(", )");
  }
  folder_.write("plant.json", text);
  for (const std::string region : {"outer", "metal", "fluid"}) {
    std::vector<std::string> command{"build", "plant.json", "-o",   "out.ply",  "--wall",
                                     "8mm",   "--region",   region, "--origin", "auto"};
    EXPECT_EQ(json(command, 0).at("output").at("format"), "binary PLY");
    const std::string whole = folder_.read("out.ply");
    for (const std::string part : {"property float nx", "dupin_point", "property uchar red"}) {
      EXPECT_THAT(whole.substr(0, 20'000), HasSubstr(part));
    }
    command.insert(command.end(), {"--tiles", ""});
    for (const std::string tiles : {"1", "3", "8", "64"}) {
      command.back() = tiles;
      EXPECT_EQ(json(command, 0).at("output").at("format"), "binary PLY");
      EXPECT_TRUE(folder_.read("out.ply") == whole) << region << " " << tiles;
    }
  }
  const std::vector<std::string> kept{"build", "plant.json", "-o", "out.ply", "--cache", "kept"};
  const auto built = [&](std::vector<std::string> command) {
    EXPECT_EQ(dupin(command).exit_code, 0);
    return folder_.read(command[3]);
  };
  const std::string ply = built({"build", "plant.json", "-o", "out.ply"});
  const std::string stl = built({"build", "plant.json", "-o", "out.stl"});
  for (int round = 0; round < 2; ++round) {
    EXPECT_TRUE(built(kept) == ply);
    EXPECT_TRUE(built({"build", "plant.json", "-o", "out.stl", "--cache", "kept"}) == stl);
  }
}

// An end that is called as its part is part of that patch.
TEST_F(TiledBuild, names_each_patch_once) {
  folder_.write("plant.json", R"({"units": "mm", "tolerance": 0.1, "patches": {"a.end": "a"},
      "parts": [{"name": "a", "pipe": {"from": [0, 0, 0], "to": [20, 0, 0], "radius": 2}}]})");
  const auto ply = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"build", "plant.json", "-o", "out.ply"});
    EXPECT_EQ(dupin(more).exit_code, 0);
    return folder_.read("out.ply");
  };
  const std::string whole = ply({"--patches", "patches.json"});
  EXPECT_TRUE(ply({"--tiles", "1"}) == whole);
  EXPECT_EQ(whole.find("comment label a\n"), whole.rfind("comment label a\n"));
  const auto patches = nlohmann::json::parse(folder_.read("patches.json")).at("patches");
  EXPECT_EQ(patches.size(), 2) << patches;
}

TEST_F(TiledBuild, writes_a_file_of_vtk_for_each_tile) {
  folder_.write("plant.json", plant(7));
  const std::vector<std::string> command{"build", "plant.json", "-o", "out.pvtu"};
  const auto report = json(command, 0);
  EXPECT_EQ(report.at("output").at("format"), "VTK pieces");
  EXPECT_EQ(folder_.files(), (std::vector<std::string>{"out.pvtu", "out_0.vtu", "plant.json"}));
  std::vector<std::string> in_tiles = command;
  in_tiles.insert(in_tiles.end(), {"--tiles", "3", "--quiet"});
  EXPECT_EQ(dupin(in_tiles).exit_code, 0);
  EXPECT_EQ(folder_.files(), (std::vector<std::string>{"out.pvtu", "out_0.vtu", "out_1.vtu",
                                                       "out_2.vtu", "plant.json"}));
  std::size_t triangles = 0;
  for (const std::string file : {"out_0.vtu", "out_1.vtu", "out_2.vtu"}) {
    EXPECT_THAT(folder_.read("out.pvtu"), HasSubstr("<Piece Source=\"" + file + "\"/>"));
    triangles += read_vtu(folder_.read(file), file).surface.triangles.size();
  }
  EXPECT_EQ(report.at("output").at("check").at("triangles"), triangles);
  EXPECT_EQ(dupin({"build", "plant.json", "-o", "none/out.pvtu"}).exit_code, 5);
  EXPECT_EQ(dupin({"build", "plant.json", "-o", "-", "--format", "pvtu"}).exit_code, 2);
  EXPECT_EQ(dupin({"build", "plant.json", "-o", "/dev/null", "--format", "pvtu"}).exit_code, 2);
  EXPECT_EQ(dupin({"build", "plant.json", "-o", "a.pvtu", "--patches", "a.json"}).exit_code, 2);
  EXPECT_EQ(folder_.files().size(), 5);
}

TEST_F(TiledBuild, shares_the_automatic_origin) {
  folder_.write("plant.json", plant(5));
  const auto whole = json({"build", "plant.json", "-o", "a.stl", "--origin", "auto"}, 0);
  const auto tiled =
      json({"build", "plant.json", "-o", "b.stl", "--origin", "auto", "--tiles", "3"}, 0);
  EXPECT_EQ(whole.at("output").at("rounding").at("origin"),
            tiled.at("output").at("rounding").at("origin"));
  EXPECT_GT(whole.at("output").at("rounding").at("origin").at(0), 100000);
  EXPECT_TRUE(folder_.read("a.stl") == folder_.read("b.stl"));
}

TEST_F(TiledBuild, of_what_hangs_together_is_that_of_the_whole) {
  for (const std::string name : {"header.json", "tee.json", "vessel.json", "plant-run.json"}) {
    const ProcessResult whole = dupin({"build", example(name), "-o", "a.stl", "--quiet"}),
                        tiled = dupin(
                            {"build", example(name), "-o", "b.stl", "--quiet", "--tiles", "8"});
    EXPECT_EQ(whole.exit_code, tiled.exit_code) << name;
    EXPECT_TRUE(folder_.read("a.stl") == folder_.read("b.stl")) << name;
  }
}

TEST_F(TiledBuild, goes_on_with_what_is_kept) {
  folder_.write("plant.json", plant(12));
  folder_.write("edited.json", [] {
    std::string text = plant(12);
    const std::string from = R"({"name": "branch7")";
    return text.replace(text.find(from), from.size(), R"({"wall": 5, "name": "branch7")");
  }());
  const auto build = [&](const std::string& document, bool with_cache) {
    std::vector<std::string> arguments{"build",    document, "-o",     "out.stl",
                                       "--region", "fluid",  "--wall", "8mm"};
    if (with_cache) {
      arguments.insert(arguments.end(), {"--cache", "kept"});
    }
    const auto report = json(arguments, 0);
    return std::pair(report, folder_.read("out.stl"));
  };
  const auto kept = [&] {
    const auto folder = std::filesystem::directory_iterator(folder_.path() / "kept");
    return std::distance(begin(folder), end(folder)) - 1;  // less the mark
  };
  const auto [plain, bytes] = build("plant.json", false);
  for (int i = 0; i < 2; ++i) {
    const auto [report, again] = build("plant.json", true);
    EXPECT_TRUE(again == bytes);
    EXPECT_EQ(kept(), 12);
    EXPECT_EQ(report.at("parts"), plain.at("parts"));
    EXPECT_EQ(report.at("output").at("rounding"), plain.at("output").at("rounding"));
    EXPECT_EQ(report.at("output").at("check").at("triangles"),
              plain.at("output").at("check").at("triangles"));
    EXPECT_NEAR(report.at("output").at("check").at("volume").get<double>(),
                plain.at("output").at("check").at("volume").get<double>(), 1);
  }
  const std::string edited = build("edited.json", false).second;
  EXPECT_FALSE(edited == bytes);
  EXPECT_TRUE(build("edited.json", true).second == edited);
  EXPECT_EQ(kept(), 13) << "one district is another";
  EXPECT_TRUE(build("plant.json", true).second == bytes);
}

TEST_F(TiledBuild, makes_again_what_is_damaged) {
  folder_.write("plant.json", plant(3));
  const std::vector<std::string> arguments{"build",   "plant.json", "-o",
                                           "out.stl", "--cache",    "kept"};
  ASSERT_EQ(dupin(arguments).err, "");
  const std::string bytes = folder_.read("out.stl");
  int number = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "kept")) {
    const std::string name = "kept/" + entry.path().filename().string();
    std::string text = folder_.read(name);
    switch (number++ % 3) {
      case 0:
        text.resize(text.size() / 2);
        break;
      case 1:
        text[text.size() / 2] ^= 1;
        break;
      default:
        text.clear();
    }
    folder_.write(name, text);
  }
  EXPECT_EQ(number, 4);
  const ProcessResult again = dupin(arguments);
  ASSERT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.err, HasSubstr("an entry of --cache was of no use"));
  EXPECT_THAT(again.err, HasSubstr("is damaged"));
  EXPECT_TRUE(folder_.read("out.stl") == bytes);
  EXPECT_EQ(dupin(arguments).err, "") << "they were made again";
}

TEST_F(TiledBuild, does_without_an_entry_that_cannot_be_replaced) {
  folder_.write("plant.json", plant(2));
  const std::vector<std::string> arguments{"build",   "plant.json", "-o",
                                           "out.stl", "--cache",    "kept"};
  ASSERT_EQ(dupin(arguments).exit_code, 0);
  const std::string bytes = folder_.read("out.stl");
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "kept")) {
    if (entry.path().filename() != "dupin-cache") {
      std::filesystem::remove(entry.path());
      std::filesystem::create_directories(entry.path() / "sub");
    }
  }
  const ProcessResult again = dupin(arguments);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("is no regular file; and 1 more"));
  EXPECT_TRUE(folder_.read("out.stl") == bytes);
}

TEST_F(TiledBuild, keeps_nothing_where_other_things_are) {
  folder_.write("plant.json", plant(1));
  const ProcessResult result =
      dupin({"build", "plant.json", "-o", "out.stl", "--cache", folder_.path().string()});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.err, HasSubstr("has other things in it"));
  EXPECT_EQ(folder_.files(), std::vector<std::string>{"plant.json"});
  const ProcessResult file =
      dupin({"build", "plant.json", "-o", "out.stl", "--cache", "plant.json/kept"});
  EXPECT_EQ(file.exit_code, 5);
}

// Nearly all triangles of a rack are where pipes cross.
TEST_F(TiledBuild, refuses_crossings_that_do_not_fit_into_memory) {
  std::string parts;
  for (int i = 0; i < 6; ++i) {
    const auto pipe = [&](const std::string& name, const std::string& from, const std::string& to) {
      parts += (parts.empty() ? "" : ",") + std::string(R"({"name": ")") + name +
               std::to_string(i) + R"(", "pipe": {"radius": 30, "from": [)" + from +
               R"(], "to": [)" + to + "]}}";
    };
    const std::string at = std::to_string(100 * i);
    pipe("a", "0," + at + ",0", "600," + at + ",3");
    pipe("b", at + ",-50,0", at + ",550,2");
  }
  folder_.write("rack.json", R"({"units": "mm", "tolerance": 0.05, "parts": [)" + parts + "]}");
  const auto needed = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"build", "rack.json", "-o", "out.stl", "--memory", "1MB"});
    const ProcessResult result = dupin(more);
    EXPECT_EQ(result.exit_code, 3) << result.err;
    const std::size_t place = result.err.find("has about ");
    EXPECT_NE(place, std::string::npos) << result.err;
    return std::stod(result.err.substr(place + 10));
  };
  const auto triangles = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"build", "rack.json", "-o", "out.stl", "--memory", "100MB"});
    return json(more, 0).at("output").at("check").at("triangles").get<double>();
  };
  for (const std::vector<std::string>& more :
       {std::vector<std::string>(), std::vector<std::string>{"--wall", "5"}}) {
    const double made = triangles(more), expected = needed(more);
    EXPECT_GT(expected, .9 * made);
    EXPECT_LT(expected, (more.empty() ? 2 : 4) * made);
  }
}

// Elbows that nearly coincide: each triangle meets some of the other's, which boxes do not tell.
TEST_F(TiledBuild, counts_crossings_when_they_are_found) {
  std::string parts;
  for (int i = 0; i < 2; ++i) {
    const double angle = 0.0065 * i, x = std::cos(angle), y = std::sin(angle);
    const auto point = [&](double a, double b) {
      return "[" + std::to_string(100 * (a * x - b * y)) + ", " +
             std::to_string(100 * (a * y + b * x)) + ", " + std::to_string(0.0003 * i) + "]";
    };
    parts += R"({"name": "elbow)" + std::to_string(i) + R"(", "elbow": {"from": )" + point(1, 0) +
             R"(, "corner": )" + point(1, 1) + R"(, "to": )" + point(0, 1) + R"(, "radius": 20}},)";
  }
  for (int i = 0; i < 9; ++i) {
    parts += R"({"name": "pipe)" + std::to_string(i) + R"(", "pipe": {"from": [0, 0, )" +
             std::to_string(1000 + 100 * i) + R"(], "direction": [1, 0, 0], "length": 9, )" +
             R"("radius": 30}})" + (i < 8 ? "," : "");
  }
  folder_.write("elbows.json", R"({"units": "mm", "tolerance": 0.05, "parts": [)" + parts + "]}");
  const std::vector<std::string> build{"build", "elbows.json", "-o", "out.stl"};
  const auto with = [&](const std::string& memory) {
    std::vector<std::string> all = build;
    all.insert(all.end(), {"--memory", memory});
    return dupin(all);
  };
  const ProcessResult refused = with("20MB");
  EXPECT_EQ(refused.exit_code, 3) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("pairs meet, would need about "));
  EXPECT_THAT(refused.err, HasSubstr("allowed are 20 MB; give --memory more, or a coarser"));
  EXPECT_EQ(folder_.files(), std::vector<std::string>{"elbows.json"});
  // What it asks for does, whatever shares its tile at first.
  const std::string said = "would need about ";
  std::string memory = refused.err.substr(refused.err.find(said) + said.size());
  memory = memory.substr(0, memory.find(" MB")) + "MB";
  ASSERT_EQ(with(memory).exit_code, 0) << memory;
  const std::string made = folder_.read("out.stl");
  ASSERT_EQ(dupin(build).exit_code, 0);
  EXPECT_TRUE(folder_.read("out.stl") == made);
}

// Not only for the first one that does not fit.
TEST_F(TiledBuild, names_memory_that_would_do) {
  folder_.write("pipes.json", R"({"units": "mm", "tolerance": 0.5, "parts": [
    {"name": "thin", "pipe": {"from": [0, 0, 0], "to": [100, 0, 0], "radius": 10}},
    {"name": "wide", "pipe": {"from": [0, 0, 9000], "to": [100, 0, 9000], "radius": 1000}}]})");
  const ProcessResult refused = dupin({"build", "pipes.json", "-o", "out.stl", "--memory", "1kB"});
  EXPECT_EQ(refused.exit_code, 3);
  const std::string said = "which need at least ";
  const std::size_t at = refused.err.find(said);
  ASSERT_NE(at, std::string::npos) << refused.err;
  std::string memory = refused.err.substr(at + said.size());
  memory = memory.substr(0, memory.find(';'));
  std::erase(memory, ' ');
  EXPECT_EQ(dupin({"build", "pipes.json", "-o", "out.stl", "--memory", memory}).exit_code, 0)
      << memory;
}

TEST_F(TiledBuild, refuses_what_does_not_fit_into_memory) {
  folder_.write("plant.json", plant(2));
  const ProcessResult result = dupin({"build", "plant.json", "-o", "out.stl", "--memory", "10kB"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("give --memory more"));
  EXPECT_EQ(folder_.files(), std::vector<std::string>{"plant.json"});
}

// What a document may cost together was asked of each district only, and of none that was kept.
TEST_F(TiledBuild, refuses_more_triangles_than_are_allowed_of_all) {
  folder_.write("plant.json", plant(20));
  const std::string refusal =
      dupin({"build", "plant.json", "-o", "out.stl", "--triangles", "900"}).err;
  EXPECT_THAT(refusal, HasSubstr("the limit is 900"));
  EXPECT_EQ(dupin({"build", "plant.json", "-o", "out.stl", "--cache", "kept"}).exit_code, 0);
  for (const std::vector<std::string>& tiles :
       {std::vector<std::string>{"--tiles", "3"}, {"--memory", "1GB"}, {"--cache", "kept"}}) {
    const ProcessResult result =
        dupin({"build", "plant.json", "-o", "none.stl", "--triangles", "900", tiles[0], tiles[1]});
    EXPECT_EQ(result.exit_code, 3) << tiles[0];
    EXPECT_EQ(result.err, refusal) << tiles[0];
  }
  EXPECT_THAT(folder_.files(), testing::Not(testing::Contains("none.stl")));
}

TEST_F(TiledBuild, leaves_no_file_where_a_district_is_refused) {
  folder_.write("plant.json", plant(3));
  const ProcessResult result =
      dupin({"build", "plant.json", "-o", "out.stl", "--tiles", "3", "--wall", "120mm"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, HasSubstr("run0"));
  EXPECT_EQ(folder_.files(), std::vector<std::string>{"plant.json"});
}

TEST_F(TiledBuild, says_that_a_file_cannot_be_written) {
  folder_.write("plant.json", plant(2));
  for (const std::string path : {"none/out.stl", "/dev/full"}) {
    for (const std::string format : {"stl", "ply"}) {
      const ProcessResult result =
          dupin({"build", "plant.json", "-o", path, "--format", format, "--tiles", "2"});
      EXPECT_EQ(result.exit_code, 5) << result.err;
    }
  }
}

// Numbers that are large only as seen from the origin move by more than their own size tells.
TEST_F(TiledBuild, stays_in_its_boxes_whatever_the_origin) {
  folder_.write("plant.json", plant(3));
  for (const std::string origin : {"3e8,0,0", "-1e9,0,0"}) {
    const auto build = [&](const std::string& path, const std::vector<std::string>& options) {
      std::vector<std::string> arguments{"build", "plant.json", "-o", path, "--origin", origin};
      arguments.insert(arguments.end(), options.begin(), options.end());
      return dupin(arguments).exit_code;
    };
    EXPECT_EQ(build("a.stl", {}), 0) << origin;
    EXPECT_EQ(build("b.stl", {"--tiles", "3"}), 0) << origin;
    EXPECT_TRUE(folder_.read("a.stl") == folder_.read("b.stl")) << origin;
  }
}

TEST_F(TiledBuild, says_what_it_cannot_do) {
  folder_.write("plant.json", plant(1));
  const auto refused = [this](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"build", "plant.json"});
    const ProcessResult result = dupin(arguments);
    EXPECT_EQ(result.exit_code, 2);
    return result.err;
  };
  EXPECT_THAT(refused({"-o", "a.off", "--tiles", "2"}),
              HasSubstr("binary STL, binary PLY and .pvtu files only"));
  for (const std::string file : {"a.step", "a.msh", "a.vtu"}) {
    EXPECT_THAT(refused({"-o", file, "--tiles", "2"}), HasSubstr(".pvtu files only")) << file;
  }
  EXPECT_THAT(refused({"-o", "-", "--format", "stl", "--memory", "1GB"}),
              HasSubstr("binary STL, binary PLY and .pvtu files only"));
  EXPECT_THAT(refused({"-o", "a.stl", "--memory", "much"}), HasSubstr("500MB or 4GB"));
  EXPECT_THAT(refused({"-o", "a.stl", "--memory", "-1GB"}), HasSubstr("500MB or 4GB"));
  EXPECT_THAT(refused({"-o", "a.stl", "--memory", "1GB", "--tiles", "2"}), HasSubstr("exclude"));
  EXPECT_THAT(refused({"-o", "a.stl", "--cache-size", "1GB"}), HasSubstr("--cache"));
  EXPECT_THAT(refused({"-o", "a.stl", "--cache", "c", "--cache-size", "1"}),
              HasSubstr("--cache-size takes a size"));
  EXPECT_THAT(refused({"-o", "a.stl", "--tiles", "2", "--patches", "p.json"}),
              HasSubstr("--patches"));
  EXPECT_THAT(refused({"-o", "a.stl", "--tiles", "2", "--verify", "full"}), HasSubstr("check"));
}

}  // namespace
}  // namespace dupin::test
