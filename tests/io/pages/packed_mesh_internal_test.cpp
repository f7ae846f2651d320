#include <gtest/gtest.h>

#include "pages/packed_mesh.h"
#include "support/sample_meshes.h"
#include "support/shapes.h"

namespace dupin::pages {
namespace {

// The reader of the page (geometry.js), written anew.
class Numbers {
 public:
  explicit Numbers(const std::string& bytes) : bytes_(bytes) {}

  std::uint64_t next() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_.at(at_++));
      value |= std::uint64_t(byte & 127) << shift;
      if (byte < 128) {
        return value;
      }
    }
  }

  std::int64_t next_signed() {
    const auto value = static_cast<std::int64_t>(next());
    return value % 2 == 0 ? value / 2 : -(value + 1) / 2;
  }

  [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

TriMesh unpacked(const PackedMesh& packed) {
  Numbers numbers(packed.bytes);
  TriMesh mesh;
  Eigen::Matrix<std::int64_t, 3, 1> last(0, 0, 0);
  for (std::size_t i = 0; i < packed.points; ++i) {
    for (int k = 0; k < 3; ++k) {
      last[k] += numbers.next_signed();
    }
    mesh.points.emplace_back(packed.center + packed.step * last.cast<double>());
  }
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < packed.triangles; ++i) {
    Triangle& triangle = mesh.triangles.emplace_back();
    for (std::uint32_t& corner : triangle) {
      const auto back = static_cast<std::uint32_t>(numbers.next());
      corner = next - back;
      next += back == 0 ? 1 : 0;
    }
  }
  for (const auto& [label, count] : packed.runs) {
    mesh.labels.insert(mesh.labels.end(), count, label);
  }
  EXPECT_TRUE(numbers.at_end());
  return mesh;
}

TEST(PackedMesh, holds_every_triangle_within_a_step) {
  for (const double far : {0.0, 1e6}) {
    const TriMesh mesh = test::moved(test::tube(3, -7, 11, 50), {far, -far, far / 3});
    const PackedMesh packed = pages::packed(mesh);
    const TriMesh read = unpacked(packed);
    ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
    EXPECT_LE(packed.step, 18.0 / (1 << 21));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 off = read.points[read.triangles[i][k]] - mesh.points[mesh.triangles[i][k]];
        EXPECT_LE(off.cwiseAbs().maxCoeff(), packed.step * 0.500001);
      }
    }
  }
}

TEST(PackedMesh, sorts_triangles_by_label_and_drops_unused_points) {
  TriMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
  mesh.points.emplace_back(100, 100, 100);
  mesh.names = {"none", "a", "b"};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    mesh.labels.push_back(i % 2 == 0 ? 2 : 1);
  }
  const PackedMesh packed = pages::packed(mesh);
  EXPECT_EQ(packed.points, 8);
  EXPECT_EQ(packed.runs, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{1, 6}, {2, 6}}));
  EXPECT_EQ(unpacked(packed).labels.size(), 12);
}

TEST(PackedMesh, of_nothing_is_nothing) {
  const PackedMesh packed = pages::packed({});
  EXPECT_EQ(packed.points + packed.triangles + packed.bytes.size() + packed.runs.size(), 0);
}

TEST(PackedMesh, takes_few_bytes) {
  const TriMesh mesh = test::tube(3, -7, 11, 4000);
  EXPECT_LT(pages::packed(mesh).bytes.size(), mesh.triangles.size() * 12);
}

}  // namespace
}  // namespace dupin::pages
