#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/check.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

using Build = Tool;

constexpr const char* kTwoPipes = R"({"units": "in", "tolerance": 0.005, "parts": [
  {"name": "a", "pipe": {"from": [0, 0, 0], "to": [4, 0, 0], "radius": 1}},
  {"name": "b", "pipe": {"from": [4.0078125, 0, 0], "to": [8, 0, 0], "radius": 1}}]})";

TEST_F(Build, reports_what_was_built) {
  const ProcessResult result = dupin({"build", example("reducer.json"), "-o", "a.stl"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("parts                3 (1 cyclic_blend, 2 pipe)\n"
                                     "written              a.stl, binary STL\n"));
  EXPECT_THAT(result.out, HasSubstr("watertight           yes\n"));
  EXPECT_THAT(result.out, HasSubstr("self-intersections   0\n"));
  EXPECT_THAT(result.out, testing::ContainsRegex("smallest margin      0\\.[0-9]+ \\(blend\\)\n"));
  EXPECT_THAT(result.out, HasSubstr("welded               2\n"));
  EXPECT_THAT(result.out, HasSubstr("open                 2\n"));
  EXPECT_THAT(result.out, HasSubstr("gaps                 0\n"));
}

TEST_F(Build, makes_the_regions_of_an_assembly_with_walls) {
  std::map<std::string, double> volumes;
  for (const std::string region : {"outer", "metal", "fluid"}) {
    const auto report =
        json({"build", example("hollow-tee.json"), "-o", region + ".off", "--region", region}, 0);
    EXPECT_EQ(report.at("region"), region);
    volumes[region] = report.at("output").at("check").at("volume");
    EXPECT_NEAR(report.at("volumes").at(region), volumes[region], 1e-9 * volumes[region]);
    EXPECT_EQ(report.at("output").at("check").at("components"), 1);
  }
  EXPECT_NEAR(volumes["outer"], volumes["metal"] + volumes["fluid"], 1e-9 * volumes["outer"]);
  EXPECT_EQ(json({"build", example("hollow-tee.json"), "-o", "a.off"}, 0).at("region"), "metal");
}

TEST_F(Build, takes_a_wall_and_a_region_for_documents_and_graphs) {
  const ProcessResult metal =
      dupin({"build", example("reducer.json"), "-o", "a.stl", "--wall", "0.1mm"});
  EXPECT_EQ(metal.exit_code, 0) << metal.err;
  EXPECT_THAT(metal.out, testing::ContainsRegex("euler number         0\n"));
  EXPECT_THAT(metal.out,
              testing::ContainsRegex(
                  "region               metal\n"
                  "volumes              outer [0-9.]+, metal [0-9.]+, fluid [0-9.]+ mm"));
  EXPECT_EQ(
      json({"build", example("neuron.swc"), "-o", "b.stl", "--wall", "0.05", "--region", "fluid"},
           0)
          .at("region"),
      "fluid");
}

TEST_F(Build, refuses_regions_that_there_are_not) {
  const ProcessResult none =
      dupin({"build", example("reducer.json"), "-o", "a.stl", "--region", "fluid"});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_THAT(none.err, HasSubstr("/wall: there is no fluid region: neither the document nor a "
                                  "part says how thick a wall is"));
  EXPECT_EQ(dupin({"build", example("reducer.json"), "-o", "a.stl", "--region", "air"}).exit_code,
            2);
  const ProcessResult thick =
      dupin({"build", example("reducer.json"), "-o", "a.stl", "--wall", "1in"});
  EXPECT_EQ(thick.exit_code, 4);
  EXPECT_THAT(thick.err, HasSubstr("leaves no bore where the radius is only"));
}

TEST_F(Build, json_agrees_with_the_file) {
  const auto report = json({"build", example("reducer.json"), "-o", "a.off"}, 0);
  EXPECT_EQ(report.at("unit"), "mm");
  EXPECT_EQ(report.at("runs"), 1);
  ASSERT_EQ(report.at("parts").size(), 3);
  for (const auto& part : report.at("parts")) {
    EXPECT_GT(part.at("margin_lower"), 0);
    EXPECT_LE(part.at("margin_lower"), part.at("margin_upper"));
    EXPECT_LE(part.at("error_bound"), 0.05);
  }
  EXPECT_EQ(json({"check", "a.off"}, 0), report.at("output").at("check"));
  EXPECT_EQ(report.at("gaps").at("findings"), 0);
}

TEST_F(Build, graphs_become_solids) {
  const auto neuron = json({"build", example("neuron.swc"), "-o", "neuron.stl"}, 0);
  EXPECT_EQ(neuron.at("output").at("check").at("euler_number"), 2);
  EXPECT_EQ(neuron.at("graph").at("nodes"), 9);
  ASSERT_EQ(neuron.at("graph").at("notes").size(), 1);
  EXPECT_EQ(neuron.at("graph").at("notes").at(0).at("line"), 10);
  const auto frame = json({"build", example("frame.graph"), "-o", "a.stl", "--radius", "2"}, 0);
  EXPECT_EQ(frame.at("output").at("check").at("euler_number"), -2);
  EXPECT_EQ(frame.at("graph").at("cycles"), 2);
  EXPECT_EQ(frame.at("graph").at("balls"), 0);
  EXPECT_EQ(frame.at("graph").at("junctions"), 3);
}

TEST_F(Build, graphs_without_radii_are_refused_where_they_lack_one) {
  const ProcessResult result = dupin({"build", example("frame.graph"), "-o", "a.stl"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("frame.graph:2"));
  EXPECT_THAT(result.err, HasSubstr("--radius"));
  EXPECT_EQ(dupin({"build", example("tee.json"), "-o", "a.stl", "--radius", "2"}).exit_code, 2);
}

TEST_F(Build, every_example_gives_a_solid_but_the_tight_one) {
  for (const std::string name : {"reducer", "straight-reducer", "coplanar", "u-bend"}) {
    const auto report = json({"build", example(name + ".json"), "-o", name + ".stl"}, 0);
    EXPECT_EQ(report.at("output").at("check").at("solid"), true) << name;
    EXPECT_EQ(report.at("output").at("check").at("euler_number"), 2) << name;
  }
  const ProcessResult tight = dupin({"build", example("tight.json"), "-o", "tight.stl"});
  EXPECT_EQ(tight.exit_code, 4);
  EXPECT_THAT(tight.err, HasSubstr("'blend'"));
  EXPECT_THAT(folder_.files(),
              ElementsAre("coplanar.stl", "reducer.stl", "straight-reducer.stl", "u-bend.stl"));
}

// With bores, which keep to the walls besides, and become longer where they are open.
TEST_F(Build, names_a_tolerance_that_does) {
  const std::string before = "; a tolerance of ";
  for (const auto& [name, limits] :
       std::map<std::string, std::vector<std::string>>{{"hollow-tee", {"1000", "3000"}},
                                                       {"vessel", {"20000"}},
                                                       {"tee", {"500", "2000"}},
                                                       {"junction", {"1000"}}}) {
    for (const std::string& limit : limits) {
      std::vector<std::string> words{"build", example(name + ".json"), "-o",
                                     "x.stl", "--triangles",           limit};
      const std::string why = dupin(words).err;
      const std::size_t at = why.find(before);
      ASSERT_NE(at, std::string::npos) << name << why;
      const std::size_t begin = at + before.size();
      words.insert(words.end(), {"--tolerance", why.substr(begin, why.find(' ', begin) - begin)});
      const ProcessResult again = dupin(words);
      EXPECT_EQ(again.exit_code, 0) << why << again.err;
    }
  }
  EXPECT_THAT(dupin({"build", example("vessel.json"), "-o", "x.stl", "--triangles", "3000"}).err,
              HasSubstr("; no tolerance would do with walls as thin as these, but a higher limit"));
}

TEST_F(Build, reads_a_document_from_standard_input) {
  const ProcessResult result = dupin({"build", "-", "-o", "-", "--format", "off"}, kTwoPipes);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, StartsWith("OFF"));
  EXPECT_THAT(result.err, StartsWith("parts                2 (2 pipe)\n"));
}

TEST_F(Build, lengths_of_the_command_line_take_units) {
  folder_.write("a.json", kTwoPipes);
  const auto triangles = [&](const std::string& tolerance) {
    return json({"build", "a.json", "-o", "a.off", "--tolerance", tolerance}, 0)
        .at("output")
        .at("check")
        .at("triangles");
  };
  EXPECT_EQ(triangles("0.0254mm"), triangles("0.001"));
  EXPECT_GT(triangles("0.001in"), triangles("0.01in"));
}

TEST_F(Build, a_finer_tolerance_overrides_the_document) {
  const auto coarse = json({"build", example("reducer.json"), "-o", "a.off"}, 0);
  const auto fine =
      json({"build", example("reducer.json"), "-o", "a.off", "--tolerance", "0.01mm"}, 0);
  EXPECT_GT(fine.at("output").at("check").at("triangles"),
            coarse.at("output").at("check").at("triangles"));
  for (const auto& part : fine.at("parts")) {
    EXPECT_LE(part.at("error_bound"), 0.01);
  }
}

TEST_F(Build, segments_are_taken_literally) {
  const auto report =
      json({"build", example("reducer.json"), "-o", "a.off", "--segments", "12"}, 0);
  for (const auto& part : report.at("parts")) {
    EXPECT_EQ(part.at("segments"), 12);
  }
}

TEST_F(Build, ends_that_nearly_meet_are_findings_of_a_file_that_is_written) {
  folder_.write("a.json", kTwoPipes);
  const ProcessResult result = dupin({"build", "a.json", "-o", "a.off", "--connect", "1mm"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("gaps                 1\n"
                                    "  gap: a.end to b.start: axial 0.0078125 in\n"));
  EXPECT_EQ(dupin({"check", "a.off"}).exit_code, 0);
}

TEST_F(Build, malformed_documents_are_named_with_the_place) {
  const std::vector<std::pair<std::string, std::string>> table{
      {R"({"units": "mm", "tolerance": 1, "parts": [], "colour": 1})", "a.json#/colour: "},
      {R"({"units": "mm", "tolerance": 1, "parts": [{"name": "p", "pipe": {"from": [0,0,0], "to": [1,0,0], "radius": -1}}]})",
       "a.json#/parts/0/pipe/radius: 'p': "},
      {R"({"units": "mm", "tolerance": 1, "parts": [{"name": "c", "cap": {"at": "p.end"}}]})",
       "a.json#/parts/0/cap/at: 'c': "},
      {R"({"units": "mm",)", "a.json:1:"},
  };
  for (const auto& [text, place] : table) {
    folder_.write("a.json", text);
    const ProcessResult result = dupin({"build", "a.json", "-o", "a.stl"});
    EXPECT_EQ(result.exit_code, 3) << text;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, StartsWith("dupin: " + place));
    EXPECT_THAT(result.err, MatchesRegex("[^\n]*\n"));
  }
  EXPECT_THAT(folder_.files(), ElementsAre("a.json"));
}

TEST_F(Build, states_the_least_wall_and_names_patches_anew) {
  const ProcessResult vessel = dupin({"build", example("vessel.json"), "-o", "a.stl", "--region",
                                      "fluid", "--tolerance", "1mm", "--patches", "p.json"});
  EXPECT_EQ(vessel.exit_code, 0) << vessel.err;
  EXPECT_THAT(vessel.out, HasSubstr("least wall           3.9"));
  const auto patches = nlohmann::json::parse(std::ifstream(folder_.path() / "p.json"));
  std::set<std::string> names;
  for (const auto& patch : patches.at("patches")) {
    names.insert(patch.at("name"));
  }
  for (const char* end : {"inflow", "outflow", "drain"}) {
    EXPECT_EQ(names.count(end), 1) << end;
  }
  folder_.write("v.json", R"({"units": "mm", "tolerance": 1, "wall": 8, "parts": [
      {"name": "shell", "pipe": {"from": [0, 0, 0], "to": [0, 0, 900], "radius": 305}},
      {"name": "top", "head": {"from": "shell.end", "form": "ellipsoidal"}},
      {"name": "bottom", "head": {"from": "shell.start", "form": "kloepper"}}]})");
  const auto report = json({"build", "v.json", "-o", "a.off", "--wall-side", "outwards"}, 0);
  for (const auto& part : report.at("parts")) {
    if (part.at("name") == "top") {
      EXPECT_LT(part.at("least_wall"), 8);
      EXPECT_GT(part.at("least_wall"), 0.93 * 8);
    }
    if (part.at("name") == "shell" || part.at("name") == "bottom") {
      EXPECT_NEAR(part.at("least_wall"), 8, 1e-6);
    }
  }
}

