// What does the one rounding move, and what does it cost beside the union and the verification?
// The table's rows are sums over seeds; every mesh is checked before its time counts.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "pipes.h"
#include "support/pipe_cases.h"
#include "support/pipe_unions.h"
#include "support/plants.h"

namespace dupin {
namespace {

double seconds(const std::function<void()>& task) {
  const auto start = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Row {
  std::size_t cases = 0, triangles = 0, removed = 0, repaired = 0;
  double steps = 0, time = 0;  // the largest move in steps of the lattice at the largest coordinate
};

void add(Row& row, const Solid& exact, Coordinates target) {
  std::optional<Rounded> result;
  row.time += seconds([&] { result = to_mesh(exact, target); });
  const Rounded& rounded = *result;
  if (!check(rounded.mesh()).is_solid()) {
    std::puts("a rounded mesh is no solid");
    std::exit(1);
  }
  double largest = 0;
  for (const Vec3& p : rounded.mesh().points) {
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  }
  const int digits = target == Coordinates::binary64 ? 52 : 23;
  ++row.cases;
  row.triangles += exact.triangle_count();
  row.removed += rounded.report().removed_triangles;
  row.repaired += rounded.report().repair_reach > 0 ? 1 : 0;
  row.steps =
      std::max(row.steps, rounded.report().largest_move / std::exp2(std::ilogb(largest) - digits));
}

void print(const char* target, const Row& row) {
  std::printf("  %-8s %9zu %8zu %9zu %11.1f %9.3f\n", target, row.triangles, row.repaired,
              row.removed, row.steps, row.time);
}

void table_of_moves(std::uint32_t seeds) {
  if (seeds == 0) {
    return;
  }
  std::printf("  %-8s %9s %8s %9s %11s %9s\n", "target", "triangles", "repaired", "removed",
              "most steps", "seconds");
  const auto rows = [&](test::UnionKind kind, std::uint32_t segments) {
    Row doubles, floats;
    double unions = 0;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
      Solid exact;
      unions += seconds([&] { exact = unite(test::pipes(kind, segments, seed)); });
      add(doubles, exact, Coordinates::binary64);
      add(floats, exact, Coordinates::binary32);
    }
    std::printf("%s, %u segments, %zu unions in %.3f s\n", std::string(test::name(kind)).c_str(),
                segments, doubles.cases, unions);
    print("binary64", doubles);
    print("binary32", floats);
  };
  for (const test::UnionKind kind : test::kDesignKinds) {
    rows(kind, 64);
    rows(kind, 256);
  }
  for (const test::UnionKind kind : test::kPlantKinds) {
    rows(kind, 64);
    rows(kind, 192);
  }
}

/// Processor seconds: the same however busy the machine is. All threads together.
double effort(const std::function<void()>& task) {
  const std::clock_t start = std::clock();
  task();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

constexpr int kRepetitions = 5;

/// The least effort of several: what the machine does besides only adds.
double least_effort(const std::function<void()>& task) {
  double least = effort(task);
  for (int i = 1; i < kRepetitions; ++i) {
    least = std::min(least, effort(task));
  }
  return least;
}

/// The least effort of writing a file and, besides, of its verification by comparison with the mesh
/// that rounding has proved.
struct WritingEffort {
  double write = 0, verify = 0;
};

WritingEffort writing_effort(const Rounded& rounded, const MeshFormat& format) {
  const auto path = std::filesystem::temp_directory_path() / "dupin_rounding_bench";
  WritingEffort least;
  least.write = least_effort([&] { write_mesh(path, rounded.mesh(), format); });
  least.verify = least_effort([&] { write_verified(path, rounded, format); }) - least.write;
  std::filesystem::remove(path);
  return least;
}

/// What the design asks for: rounding and verification together cost less than the union.
void large_unions(const std::vector<std::string>& names) {
  std::puts(
      "\nlarge unions, least processor seconds of five; rounded to binary64, written and verified\n"
      "as OFF and as binary PLY, and to binary32 for binary STL; and the exact check of the mesh");
  std::printf("  %-14s %9s %8s | %8s %8s %8s %8s %8s %8s | %8s %8s %8s %8s\n", "case", "triangles",
              "union", "round", "off", "verify", "ply", "verify", "check", "round", "stl", "verify",
              "check");
  for (const std::string& name : names) {
    std::vector<Solid> operands;
    for (const TriMesh& mesh : test::pipe_case(name)) {
      operands.push_back(Solid::from(mesh));
    }
    Solid exact;
    std::printf("  %-14s", name.c_str());
    const double uniting = least_effort([&] { exact = unite(operands); });
    std::printf(" %9zu %8.3f", exact.triangle_count(), uniting);
    bool sound = true;
    const auto row = [&](Coordinates target, std::initializer_list<MeshFormat> formats) {
      std::optional<Rounded> rounded;
      std::printf(" | %8.3f", least_effort([&] { rounded = to_mesh(exact, target); }));
      for (const MeshFormat& format : formats) {
        const WritingEffort writing = writing_effort(*rounded, format);
        std::printf(" %8.3f %8.3f", writing.write, writing.verify);
      }
      std::printf(" %8.3f", effort([&] { sound = check(rounded->mesh()).is_solid() && sound; }));
      std::fflush(stdout);
    };
    row(Coordinates::binary64, {kOff, kPlyBinary});
    row(Coordinates::binary32, {kStlBinary});
    std::puts(sound ? "" : "  BAD");
  }
}

/// A row of nearly coincident solids: their number, and what their union and its rounding to
/// binary32 take. The aim: rounding takes at most ten times the union.
void nearly_coincident(std::uint32_t seed, const std::vector<Solid>& solids) {
  Solid exact;
  double uniting_wall = 0, rounding_wall = 0;
  const double uniting = effort([&] { uniting_wall = seconds([&] { exact = unite(solids); }); });
  std::optional<Rounded> rounded;
  const double rounding = effort(
      [&] { rounding_wall = seconds([&] { rounded = to_mesh(exact, Coordinates::binary32); }); });
  const RoundingReport& report = rounded->report();
  std::printf("  %5u %10zu %9zu %8.3f %8.3f %6.1f %7.1f %7zu %7zu %8.3f%s\n", seed, solids.size(),
              exact.triangle_count(), uniting, rounding, rounding / uniting,
              rounding_wall / uniting_wall, report.filled_places.size(),
              report.snapped_places.size(), report.largest_move,
              check(rounded->mesh()).is_solid() ? "" : "  BAD");
  std::fflush(stdout);
}

void header_of_nearly_coincident(const char* what) {
  std::printf("\n%s, at 1e5 to 2e6 mm, to binary32; processor seconds, and the ratio of seconds\n",
              what);
  std::printf("  %5s %10s %9s %8s %8s %6s %7s %7s %7s %8s\n", "seed", "solids", "triangles",
              "union", "round", "ratio", "seconds", "slits", "snapped", "move");
}

/// Plants whose ends miss each other by less than binary32 can tell.
void plants(std::uint32_t first, std::uint32_t seeds) {
  header_of_nearly_coincident("plants of 200 to 1000 components with misfits");
  for (std::uint32_t seed = first; seed < first + seeds; ++seed) {
    std::vector<Solid> components;
    for (const TriMesh& mesh : test::plant({.seed = seed, .components = 200 + 100 * (seed % 9)})) {
      components.push_back(Solid::from(mesh));
    }
    nearly_coincident(seed, components);
  }
}

/// Racks whose pipes rest on others: there is less between them than binary32 can tell.
void resting_racks(std::uint32_t first, std::uint32_t seeds) {
  header_of_nearly_coincident("racks of pipes that rest on others");
  for (std::uint32_t seed = first; seed < first + seeds; ++seed) {
    nearly_coincident(seed, test::resting_pipes(10 + 10 * static_cast<int>(seed % 4), seed, 140));
  }
}

/// An oblique pipe of radius 1 and length 10: long facets where there are few rings.
TriMesh oblique_pipe(std::uint32_t segments, std::uint32_t rings) {
  const Vec3 axis = Vec3(1, std::sqrt(2.0), std::sqrt(3.0)).normalized();
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  TriMesh mesh = bench::pipe(1, 0, 10, segments, rings);
  for (Vec3& p : mesh.points) {
    p = Vec3(100, 200, 300) + p.x() * u + p.y() * v + p.z() * axis;
  }
  return mesh;
}

/// Verification alone, for facets of different lengths.
void large_meshes() {
  std::puts("\nverification of a mesh; processor seconds and seconds");
  std::printf("  %9s %9s %9s %9s\n", "triangles", "rings", "processor", "seconds");
  for (const std::uint32_t rings : {512U, 64U, 8U}) {
    const TriMesh mesh = oblique_pipe(500000 / (rings + 1), rings);
    bool sound = false;
    double wall = 0;
    const double busy = effort([&] { wall = seconds([&] { sound = check(mesh).is_solid(); }); });
    std::printf("  %9zu %9u %9.3f %9.3f%s\n", mesh.triangles.size(), rings, busy, wall,
                sound ? "" : "  BAD");
  }
}

}  // namespace
}  // namespace dupin

/// Arguments: the number of seeds per row of the table of moves, 3 without; then the pipe cases
/// that are large unions, or "plants" or "racks", how many, and the first one's seed.
int main(int count, char** arguments) {
  const std::vector<std::string> given(arguments + 1, arguments + count);
  const auto number = [&](std::size_t i) {
    return i < given.size() ? static_cast<std::uint32_t>(std::stoul(given[i])) : 0;
  };
  dupin::table_of_moves(given.empty() ? 3 : number(0));
  if (given.size() >= 3 && given[1] == "plants") {
    dupin::plants(number(3), number(2));
    return EXIT_SUCCESS;
  }
  if (given.size() >= 3 && given[1] == "racks") {
    dupin::resting_racks(number(3), number(2));
    return EXIT_SUCCESS;
  }
  if (given.size() > 1) {
    dupin::large_unions({given.begin() + 1, given.end()});
    return EXIT_SUCCESS;
  }
  dupin::plants(0, 8);
  dupin::resting_racks(0, 4);
  dupin::large_meshes();
  dupin::large_unions({"tee_100k", "tee_100k_rot", "header_100_rot", "chain_100_rot",
                       "rack_fine_rot", "tee_1M", "tee_1M_rot"});
  return EXIT_SUCCESS;
}
