#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/vtu.h"
#include "dupin/kernel/check.h"

namespace dupin::test {
namespace {

using DividedBuild = Tool;

// Two headers, and lines of pipes, elbows and filleted branches from one to the other: all hangs
// together, in many rings.
std::string connected(int lines, const std::string& more = "") {
  std::string text = R"({"units": "mm", "tolerance": 0.5)" + more + R"(, "parts": [)";
  for (int i = 0; i < lines; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1),
                      x = std::to_string(600 * i + 300);
    for (const auto& [name, place] :
         {std::pair<std::string, std::string>("h", "0, 0"), {"g", "1180, 780"}}) {
      text += i == 0 ? R"({"name": ")" + name + R"(0", "pipe": {"from": [0, )" + place +
                           R"(], "to": [600, )" + place + R"(], "radius": 100}})"
                     : R"({"name": ")" + name + n + R"(", "pipe": {"from": ")" + name + before +
                           R"(.end", "length": 600}})";
      text += ",";
    }
    text += R"({"name": "b)" + n + R"(", "pipe": {"from": [)" + x + R"(, 0, 0], "to": [)" + x +
            R"(, 0, 600], "radius": 60}},{"name": "e)" + n + R"(", "elbow": {"from": "b)" + n +
            R"(.end", "bend_radius": 180, "angle": 90, "toward": [0, 1, 0]}},{"name": "p)" + n +
            R"(", "pipe": {"from": "e)" + n + R"(.end", "length": 1000}},{"name": "n)" + n +
            R"(", "pipe": {"on": "p)" + n +
            R"(", "at": 400, "direction": [0, 0, 1], "length": 200, "radius": 30}},{"name": "f)" +
            n + R"(", "fillet": {"between": ["p)" + n + R"(", "n)" + n + R"("], "radius": 8}})" +
            (i + 1 < lines ? "," : "");
  }
  return text + "]}";
}

// What is made of a document, of which so many holes are known.
struct Made {
  std::string keys, region;
  int genus;
  std::vector<std::string> pieces;
};

TEST_F(DividedBuild, gives_the_same_bytes_of_what_hangs_together_in_pieces) {
  for (const auto& [keys, region, genus, pieces] :
       {Made{"", "outer", 11, {"5000", "9000"}},
        {R"(, "wall": 5)", "metal", 37, {"20000"}},
        {R"(, "wall": 5)", "fluid", 11, {"9000"}},
        {R"(, "wall": 5)", "outer", 11, {"9000"}},
        {R"(, "insulation": 40)", "insulation", 37, {"9000"}}}) {
    folder_.write("plant.json", connected(12, keys));
    const auto build = [&](std::vector<std::string> own) {
      own.insert(own.begin(), {"build", "plant.json", "-o", "out.stl", "--region", region});
      const auto report = json(own, 0);
      return std::pair(report, folder_.read("out.stl"));
    };
    const auto [whole, whole_bytes] = build({});
    for (const std::string& piece : pieces) {
      const auto [report, bytes] = build({"--piece", piece});
      EXPECT_FALSE(bytes == whole_bytes);
      const auto &check = report.at("output").at("check"),
                 &of_whole = whole.at("output").at("check");
      for (const std::string key : {"solid", "components", "euler_number", "genus"}) {
        EXPECT_EQ(check.at(key), of_whole.at(key)) << region << " " << key;
      }
      EXPECT_EQ(check.at("components"), 1);
      EXPECT_EQ(check.at("genus"), genus) << region;
      for (const std::string key : {"volume", "area"}) {
        const double expected = of_whole.at(key).get<double>();
        EXPECT_NEAR(check.at(key).get<double>(), expected, 1e-6 * expected) << region << " " << key;
      }
      EXPECT_EQ(report.at("parts").size(), whole.at("parts").size());
      EXPECT_EQ(report.at("runs"), whole.at("runs"));
      const auto again = json({"check", "out.stl"}, 0);
      EXPECT_EQ(again.at("solid"), true);
      for (const std::string key : {"points", "triangles", "components", "euler_number"}) {
        EXPECT_EQ(again.at(key), check.at(key)) << region << " " << key;
      }
      for (const std::string tiles : {"1", "3", "8"}) {
        EXPECT_TRUE(build({"--piece", piece, "--tiles", tiles}).second == bytes)
            << region << " " << tiles;
      }
      EXPECT_EQ(
          shell("taskset -cp 0 $BASHPID > /dev/null; dupin build plant.json -o out.stl --quiet "
                "--tiles 5 --piece " +
                piece + " --region " + region)
              .exit_code,
          0);
      EXPECT_TRUE(folder_.read("out.stl") == bytes) << region << " on one core";
      for (int round = 0; round < 2; ++round) {
        const auto kept = build({"--piece", piece, "--cache", "kept"});
        EXPECT_TRUE(kept.second == bytes) << region;
        EXPECT_EQ(kept.first.at("output").at("check"), check) << region;
      }
    }
  }
}