TEST_F(Build, sizes_stay_outside_diameters_and_what_goes_on_from_them_has_to) {
  const ProcessResult result =
      dupin({"build", example("vessel.json"), "-o", "a.off", "--wall-side", "outwards"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("'top': it shares a ring with 'shell'"));
  EXPECT_THAT(result.err, HasSubstr("neighbours have the same wall and wall_side"));
}

TEST_F(Build, refuses_names_of_patches_that_are_none) {
  std::ofstream(folder_.path() / "a.json")
      << R"({"units": "mm", "tolerance": 1, "patches": {"a.top": "x"}, "parts": [
          {"name": "a", "pipe": {"from": [0, 0, 0], "to": [9, 0, 0], "radius": 3}}]})";
  const ProcessResult refused = dupin({"build", "a.json", "-o", "a.stl"});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("a.json#/patches: there is no patch named 'a.top'"));
}

// Points that have several normals are one again for our readers; nothing else differs.
TEST_F(Build, writes_normals_for_viewers_and_reads_the_same_solid_back) {
  const ProcessResult plain = dupin({"build", example("tee.json"), "-o", "plain.vtp", "-q"});
  ASSERT_EQ(plain.exit_code, 0) << plain.err;
  const TriMesh mesh = read_mesh(folder_.read("plain.vtp"), "plain.vtp");
  for (const std::string format : {"obj", "ply", "ply-ascii"}) {
    for (const std::string verification : {"compare", "full"}) {
      const ProcessResult result = dupin({"build", example("tee.json"), "-o", "shaded", "--format",
                                          format, "--verify", verification, "-q"});
      ASSERT_EQ(result.exit_code, 0) << format << result.err;
      const TriMesh shaded = read_mesh(folder_.read("shaded"), "shaded");
      EXPECT_EQ(shaded.points, mesh.points) << format;
      EXPECT_EQ(shaded.triangles.size(), mesh.triangles.size()) << format;
      EXPECT_TRUE(check(shaded).is_solid()) << format;
    }
  }
  EXPECT_THAT(folder_.read("shaded"), HasSubstr("property float nx\n"));
  const auto full = json({"build", example("tee.json"), "-o", "a.glb", "--verify", "full"}, 0);
  EXPECT_EQ(full.at("output").at("check").at("points"), mesh.points.size());
  EXPECT_THAT(folder_.read("a.glb"), HasSubstr("\"NORMAL\""));
  EXPECT_EQ(json({"check", "a.glb"}, 0).at("points"), mesh.points.size());
}

