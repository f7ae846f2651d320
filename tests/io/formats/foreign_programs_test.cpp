#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "dupin/io/glb.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/obj.h"
#include "dupin/io/off.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/io/three_mf.h"
#include "support/scratch_directory.h"

// What other people's programs make of our files. Each test is skipped where its program is not
// installed: apt-get install --no-install-recommends assimp-utils admesh gmsh prusa-slicer

namespace dupin {
namespace {

/// A torus in two labelled halves: 2304 triangles, genus 1.
TriMesh torus() {
  constexpr std::uint32_t kAround = 48;
  constexpr std::uint32_t kAcross = 24;
  TriMesh mesh;
  mesh.names = {"left half", "right & rest"};
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t k = 0; k < kAcross; ++k) {
      const double u = 2 * 3.141592653589793 * i / kAround;
      const double v = 2 * 3.141592653589793 * k / kAcross;
      const double r = 10 + 3 * std::cos(v);
      mesh.points.emplace_back(100 + r * std::cos(u), r * std::sin(u), 3 * std::sin(v));
      const std::uint32_t a = i * kAcross + k;
      const std::uint32_t b = (i + 1) % kAround * kAcross + k;
      const std::uint32_t c = (i + 1) % kAround * kAcross + (k + 1) % kAcross;
      const std::uint32_t d = i * kAcross + (k + 1) % kAcross;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
      mesh.labels.insert(mesh.labels.end(), 2, i < kAround / 2 ? 0 : 1);
    }
  }
  return mesh;
}

/// These programs compute in floats or print six digits: 2304 terms, each off by some 6e-8 of its
/// size, stay within 1e-4 of the sum.
constexpr double kFloatSum = 1e-4;

struct Outcome {
  int status = 0;
  std::string text;

  /// The number behind the first `key`.
  [[nodiscard]] double number(const std::string& key) const {
    const std::size_t place = text.find(key);
    return place == std::string::npos ? std::nan("")
                                      : std::strtod(text.c_str() + place + key.size(), nullptr);
  }
};

class ForeignPrograms : public test::ScratchDirectory {
 protected:
  [[nodiscard]] static bool installed(const std::string& program) {
    return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
  }

  [[nodiscard]] Outcome run(const std::string& command) const {
    const std::string line =
        "cd '" + directory().string() + "' && timeout 120 " + command + " 2>&1";
    std::FILE* const pipe = ::popen(line.c_str(), "r");
    Outcome outcome;
    std::array<char, 4096> buffer{};
    for (std::size_t taken = 0; (taken = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
      outcome.text.append(buffer.data(), taken);
    }
    outcome.status = ::pclose(pipe);
    return outcome;
  }

  /// Writes the torus under a name that tells the format.
  [[nodiscard]] std::string written(const MeshFormat& format, const TriMesh& mesh = torus()) const {
    const std::string key(format.key);
    const std::string file = key + "." + key.substr(0, key.find('-'));
    write_mesh(path(file), mesh, format, {"mm", "a note"});
    return file;
  }

  void expect_torus(const std::filesystem::path& file, double scale) const {
    const Report report = check(read_mesh(file));
    EXPECT_TRUE(report.closed());
    EXPECT_EQ(report.triangles, 2304U);
    EXPECT_EQ(report.genus, 1);
    EXPECT_NEAR(report.volume / (scale * scale * scale), volume_, kFloatSum * volume_);
  }

  const double volume_ = check(torus()).volume;
};

TEST_F(ForeignPrograms, assimp_passes_on_the_same_solid) {
  if (!installed("assimp")) {
    GTEST_SKIP() << "assimp is not installed (package assimp-utils)";
  }
  for (const MeshFormat& format :
       {kOff, kStlAscii, kStlBinary, kPlyAscii, kPlyBinary, kObj, kThreeMf, kGlb}) {
    SCOPED_TRACE(format.name);
    const std::string file = written(format);
    const Outcome outcome = run("assimp export " + file + " out.stl -f stlb");
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    expect_torus(path("out.stl"), format == kGlb ? 0.001 : 1);
  }
}

TEST_F(ForeignPrograms, admesh_finds_nothing_to_repair) {
  if (!installed("admesh")) {
    GTEST_SKIP() << "admesh is not installed";
  }
  TriMesh one_block = torus();  // version 0.98 reads no file of several blocks
  one_block.labels.clear();
  for (const MeshFormat& format : {kStlAscii, kStlBinary}) {
    SCOPED_TRACE(format.name);
    const Outcome outcome = run("admesh --exact " + written(format, one_block));
    EXPECT_EQ(outcome.number("Number of facets                 :"), 2304) << outcome.text;
    EXPECT_EQ(outcome.number("Total disconnected facets        :"), 0);
    EXPECT_EQ(outcome.number("Degenerate facets     :"), 0);
    EXPECT_EQ(outcome.number("Normals fixed         :"), 0);
    EXPECT_NEAR(outcome.number("Volume   :"), volume_, kFloatSum * volume_);
  }
}

TEST_F(ForeignPrograms, gmsh_passes_on_the_same_solid) {
  if (!installed("gmsh")) {
    GTEST_SKIP() << "gmsh is not installed";
  }
  // Version 4.8 reads neither OFF nor OBJ, and its binary PLY is experimental.
  for (const MeshFormat& format : {kStlAscii, kStlBinary}) {
    SCOPED_TRACE(format.name);
    const Outcome outcome = run("gmsh -0 " + written(format) + " -o out.stl -format stl");
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    expect_torus(path("out.stl"), 1);
  }
}

TEST_F(ForeignPrograms, prusa_slicer_calls_it_manifold) {
  if (!installed("prusa-slicer")) {
    GTEST_SKIP() << "prusa-slicer is not installed";
  }
  for (const MeshFormat& format : {kStlAscii, kStlBinary, kObj, kThreeMf}) {
    SCOPED_TRACE(format.name);
    const Outcome outcome = run("prusa-slicer --info " + written(format));
    EXPECT_NE(outcome.text.find("manifold = yes"), std::string::npos) << outcome.text;
    EXPECT_EQ(outcome.number("number_of_facets ="), 2304);
    EXPECT_EQ(outcome.number("number_of_parts ="), 1);
    EXPECT_NEAR(outcome.number("volume ="), volume_, kFloatSum * volume_);
  }
}

}  // namespace
}  // namespace dupin
