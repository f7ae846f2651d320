#include <sstream>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "support/pipe_unions.h"

namespace dupin {
namespace {

using test::UnionKind;

struct Batch {
  const char* name;
  std::span<const UnionKind> kinds;
  std::vector<std::uint32_t> segments;
  std::uint32_t seeds;  // per kind and number of segments
};

std::ostream& operator<<(std::ostream& out, const Batch& batch) { return out << batch.name; }

/// What the rounded mesh promises, checked on its very numbers.
void expect_sound(const Solid& exact, Coordinates target) {
  const Rounded rounded = to_mesh(exact, target);
  const Report report = check(rounded.mesh());
  EXPECT_TRUE(report.is_solid());
  EXPECT_EQ(report.count(Defect::contact), 0) << "no two points are the same";
  EXPECT_EQ(report.components, exact.components());
  EXPECT_EQ(report.genus, exact.genus());
  // The boundary has moved by at most this; twice for the growth of the area on the way.
  EXPECT_NEAR(report.volume, exact.volume(),
              2 * report.area * rounded.report().largest_move + 1e-12 * exact.volume());
  if (target == Coordinates::binary32) {
    for (const Vec3& p : rounded.mesh().points) {
      ASSERT_EQ(p, p.cast<float>().cast<double>());
    }
  }
}

class RoundedUnions : public testing::TestWithParam<Batch> {};

TEST_P(RoundedUnions, are_solids_in_doubles_and_floats) {
  const Batch& batch = GetParam();
  for (const UnionKind kind : batch.kinds) {
    for (const std::uint32_t segments : batch.segments) {
      for (std::uint32_t seed = 0; seed < batch.seeds; ++seed) {
        std::ostringstream trace;
        trace << test::name(kind) << ", " << segments << " segments, seed " << seed;
        SCOPED_TRACE(trace.str());
        const Solid exact = unite(test::pipes(kind, segments, seed));
        expect_sound(exact, Coordinates::binary64);
        expect_sound(exact, Coordinates::binary32);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(some, RoundedUnions,
                         testing::Values(Batch{"design", test::kDesignKinds, {64}, 1},
                                         Batch{"plant", test::kPlantKinds, {64, 192}, 1}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace dupin