// Points of rings once, with the normals that the whole has there.
TEST_F(DividedBuild, gives_the_same_bytes_of_ply_in_pieces) {
  for (const std::string keys : {"", R"(, "wall": 5)"}) {
    std::string text = connected(6, keys);
    text.replace(text.find(R"("name": "h3")"), 0, R"("colour": "#102030", )");
    folder_.write("plant.json", text);
    const auto build = [&](std::vector<std::string> own) {
      own.insert(own.begin(), {"build", "plant.json", "-o", "out.ply"});
      const auto report = json(own, 0);
      return std::pair(report.at("output").at("check"), folder_.read("out.ply"));
    };
    const auto element = [](const std::string& bytes) {
      const std::size_t at = bytes.find("element vertex");
      return bytes.substr(at, bytes.find('\n', at) - at);
    };
    const auto [whole, whole_bytes] = build({});
    const auto [check, bytes] = build({"--piece", "9000"});
    EXPECT_FALSE(bytes == whole_bytes);
    EXPECT_EQ(element(bytes), element(whole_bytes)) << "copies, too";
    const auto again = json({"check", "out.ply"}, 0);
    for (const std::string key :
         {"solid", "points", "triangles", "components", "euler_number", "genus"}) {
      EXPECT_EQ(check.at(key), whole.at(key)) << key;
      EXPECT_EQ(again.at(key), check.at(key)) << key;
    }
    for (const std::string tiles : {"1", "3", "8"}) {
      EXPECT_TRUE(build({"--piece", "9000", "--tiles", tiles}).second == bytes) << tiles;
    }
    EXPECT_EQ(shell("taskset -cp 0 $BASHPID > /dev/null; dupin build plant.json -o out.ply --quiet "
                    "--tiles 5 --piece 9000")
                  .exit_code,
              0);
    EXPECT_TRUE(folder_.read("out.ply") == bytes) << "on one core";
    for (int round = 0; round < 2; ++round) {
      EXPECT_TRUE(build({"--piece", "9000", "--cache", "kept"}).second == bytes);
    }
  }
}

// All pieces in one file: a solid. One in each: what its border is, the next one has, too.
TEST_F(DividedBuild, writes_files_of_vtk_in_pieces) {
  folder_.write("plant.json", connected(6, R"(, "wall": 5)"));
  const auto build = [&](std::vector<std::string> own) {
    own.insert(own.begin(), {"build", "plant.json", "-o", "out.pvtu"});
    return json(own, 0).at("output").at("check");
  };
  const auto surface = [&](const std::string& file) {
    return read_vtu(folder_.read(file), file).surface;
  };
  const auto whole = build({});
  const TriMesh undivided = surface("out_0.vtu");
  const auto names = [&] {  // a line each
    const std::string text = folder_.read("out_0.vtu");
    const std::size_t at = text.find("label_names");
    std::istringstream lines(text.substr(at, text.find("</", at) - at));
    std::set<std::string> result;
    for (std::string line; std::getline(lines, line);) {
      result.insert(line);
    }
    return result;
  };
  const std::set<std::string> names_before = names();
  EXPECT_GT(names_before.size(), 100);
  const auto of_pieces = build({"--piece", "9000"});
  for (const std::string key : {"solid", "points", "components", "euler_number", "genus"}) {
    EXPECT_EQ(of_pieces.at(key), whole.at(key)) << key;
  }
  const TriMesh divided = surface("out_0.vtu");
  EXPECT_EQ(divided.points.size(), whole.at("points"));
  EXPECT_EQ(names(), names_before) << "no ends of pieces";
  EXPECT_NE(divided.triangles, undivided.triangles);
  EXPECT_TRUE(check(divided).is_solid());
  EXPECT_EQ(build({"--piece", "9000", "--tiles", "3"}), of_pieces);
  std::size_t points = 0, triangles = 0;
  for (const std::string file : {"out_0.vtu", "out_1.vtu", "out_2.vtu"}) {
    points += surface(file).points.size();
    triangles += surface(file).triangles.size();
  }
  EXPECT_EQ(of_pieces.at("triangles"), triangles);
  EXPECT_GT(points, whole.at("points")) << "points of borders are in two files";
  EXPECT_EQ(build({"--piece", "9000", "--cache", "kept"}), of_pieces);
  EXPECT_EQ(build({"--piece", "9000", "--cache", "kept"}), of_pieces);
  EXPECT_EQ(surface("out_0.vtu").triangles, divided.triangles);
}

// A vessel, which encloses a void; and one with what is in no piece, but may be in the void.
TEST_F(DividedBuild, knows_what_pieces_enclose) {
  std::string text = R"({"units": "mm", "tolerance": 0.5, "wall": 5, "parts": [
      {"name": "p0", "pipe": {"from": [0, 0, 0], "to": [600, 0, 0], "radius": 100}})";
  for (int i = 1; i < 40; ++i) {
    text += R"(,{"name": "p)" + std::to_string(i) + R"(", "pipe": {"from": "p)" +
            std::to_string(i - 1) + R"(.end", "length": 600}})";
  }
  text += R"(,{"name": "a", "head": {"from": "p0.start", "form": "ellipsoidal"}},
             {"name": "b", "head": {"from": "p39.end", "form": "ellipsoidal"}})";
  const std::string ball = R"(,{"name": "ball", "sphere": {"center": [3200, 0, 0], "radius": 50},
                               "solid": true})";
  for (const std::string& more : {std::string(), ball}) {
    folder_.write("vessel.json", text + more + "]}");
    const auto bytes_of = [&](const std::string& piece) {
      const auto built = json({"build", "vessel.json", "-o", "out.stl", "--piece", piece}, 0);
      const auto shells = built.at("output").at("check").at("shells");
      EXPECT_EQ(shells.size(), more.empty() ? 2 : 3);
      const auto again = json({"check", "out.stl"}, 0).at("shells");
      std::multiset<int> depths, of_check;
      for (std::size_t i = 0; i < shells.size(); ++i) {
        depths.insert(shells.at(i).at("depth").get<int>());
        of_check.insert(again.at(i).at("depth").get<int>());
      }
      EXPECT_EQ(depths, of_check);
      return folder_.read("out.stl");
    };
    const auto ply_of = [&](const std::string& piece) {
      (void)json({"build", "vessel.json", "-o", "out.ply", "--piece", piece}, 0);
      return folder_.read("out.ply");
    };
    EXPECT_EQ(ply_of("3000") == ply_of("1000000"), !more.empty());
    EXPECT_EQ(bytes_of("3000") == bytes_of("1000000"), !more.empty())
        << "what is in doubt stays whole";
  }
}

