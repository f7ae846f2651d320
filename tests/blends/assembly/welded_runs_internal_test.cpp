#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/welded_runs.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

using testing::ElementsAre;
using Parts = std::vector<std::uint32_t>;

constexpr double kPi = std::numbers::pi;
constexpr End kStart = End::start, kEnd = End::end;

// So many parts without geometry, joined in pairs of ends.
ResolvedAssembly joined(std::size_t parts, const std::vector<std::array<EndIndex, 2>>& joints) {
  ResolvedAssembly assembly;
  assembly.parts.resize(parts);
  for (const auto& [a, b] : joints) {
    assembly.parts[a.part].joined.at(at(a.end)) = b;
    assembly.parts[b.part].joined.at(at(b.end)) = a;
  }
  return assembly;
}

std::vector<Parts> runs(const ResolvedAssembly& assembly) {
  std::vector<Parts> result;
  for (const WeldedRun& run : welded_runs(assembly)) {
    result.push_back(run.parts);
  }
  return result;
}

TEST(WeldedRuns, are_walked_along_the_joints) {
  EXPECT_TRUE(runs(joined(0, {})).empty());
  EXPECT_THAT(runs(joined(2, {})), ElementsAre(Parts{0}, Parts{1}));
  // 2 - 0 - 3, by ends that do not all run the same way; 1 is alone.
  EXPECT_THAT(runs(joined(4, {{EndIndex{2, kStart}, {0, kStart}}, {EndIndex{0, kEnd}, {3, kEnd}}})),
              ElementsAre(Parts{2, 0, 3}, Parts{1}));
  // The same, named the other way round.
  EXPECT_THAT(runs(joined(4, {{EndIndex{3, kStart}, {0, kStart}}, {EndIndex{0, kEnd}, {2, kEnd}}})),
              ElementsAre(Parts{2, 0, 3}, Parts{1}));
  // Two runs, whose parts alternate.
  EXPECT_THAT(runs(joined(4, {{EndIndex{0, kEnd}, {2, kStart}}, {EndIndex{3, kEnd}, {1, kStart}}})),
              ElementsAre(Parts{0, 2}, Parts{1, 3}));
}

TEST(WeldedRuns, may_be_closed) {
  EXPECT_THAT(runs(joined(4, {{EndIndex{1, kEnd}, {3, kEnd}},
                              {EndIndex{3, kStart}, {2, kStart}},
                              {EndIndex{2, kEnd}, {1, kStart}}})),
              ElementsAre(Parts{0}, Parts{1, 3, 2}));
}

ResolvedPart part(const std::string& name, std::uint32_t index, const PartSurface& shape) {
  ResolvedPart result;
  result.name = name;
  result.index = index;
  result.shape = shape;
  return result;
}

RingedSurface pipe(double at, double length, double radius) {
  const Vec3 from(0, 0, at), to(0, 0, at + length);
  return {{from, Vec3(0, 0, -1), radius},
          {to, Vec3(0, 0, 1), radius},
          LineSpine{from, to},
          ConstantRadius{radius}};
}

RingedSurface half_torus(double bend_radius, double radius) {
  return {{Vec3(bend_radius, 0, 0), Vec3(0, -1, 0), radius},
          {Vec3(-bend_radius, 0, 0), Vec3(0, -1, 0), radius},
          ArcSpine{Vec3::Zero(), Vec3::UnitZ(), Vec3(bend_radius, 0, 0), kPi},
          ConstantRadius{radius}};
}

// Parts as they stand in a document of the tolerance.
struct Example {
  Assembly document;
  ResolvedAssembly resolved;

  Example(double tolerance, const std::vector<PartSurface>& shapes) {
    document.source = "d";
    document.tolerance = tolerance;
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
      document.parts.push_back({"part " + std::to_string(i), SphereAt()});
      resolved.parts.push_back(part(document.parts.back().name, i, shapes[i]));
    }
  }

  [[nodiscard]] double spacing() const { return lattice_spacing(document, resolved); }
  [[nodiscard]] RingSampling sampling(std::size_t position, const Parts& parts) const {
    return run_sampling(document, resolved, {parts}, position, spacing());
  }
};

TEST(WeldedRuns, the_lattice_resolves_the_smallest_size_of_all) {
  const struct {
    double tolerance;
    std::vector<PartSurface> shapes;
    double smallest;
  } rows[] = {
      {0.05, {pipe(0, 4, 1)}, 0.05},
      {8, {pipe(0, 4, 1)}, 1},
      {8, {pipe(0, 4, 1), pipe(9, 0.75, 3)}, 0.75},
      {8, {pipe(0, 4, 5), Sphere{Vec3(9, 9, 9), 3}}, 3},
      {8, {Sphere{Vec3(9, 9, 9), 2}, half_torus(9, 1.5)}, 1.5},
  };
  for (const auto& row : rows) {
    const double spacing = Example(row.tolerance, row.shapes).spacing();
    int exponent = 0;
    EXPECT_EQ(std::frexp(spacing, &exponent), 0.5) << "a power of two";
    EXPECT_LE(spacing, row.smallest / 2048);
    EXPECT_GT(spacing, row.smallest / 4096);
  }
}

