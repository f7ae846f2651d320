// What does the one rounding move, and what does it cost beside the union and the verification?
// The table's rows are sums over seeds; every mesh is checked before its time counts.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "support/pipe_unions.h"

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
  Rounded rounded;
  row.time += seconds([&] { rounded = to_mesh(exact, target); });
  if (!check(rounded.mesh).is_solid()) {
    std::puts("a rounded mesh is no solid");
    std::exit(1);
  }
  double largest = 0;
  for (const Vec3& p : rounded.mesh.points) {
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  }
  const int digits = target == Coordinates::binary64 ? 52 : 23;
  ++row.cases;
  row.triangles += exact.triangle_count();
  row.removed += rounded.report.removed_triangles;
  row.repaired += rounded.report.repair_reach > 0 ? 1 : 0;
  row.steps =
      std::max(row.steps, rounded.report.largest_move / std::exp2(std::ilogb(largest) - digits));
}

void print(const char* target, const Row& row) {
  std::printf("  %-8s %9zu %8zu %9zu %11.1f %9.3f\n", target, row.triangles, row.repaired,
              row.removed, row.steps, row.time);
}

void table_of_moves(std::uint32_t seeds) {
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

/// A pipe of radius 1 and length 10 along an axis.
TriMesh pipe(std::uint32_t segments, std::uint32_t rings, const Vec3& place, const Vec3& axis) {
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  TriMesh mesh;
  for (std::uint32_t j = 0; j <= rings; ++j) {
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle = 2 * std::numbers::pi * i / segments;
      mesh.points.push_back(place + std::cos(angle) * u + std::sin(angle) * v +
                            (10.0 * j / rings) * axis);
    }
  }
  const std::uint32_t top = segments * rings;
  for (std::uint32_t a = 0; a < top; ++a) {
    const std::uint32_t b = a % segments + 1 == segments ? a + 1 - segments : a + 1;
    mesh.triangles.push_back({a, b, b + segments});
    mesh.triangles.push_back({a, b + segments, a + segments});
  }
  for (std::uint32_t i = 1; i + 1 < segments; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({top, top + i, top + i + 1});
  }
  return mesh;
}

const Vec3 kOblique = Vec3(1, std::sqrt(2.0), std::sqrt(3.0)).normalized();

/// A pipe through the middle of another one.
void large_unions() {
  std::puts("\nlarge unions, seconds");
  std::printf("  %9s %9s %9s %9s %9s %9s\n", "triangles", "union", "binary64", "check", "binary32",
              "check");
  for (const std::uint32_t segments : {128U, 256U, 512U}) {
    const Vec3 across = kOblique.cross(Vec3(0.3, -0.2, 1)).normalized();
    const Vec3 middle = Vec3(10, 20, 30) + 5 * kOblique;
    const std::vector<Solid> operands = {
        Solid::from(pipe(segments, segments / 2, Vec3(10, 20, 30), kOblique)),
        Solid::from(pipe(segments, segments / 2, middle - 5 * across, across))};
    Solid exact;
    const double uniting = seconds([&] { exact = unite(operands); });
    double times[4] = {};
    bool sound = true;
    for (int i = 0; i < 2; ++i) {
      Rounded rounded;
      times[2 * i] = seconds([&] {
        rounded = to_mesh(exact, i == 0 ? Coordinates::binary64 : Coordinates::binary32);
      });
      times[2 * i + 1] = seconds([&] { sound = check(rounded.mesh).is_solid() && sound; });
    }
    std::printf("  %9zu %9.3f %9.3f %9.3f %9.3f %9.3f%s\n", exact.triangle_count(), uniting,
                times[0], times[1], times[2], times[3], sound ? "" : "  BAD");
  }
}

void large_meshes() {
  std::puts("\nlarge meshes, seconds");
  std::printf("  %9s %9s %9s %9s %9s\n", "triangles", "Solid", "binary64", "binary32", "check");
  for (const std::uint32_t segments : {256U, 1024U}) {
    const TriMesh mesh = pipe(segments, segments / 2, Vec3(100, 200, 300), kOblique);
    Solid solid;
    Rounded rounded;
    const double establish = seconds([&] { solid = Solid::from(mesh); });
    const double doubles = seconds([&] { rounded = to_mesh(solid); });
    const double floats = seconds([&] { rounded = to_mesh(solid, Coordinates::binary32); });
    bool sound = false;
    const double verify = seconds([&] { sound = check(rounded.mesh).is_solid(); });
    std::printf("  %9zu %9.3f %9.3f %9.3f %9.3f%s\n", mesh.triangles.size(), establish, doubles,
                floats, verify, sound ? "" : "  BAD");
  }
}

}  // namespace
}  // namespace dupin

/// The argument is the number of seeds per row, 3 without.
int main(int count, char** arguments) {
  const int seeds = count > 1 ? std::atoi(arguments[1]) : 3;
  dupin::table_of_moves(static_cast<std::uint32_t>(std::max(seeds, 0)));
  dupin::large_unions();
  dupin::large_meshes();
}