TEST_F(DividedBuild, divides_what_does_not_fit_into_memory) {
  folder_.write("plant.json", connected(12));
  const ProcessResult whole =
      dupin({"build", "plant.json", "-o", "out.stl", "--memory", "2MB", "--piece", "1000000"});
  EXPECT_EQ(whole.exit_code, 3);
  EXPECT_EQ(dupin({"build", "plant.json", "-o", "out.stl", "--memory", "2MB", "--piece", "3000"})
                .exit_code,
            0);
  EXPECT_EQ(json({"check", "out.stl"}, 0).at("components"), 1);
}

// Pipes through each other, and a header of one pipe with filleted branches: there are no rings,
// and pipes are cut.
std::string crossing(int pipes, const std::string& more) {
  std::string text = R"({"units": "mm", "tolerance": 0.5)" + more + R"(, "parts": [)";
  const std::string length = std::to_string(300 * pipes - 150);
  for (int i = 0; i < pipes; ++i) {
    const std::string n = std::to_string(i), at = std::to_string(300 * i);
    text += (i == 0 ? "" : ",") + std::string(R"({"name": "x)") + n +
            R"(", "pipe": {"from": [-150, )" + at + R"(, 0], "to": [)" + length + "," + at +
            R"(, 0], "radius": 60}},{"name": "y)" + n + R"(", "pipe": {"from": [)" + at + "," +
            length + R"(, 10], "to": [)" + at + R"(, -150, 10], "radius": 50}})";
  }
  return text + "]}";
}

std::string branched(int branches, const std::string& more) {
  std::string text = R"({"units": "mm", "tolerance": 0.5)" + more +
                     R"(, "parts": [{"name": "h", "pipe": {"from": [-300, 0, 0], "to": [)" +
                     std::to_string(300 * branches) + R"(, 0, 0], "radius": 100}})";
  for (int i = 0; i < branches; ++i) {
    const std::string n = std::to_string(i), x = std::to_string(300 * i);
    text += R"(,{"name": "b)" + n + R"(", "pipe": {"from": [)" + x + R"(, 0, 0], "to": [)" + x +
            R"(, 0, 600], "radius": 60}},{"name": "f)" + n +
            R"(", "fillet": {"between": ["h", "b)" + n + R"("], "radius": 15}})";
  }
  return text + "]}";
}