TEST(WeldedRuns, coordinates_have_to_fit_on_the_lattice) {
  const auto refusal = [](const Example& example) {
    try {
      (void)example.spacing();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      return std::string(error.what());
    }
    return std::string();
  };
  // The spacing for 1 is 2^-11, and 2^51 of it are 2^40.
  EXPECT_EQ(refusal({1, {Sphere{Vec3(0, 0x1p40 - 9, 0), 2}}}), "");
  EXPECT_EQ(refusal({1, {Sphere{Vec3(0, 0x1p40, 0), 2}}}),
            "d#/tolerance: the tolerance, 1, is too small for coordinates of 1.09951e+12 (of "
            "'part 0'); it must be at least 2.00001");
  EXPECT_EQ(refusal({2, {Sphere{Vec3(0, -0x1p40, 0), 2}, Sphere{Vec3::Zero(), 1}}}),
            "d#/parts/1: 'part 1': its smallest radius or length, 1, is too small for coordinates "
            "of 1.09951e+12 (of 'part 0'); it must be at least 2.00001");
}

// A chord of n-th of a circle of radius r is r (1 - cos(pi / n)) off it.
double sagitta(double radius, std::uint32_t segments) {
  return radius * (1 - std::cos(kPi / segments));
}

TEST(WeldedRuns, rings_have_the_segments_that_the_widest_part_needs) {
  const Example both(0.01, {pipe(0, 4, 1), pipe(4, 4, 20)});
  const RingSampling narrow = both.sampling(0, {0}), wide = both.sampling(0, {1});
  EXPECT_LE(sagitta(1, narrow.segments), 0.01);
  EXPECT_LE(sagitta(20, wide.segments), 0.01);
  EXPECT_GT(sagitta(20, narrow.segments), 0.01);
  EXPECT_EQ(both.sampling(0, {0, 1}).segments, wide.segments);
  EXPECT_EQ(both.sampling(0, {1, 0}).segments, wide.segments);
  EXPECT_EQ(wide.grid, both.spacing());
  Example told = both;
  told.document.segments = 7;
  EXPECT_EQ(told.sampling(0, {0, 1}).segments, 7U);
}

TEST(WeldedRuns, runs_begin_at_different_angles) {
  const Example one(0.01, {pipe(0, 4, 1)});
  std::vector<double> phases;
  for (std::size_t position = 0; position < 20; ++position) {
    const double phase = one.sampling(position, {0}).phase;
    EXPECT_GE(phase, 0);
    EXPECT_LT(phase, 1);
    for (const double other : phases) {
      const double apart = std::abs(phase - other);
      EXPECT_GT(std::min(apart, 1 - apart), 0.009) << "modulo a segment";
    }
    phases.push_back(phase);
  }
}

TEST(WeldedRuns, parts_become_triangles_within_the_tolerance) {
  const double tolerance = 0.01;
  const Example example(tolerance, {half_torus(9, 1), Sphere{Vec3(0, 0, 20), 3}});
  const auto farthest = [&](std::uint32_t index, const auto& distance) {
    const Tessellation tessellation = tessellated(example.document, example.resolved.parts[index],
                                                  example.sampling(index, {index}));
    EXPECT_LE(tessellation.error_bound, tolerance);
    double largest = 0;
    for (const auto& [a, b, c] : tessellation.mesh.triangles) {
      const auto& points = tessellation.mesh.points;
      largest = std::max(largest, distance((points[a] + points[b] + points[c]) / 3));
    }
    EXPECT_LE(largest, tessellation.error_bound);
    return largest;
  };
  EXPECT_GT(farthest(0,
                     [](const Vec3& p) {
                       return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 9, p.z()) - 1);
                     }),
            tolerance / 10);
  EXPECT_GT(farthest(1, [](const Vec3& p) { return std::abs((p - Vec3(0, 0, 20)).norm() - 3); }),
            tolerance / 10);
}

TEST(WeldedRuns, faults_of_triangles_name_the_part) {
  // Its spine stops and turns back.
  RingedSurface back = pipe(0, 4, 1);
  back.spine = BezierSpine{{Vec3::Zero(), Vec3(0, 0, 9), Vec3(0, 0, 4)}};
  const Example stopping(0.01, {pipe(0, 4, 1), back});
  try {
    (void)tessellated(stopping.document, stopping.resolved.parts[1], {16, 0, 0});
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "part 1");
    EXPECT_THAT(error.where(), testing::StartsWith("d#/parts/1"));
  }
}

}  // namespace
}  // namespace dupin::assembly