TEST_F(Build, writes_normals_of_meshes_for_solvers_with_the_origin_elsewhere) {
  const ProcessResult result =
      dupin({"build", example("tee.json"), "-o", "a.ply", "--format", "ply-ascii", "--quality",
             "cfd", "--size", "4mm", "--origin", "1000,0,0", "-q"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::istringstream text(folder_.read("a.ply"));
  for (std::string line; line != "end_header";) {
    std::getline(text, line);
  }
  // Of the run's cylinder about the x axis, next to its start.
  std::size_t found = 0;
  for (double x = 0, y = 0, z = 0, nx = 0, ny = 0, nz = 0, point = 0;
       text >> x >> y >> z >> nx >> ny >> nz >> point && x < -900;) {
    if (x < -1035 && nx != -1) {
      EXPECT_NEAR(nx, 0, 1e-6);
      EXPECT_NEAR(15 * ny, y, 0.05);
      EXPECT_NEAR(15 * nz, z, 0.05);
      ++found;
    }
  }
  EXPECT_GT(found, 10U);
}

// The meshes' tolerance is a quarter of the wall, which is thinner than that where circles are
// oblique.
TEST_F(Build, says_that_meshes_are_too_coarse_for_a_wall) {
  folder_.write("a.json", R"({"units": "mm", "tolerance": 0.1, "wall": 0.1, "parts": [
      {"name": "p", "pipe": {"from": [0, 0, 0], "direction": [0.8195, -0.4118, 0.5675],
                             "length": 2, "radius": 1}},
      {"name": "q", "pipe": {"from": [11.7281, -5.7834, 12.8804],
                             "direction": [-0.7272, 0.9901, 0.3237], "length": 2, "radius": 0.92}},
      {"name": "b", "ringed_blend": {"from": "p.end", "to": "q.start", "bidegree": [9, 2]}}]})");
  const ProcessResult refused = dupin({"build", "a.json", "-o", "a.off"});
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_THAT(refused.err,
              MatchesRegex("dupin: a.json#/parts/2: 'b': its surface lies inside of 'b.bore' at "
                           ".*: meshes are too coarse there for the wall; choose a smaller "
                           "tolerance, or a thicker wall\n"));
  EXPECT_EQ(json({"build", "a.json", "-o", "a.off", "--tolerance", "0.01"}, 0).at("region"),
            "metal");
  EXPECT_EQ(json({"build", "a.json", "-o", "a.off", "--wall", "0.3"}, 0).at("region"), "metal");
}