TEST_F(DividedBuild, cuts_pipes_where_there_are_no_rings) {
  const std::string wall = R"(, "wall": 6)";
  for (const auto& [text, region, genus] :
       {std::tuple(crossing(17, ""), "outer", 256),
        {crossing(17, wall), "metal", 579},
        {crossing(17, wall), "fluid", 256},
        {crossing(17, R"(, "insulation": 20)"), "insulation", 579},
        {branched(33, ""), "outer", 0},
        {branched(33, wall), "metal", 34}}) {
    folder_.write("rack.json", text);
    const auto build = [&, of = std::string(region)](std::vector<std::string> own) {
      own.insert(own.begin(), {"build", "rack.json", "-o", "out.stl", "--region", of});
      const auto report = json(own, 0);
      return std::pair(report, folder_.read("out.stl"));
    };
    const auto [whole, whole_bytes] = build({});
    const auto [report, bytes] = build({"--piece", "3000"});
    EXPECT_FALSE(bytes == whole_bytes);
    const auto &check = report.at("output").at("check"), &of_whole = whole.at("output").at("check");
    EXPECT_EQ(check.at("components"), 1);
    EXPECT_EQ(check.at("genus"), genus) << region;
    EXPECT_EQ(of_whole.at("genus"), genus) << region;
    // Of fillets, whose meshes are others.
    const double share = genus == 0 || genus == 34 ? 3e-4 : 1e-7;
    for (const std::string key : {"volume", "area"}) {
      const double expected = of_whole.at(key).get<double>();
      EXPECT_NEAR(check.at(key).get<double>(), expected, share * expected) << region << " " << key;
    }
    ASSERT_EQ(report.at("parts").size(), whole.at("parts").size());
    for (std::size_t i = 0; i < report.at("parts").size(); ++i) {
      EXPECT_EQ(report.at("parts")[i].at("name"), whole.at("parts")[i].at("name"));
    }
    EXPECT_EQ(report.at("runs"), whole.at("runs"));
    EXPECT_EQ(report.at("gaps"), whole.at("gaps"));
    EXPECT_EQ(json({"check", "out.stl"}, 0).at("solid"), true);
    EXPECT_TRUE(build({"--piece", "3000", "--tiles", "3"}).second == bytes) << region;
    for (int round = 0; round < 2; ++round) {
      EXPECT_TRUE(build({"--piece", "3000", "--cache", "kept"}).second == bytes) << region;
    }
  }
}

TEST_F(DividedBuild, names_no_cuts_in_ply) {
  folder_.write("rack.json", crossing(17, ""));
  const auto ply = [&](std::vector<std::string> own) {
    own.insert(own.begin(), {"build", "rack.json", "-o", "out.ply"});
    const auto check = json(own, 0).at("output").at("check");
    const std::string bytes = folder_.read("out.ply");
    std::istringstream lines(bytes.substr(0, bytes.find("end_header")));
    std::set<std::string> names;
    for (std::string line; std::getline(lines, line);) {
      names.insert(line.starts_with("comment label") ? line : "");
    }
    return std::tuple(check, bytes, names);
  };
  const auto [of_whole, whole_bytes, whole_names] = ply({});
  const auto [check, bytes, names] = ply({"--piece", "3000"});
  EXPECT_EQ(check.at("genus"), of_whole.at("genus"));
  EXPECT_EQ(names, whole_names);
  EXPECT_GT(names.size(), 3 * 34);
  EXPECT_TRUE(std::get<1>(ply({"--piece", "3000", "--tiles", "8"})) == bytes);
}

