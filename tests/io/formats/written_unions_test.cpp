// The unions that rounding breaks most, written with the coordinates they have and read back.
#include <algorithm>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "support/pipe_unions.h"
#include "support/scratch_directory.h"

namespace dupin {
namespace {

using test::UnionKind;

struct Batch {
  UnionKind kind;
  std::uint32_t segments, seeds;
};

class WrittenUnions : public test::ScratchDirectory, public testing::WithParamInterface<Batch> {
 protected:
  void expect_valid_file(const Solid& exact, const MeshFormat& format) const {
    const Rounded rounded = to_mesh(exact, format.coordinates);
    ASSERT_EQ(rounded.report().origin, Vec3::Zero());
    write_verified(path("x"), rounded.mesh(), format);
    const TriMesh read_back = read_mesh(path("x"));
    EXPECT_EQ(read_back.points.size(), rounded.mesh().points.size()) << "points in one place";
    EXPECT_NO_THROW(write_verified(path("x"), rounded, format));
    const Report report = check(read_back);
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(report.count(Defect::contact), 0);
    EXPECT_EQ(report.components, exact.components());
    EXPECT_EQ(report.genus, exact.genus());
    // The boundary has moved by at most this; twice for the growth of the area on the way.
    EXPECT_NEAR(report.volume, exact.volume(),
                2 * report.area * rounded.report().largest_move + 1e-12 * exact.volume());
  }
};

TEST_P(WrittenUnions, are_valid_when_read_back) {
  const auto& [kind, segments, seeds] = GetParam();
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Solid exact = unite(test::pipes(kind, segments, seed));
    expect_valid_file(exact, kOff);
    expect_valid_file(exact, kStlBinary);
  }
}

/// 300 of the design's kinds and 300 at the coordinates of a plant.
std::vector<Batch> all_batches() {
  std::vector<Batch> batches;
  for (const UnionKind kind : test::kDesignKinds) {
    batches.insert(batches.end(),
                   {{kind, 64, 30}, {kind, 128, 15}, {kind, 256, 10}, {kind, 512, 5}});
  }
  for (const UnionKind kind : test::kPlantKinds) {
    batches.insert(batches.end(), {{kind, 64, 75}, {kind, 192, 75}});
  }
  return batches;
}

INSTANTIATE_TEST_SUITE_P(All, WrittenUnions, testing::ValuesIn(all_batches()),
                         [](const auto& batch) {
                           std::string text(test::name(batch.param.kind));
                           std::erase_if(text,
                                         [](char c) { return c < '0' || c > 'z' || c == '='; });
                           return text + "_" + std::to_string(batch.param.segments);
                         });

}  // namespace
}  // namespace dupin