// Their lattice was as coarse as the radius allows, which let points of their ends coincide.
TEST_F(Build, makes_bends_that_are_short_or_all_but_closed) {
  for (const std::string angle : {"1e-9", "1e-4", "359.9999999"}) {
    folder_.write("a.json", R"({"units": "mm", "tolerance": 0.1, "parts": [
        {"name": "p", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "radius": 1}},
        {"name": "e", "elbow": {"from": "p.end", "bend_radius": 3, "toward": [0, 1, 0],
                                "angle": )" +
                                angle + "}}]}");
    EXPECT_EQ(dupin({"build", "a.json", "-o", "a.off"}).err, "") << angle;
    EXPECT_EQ(json({"check", "a.off"}, 0).at("solid"), true) << angle;
  }
  folder_.write("a.json", R"({"units": "mm", "tolerance": 0.1, "parts": [
      {"name": "p", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "radius": 1}},
      {"name": "e", "elbow": {"from": "p.end", "bend_radius": 3, "toward": [0, 1, 0],
                              "angle": 1e-12}}]})");
  EXPECT_THAT(dupin({"build", "a.json", "-o", "a.off"}).err,
              HasSubstr("'e': its smallest radius or length, 5.23599e-14, is too small for"));
}

// Points in one place that are no copies of each other stay apart.
TEST_F(Build, tells_contacts_from_copies) {
  folder_.write("touch.json", R"({"units": "mm", "tolerance": 0.05, "parts": [
      {"name": "a", "sphere": {"center": [0, 0, 0], "radius": 2}},
      {"name": "b", "sphere": {"center": [0, 0, 4], "radius": 2}},
      {"name": "p", "pipe": {"from": [5, 0, 0], "to": [5, 0, 4], "radius": 1}}]})");
  for (const std::string format : {"obj", "ply", "glb"}) {
    const auto report = json({"build", "touch.json", "-o", "a", "--format", format}, 0);
    EXPECT_EQ(report.at("output").at("contacts").size(), 1U) << format;
    EXPECT_EQ(json({"check", "a"}, 0).at("points"), report.at("output").at("check").at("points"));
    EXPECT_TRUE(check(read_mesh(folder_.read("a"), "a")).is_solid()) << format;
  }
}

// On one of the processors that it may use, and on all.
TEST_F(Build, writes_the_same_normals_whatever_the_number_of_threads) {
  const std::string build = tool_path() + " -q build " + example("junction.json") + " -o ";
  const ProcessResult result =
      shell(build +
            "all.glb && taskset -c $(awk '/Cpus_allowed_list/ { split($2, numbers, "
            "/[,-]/); print numbers[1] }' /proc/self/status) " +
            build + "one.glb");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(folder_.read("all.glb"), HasSubstr("\"NORMAL\""));
  EXPECT_EQ(folder_.read("all.glb"), folder_.read("one.glb"));
}

}  // namespace
}  // namespace dupin::test