TEST_F(DividedBuild, cuts_what_would_not_fit_into_memory) {
  folder_.write("rack.json", crossing(17, ""));
  const std::vector<std::string> build{"build", "rack.json", "-o", "out.stl", "--memory", "4MB"};
  EXPECT_EQ(dupin(build).exit_code, 3);
  std::vector<std::string> in_pieces = build;
  in_pieces.insert(in_pieces.end(), {"--piece", "3000"});
  EXPECT_EQ(dupin(in_pieces).exit_code, 0);
}

// Rings whose points are hardly apart from each other in floats: discs come out differently.
TEST_F(DividedBuild, does_not_divide_where_pieces_do_not_fit) {
  std::string text = R"({"units": "mm", "tolerance": 0.5, "segments": 600, "parts": [)";
  for (int i = 0; i < 33; ++i) {
    const std::string n = std::to_string(i);
    text += i == 0 ? R"({"name": "p0", "pipe": {"from": [200000.1, 0.3, 0.7],
                         "to": [200200.3, 7, 3], "radius": 1}})"
                   : R"(,{"name": "p)" + n + R"(", "pipe": {"from": "p)" + std::to_string(i - 1) +
                         R"(.end", "length": 200.1}})";
  }
  folder_.write("thin.json", text + "]}");
  const auto bytes = [&](std::vector<std::string> own) {
    own.insert(own.begin(), {"build", "thin.json", "-o", "out.stl"});
    EXPECT_EQ(json(own, 0).at("output").at("check").at("components"), 1);
    return folder_.read("out.stl");
  };
  for (const std::string piece : {"1000", "5000"}) {
    const std::string divided = bytes({"--piece", piece});
    EXPECT_TRUE(bytes({"--piece", piece, "--tiles", "5"}) == divided);
    EXPECT_TRUE(bytes({}) == divided) << "there is no piece that fits";
  }
  // Entries of the pieces that did not fit are told, too.
  const std::vector<std::string> cached{"build",   "thin.json", "-o",      "out.stl",
                                        "--piece", "5000",      "--cache", "kept"};
  EXPECT_EQ(dupin(cached).err, "");
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "kept")) {
    names.push_back("kept/" + entry.path().filename().string());
  }
  std::erase(names, "kept/dupin-cache");
  EXPECT_GT(names.size(), 2);
  std::map<std::string, std::string> kept;
  for (const std::string& name : names) {
    kept[name] = folder_.read(name);
    folder_.write(name, "");
  }
  const std::string others = "and " + std::to_string(names.size() - 1) + " more";
  EXPECT_THAT(dupin(cached).err, testing::HasSubstr(others));
  for (const std::string& name : names) {
    EXPECT_TRUE(folder_.read(name) == kept[name]) << "the same bytes";
  }
  EXPECT_EQ(json({"check", "out.stl"}, 0).at("solid"), true);
}

TEST_F(DividedBuild, divides_only_what_is_written_and_not_looked_at) {
  folder_.write("plant.json", connected(6));
  const auto build = [&](std::vector<std::string> own, const std::string& path = "out.stl") {
    own.insert(own.begin(), {"build", "plant.json", "-o", path});
    EXPECT_EQ(dupin(own).exit_code, 0);
    return folder_.read(path);
  };
  const std::string whole = build({});
  EXPECT_FALSE(build({"--piece", "1"}) == whole);
  EXPECT_TRUE(build({"--piece", "1", "--patches", "p.json"}) == whole);
  EXPECT_TRUE(build({"--piece", "1", "--verify", "full"}) == whole);
  EXPECT_TRUE(build({"--piece", "1"}, "a.off") == build({}, "b.off"));
}

}  // namespace
}  // namespace dupin::test
