#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "blends/random_blends.h"
#include "dupin/blends/pipe_graph.h"

namespace dupin {
namespace {

// All thousand take some 150 s:
//   DUPIN_RANDOM_BLENDS=1000 build/dev/tests/blends/blends_certificate_long_test
TEST(Certificate, never_claims_embedded_what_meets_itself_in_hundreds_of_blends) {
  const char* count = std::getenv("DUPIN_RANDOM_BLENDS");
  test::compare_prover_and_mesh(2026, count != nullptr ? std::atoi(count) : 200);
}

// Two pipes that wind about each other: what the checker may do ends in the second one.
TEST(Certificate, of_splines_of_thousands_of_points_is_what_verify_has_the_work_for) {
  constexpr int kPoints = 2500;
  const auto place = [](int i, double side) {
    return Vec3(side * 10 * std::cos(.05 * i), side * 10 * std::sin(.05 * i), .02 * i);
  };
  Assembly assembly{"helices.json", Unit::millimetre, 0.01, {}, {}};
  for (const double side : {1., -1.}) {
    const std::string name = side > 0 ? "one" : "other";
    const Vec3 first = place(0, side), last = place(kPoints - 1, side);
    const Vec3 in = (place(1, side) - first).normalized(),
               out = (last - place(kPoints - 2, side)).normalized();
    assembly.parts.push_back({name + " in", PipeBetween{first - .3 * in, first, .3}});
    assembly.parts.push_back({name + " out", PipeBetween{last, last + .3 * out, .3}});
    SplineBetween spline{
        PortReference{name + " in", End::end}, PortReference{name + " out", End::start}, {}};
    for (int i = 1; i + 1 < kPoints; ++i) {
      spline.through.push_back({place(i, side), .3});
    }
    assembly.parts.push_back({name, spline});
  }
  const Certificate found = certify(assembly);
  EXPECT_EQ(found.claims[2].embedded->verdict, Verdict::proved);
  EXPECT_GT(found.findings(), 0U) << "and yet not all of it";
  verify(found);
}

// 292 parts of junctions, of which the checks take all the work that there is.
TEST(Certificate, of_many_junctions_has_claims_of_near_pairs_only) {
  constexpr std::uint32_t kSide = 7;
  PipeGraph graph;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    const std::uint32_t column = i % kSide, row = i / kSide;
    graph.nodes.push_back({std::to_string(i), Vec3(20. * column, 20. * row, 0)});
    if (column > 0) {
      graph.edges.push_back({i - 1, i});
    }
    if (row > 0) {
      graph.edges.push_back({i - kSide, i});
    }
  }
  const Certificate found = certify(assembly_of(graph, {.radius = 2}).assembly);
  verify(found);
  EXPECT_GT(found.apart, 0);
  EXPECT_LT(found.clearances.size(), 5 * found.parts.size());
  const auto proved = std::ranges::count(found.clearances, Verdict::proved,
                                         [](const ClearanceClaim& c) { return c.verdict; });
  EXPECT_GT(proved, 50) << "meshes leave some of the work";
}

}  // namespace
}  // namespace dupin
