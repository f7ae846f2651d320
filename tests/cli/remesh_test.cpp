#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/kernel/solver_mesh.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

class SolverMeshes : public Tool {
 protected:
  void SetUp() override {
    if (!has_mesh_generator()) {
      GTEST_SKIP() << "this build makes no meshes for solvers";
    }
  }
};
using testing::HasSubstr;

TEST_F(SolverMeshes, remesh_makes_well_shaped_triangles) {
  put("a.off", tube(10, 0, 50, 128));
  const auto report =
      json({"remesh", "a.off", "b.stl", "--tolerance", "0.2mm", "--size", "8mm"}, 0);
  const auto& mesh = report.at("solver_mesh");
  EXPECT_EQ(mesh.at("poor_triangles"), 0);
  EXPECT_GE(mesh.at("smallest_angle").get<double>(), 25 * std::numbers::pi / 180);
  EXPECT_LE(mesh.at("deviation"), 0.2);
  EXPECT_LE(mesh.at("longest_edge"), 8);
  EXPECT_EQ(mesh.contains("volume"), false);
  EXPECT_EQ(report.at("check").at("solid"), true);
  EXPECT_EQ(json({"check", "b.stl"}, 0).at("solid"), true);
}

TEST_F(SolverMeshes, remesh_tells_how_contacts_go) {
  put("a.off", joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}));
  for (const std::string out : {"b.off", "b.msh"}) {
    const ProcessResult result = dupin({"remesh", "a.off", out, "--tolerance", "0.1"});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_NE(result.err.find("dupin repair a.off -o OUT --contacts separate=LENGTH"),
              std::string::npos)
        << result.err;
  }
}

TEST_F(SolverMeshes, remesh_fills_for_gmsh_and_vtk) {
  put("a.off", labelled(tube(10, 0, 50, 64), "pipe"));
  for (const std::string name : {"b.msh", "b.vtu"}) {
    const auto report = json({"remesh", "a.off", name, "--tolerance", "0.5", "--size", "8"}, 0);
    EXPECT_GT(report.at("solver_mesh").at("volume").at("tetrahedra"), 500);
    EXPECT_EQ(report.at("verification"), "compare");
  }
  EXPECT_EQ(json({"check", "b.msh"}, 0).at("solid"), true);
  const auto unread =
      json({"remesh", "a.off", "c.xyz", "--format", "msh", "--no-verify", "--tolerance", "0.5"}, 0);
  EXPECT_EQ(unread.at("verification"), "none");
}

// Where the generator gives up, it would leave what it has in the working folder, and is asked
// again.
TEST_F(SolverMeshes, leave_nothing_but_themselves) {
  folder_.write("d.json", R"({"units": "mm", "tolerance": 0.16, "parts": [
{"name": "plate", "pipe": {"from": [1.0862182604588466, 0.0, -1.1079076746572607], "to": [0.7605196128270275, 0.0, 0.0], "radius": 5.517389625296996}},
{"name": "neck", "ringed_blend": {"from": {"center": [0.0, 0.0, 0.0], "direction": [0.0, 0.0, 1.0408553054581051], "radius": 4.043032962849433, "plate": "narrowing"}, "to": "slanted.start"}},
{"name": "slanted", "oblique": {"from": [1.1943955914434663, 0.0, 5.674357896007621], "to": [3.119542855599393, 0.0, 11.002754027122013], "normal": [0.0, 0.0, 0.8098737560808332], "radii": [1.54690981945981, 1.50421004913825]}},
{"name": "cone", "cone": {"from": [11.155738199728813, 2.5272769132819377, 12.936697481751233], "direction": [0.902092750764238, 0.0, 0.0], "length": 3.6277181487985235, "radii": [1.1132379179682539, 1.2502551486073399]}},
{"name": "blend", "ringed_blend": {"from": "slanted.end", "to": "cone.start"}}]})");
  const ProcessResult result = dupin({"build", "d.json", "-o", "d.vtu", "-q"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(folder_.files(), testing::ElementsAre("d.json", "d.vtu"));
}

TEST_F(SolverMeshes, remesh_says_what_it_needs) {
  put("a.off", tube(10, 0, 50, 64));
  const auto refused = [this](const std::vector<std::string>& arguments) {
    const ProcessResult result = dupin(arguments);
    EXPECT_EQ(result.exit_code, 2);
    return result.err;
  };
  EXPECT_THAT(refused({"remesh", "a.off", "b.off"}), HasSubstr("remesh needs --tolerance"));
  EXPECT_THAT(refused({"remesh", "a.off", "b.off", "--tolerance", "1", "--angle", "40"}),
              HasSubstr("--angle"));
  EXPECT_THAT(refused({"remesh", "a.off", "b.off", "--tolerance", "1", "--size", "0"}),
              HasSubstr("a length must be positive"));
  EXPECT_THAT(refused({"remesh", "a.off", "b.msh", "--tolerance", "1", "--patches", "p.json"}),
              HasSubstr("--patches lists those of a surface"));
}

TEST_F(SolverMeshes, build_makes_meshes_for_solvers) {
  folder_.write("pipe.json",
                R"({"units": "mm", "tolerance": 0.2, "parts": [
          {"name": "run", "pipe": {"from": [0, 0, 0], "to": [0, 0, 60], "radius": 10}},
          {"name": "branch", "pipe": {"from": [0, 0, 30], "to": [30, 0, 30], "radius": 5}}]})");
  const auto cad = json({"build", "pipe.json", "-o", "a.stl"}, 0);
  EXPECT_EQ(cad.at("output").contains("solver_mesh"), false);
  const auto cfd =
      json({"build", "pipe.json", "-o", "b.stl", "--quality", "cfd", "--size", "5mm"}, 0);
  EXPECT_EQ(cfd.at("output").at("solver_mesh").at("poor_triangles"), 0);
  EXPECT_LE(cfd.at("output").at("solver_mesh").at("longest_edge"), 5);
  const auto filled = json({"build", "pipe.json", "-o", "c.msh", "--size", "5mm"}, 0);
  EXPECT_GT(filled.at("output").at("solver_mesh").at("volume").at("tetrahedra"), 500);
  const std::string text = dupin({"build", "pipe.json", "-o", "c.vtu", "--distance", "1mm"}).out;
  EXPECT_THAT(text, HasSubstr("tetrahedra"));
  EXPECT_THAT(text, HasSubstr("angles"));
}

// Vertices were pumped up against flat tetrahedra by no number, which ended the program in GMP.
TEST_F(SolverMeshes, build_fills_walls_where_tetrahedra_are_flat) {
  folder_.write("a.json", R"({"units": "mm", "tolerance": 0.4, "wall": 5, "parts": [
      {"name": "run", "pipe": {"from": [-60, 0, 0], "to": [60, 0, 0], "radius": 30}},
      {"name": "flange", "wall": 0, "pipe": {"from": [-60, 0, 0], "to": [-50, 0, 0],
                                             "radius": 45}},
      {"name": "inlet", "cap": {"at": "run.start"}}]})");
  const auto filled = json({"build", "a.json", "-o", "a.msh", "--size", "20mm"}, 0);
  EXPECT_GT(filled.at("output").at("solver_mesh").at("volume").at("tetrahedra"), 5000);
}

}  // namespace
}  // namespace dupin::test
