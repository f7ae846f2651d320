#include <random>

#include <gtest/gtest.h>

#include "arrangement/operand_slabs.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

// A rod askew to the axes, of whole numbers.
TriMesh rod() {
  TriMesh mesh = test::box({0, 0, 0}, {1, 1, 1000});
  for (Vec3& p : mesh.points) {
    p = p.x() * Vec3(2, -1, 0) + p.y() * Vec3(1, 2, -5) + p.z() * Vec3(1, 2, 1);
  }
  return mesh;
}

TEST(OperandSlabs, contain_the_operand_and_little_besides) {
  const test::Stages stages({rod(), test::cube(0, 0, 0)});
  const ArrangementInput& input = stages.input;
  const UpwardRounding rounding;
  const OperandSlabs slabs(input, 0);
  std::mt19937 random(1);
  const auto share = [&] { return double(random() % 1025) / 1024; };
  int in_box = 0, in_slabs = 0;
  const Eigen::AlignedBox3d& box = input.bounds[0];
  for (int i = 0; i < 1000; ++i) {
    const Vec3 inside =
        share() * Vec3(2, -1, 0) + share() * Vec3(1, 2, -5) + 1000 * share() * Vec3(1, 2, 1);
    EXPECT_TRUE(slabs.may_contain({inside.x(), inside.y(), inside.z()}));
    const Vec3 anywhere = box.min() + Vec3(share(), share(), share()).cwiseProduct(box.sizes());
    ++in_box;
    in_slabs += slabs.may_contain({anywhere.x(), anywhere.y(), anywhere.z()}) ? 1 : 0;
  }
  for (const Vec3& corner : rod().points) {
    EXPECT_TRUE(slabs.may_contain({corner.x(), corner.y(), corner.z()}));
  }
  EXPECT_LT(in_slabs, in_box / 100);
}

}  // namespace
}  // namespace dupin::arrangement
