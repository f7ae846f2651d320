#include <optional>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "kernel/nef_oracle.h"
#include "support/shapes.h"

namespace dupin {
namespace {

// Coordinates on a grid this coarse make coplanar faces and coincident edges and vertices common.
Vec3 on_grid(const Vec3& point, double spacing) {
  return (point / spacing).array().round().matrix() * spacing;
}

Solid random_part(std::mt19937_64& random, double spacing) {
  const auto between = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  for (;;) {
    TriMesh mesh = between(0, 2) == 0
                       ? test::box(Vec3::Constant(-1), Vec3(1, between(1, 3), between(1, 3)))
                       : test::tube(between(1, 2), -2, between(1, 3),
                                    static_cast<std::uint32_t>(between(3, 8)));
    const Vec3 axis(between(-2, 2), between(-2, 2), between(1, 2));
    const Eigen::AngleAxisd turn(between(0, 7) * 0.25, axis.normalized());
    const Vec3 shift(between(-1, 1), between(-1, 1), between(-1, 1));
    for (Vec3& point : mesh.points) {
      point = on_grid(turn * point + shift, spacing);
    }
    try {
      return Solid::from(mesh);
    } catch (const Error&) {  // snapped into itself
    }
  }
}

class RandomPair : public testing::TestWithParam<int> {};

// Nothing where the engine refuses a result that is no 2-manifold.
template <class Operation>
std::optional<Solid> attempt(Operation operation) {
  try {
    return operation();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::boolean_failed);
    return std::nullopt;
  }
}

TEST_P(RandomPair, agrees_with_nef_polyhedra) {
  const int seed = GetParam();
  std::mt19937_64 random(static_cast<std::uint64_t>(20250 + seed));
  const double spacing = seed % 2 == 0 ? 0.25 : 0x1p-20;
  const std::vector<Solid> both = {random_part(random, spacing), random_part(random, spacing)};
  const auto united = attempt([&] { return unite(both); });
  const auto common = attempt([&] { return intersect(both); });
  const auto rest = attempt([&] { return subtract(both[0], {&both[1], 1}); });
  if (united && common) {
    EXPECT_EQ(both[0].exact_volume() + both[1].exact_volume(),
              united->exact_volume() + common->exact_volume());
  }
  const struct {
    SetOperation operation;
    const std::optional<Solid>& ours;
  } table[] = {{SetOperation::unite, united},
               {SetOperation::intersect, common},
               {SetOperation::subtract, rest}};
  for (const auto& [operation, ours] : table) {
    SCOPED_TRACE(static_cast<int>(operation));
    const auto expected = test::by_nef(operation, both);
    const bool touches_itself = !ours || !ours->contacts().empty();
    ASSERT_EQ(expected.has_value(), !touches_itself);
    if (expected) {
      EXPECT_EQ(ours->exact_volume(), expected->exact_volume());
      EXPECT_EQ(ours->components(), expected->components());
      EXPECT_EQ(ours->genus(), expected->genus());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Boolean, RandomPair, testing::Range(0, 200));

}  // namespace
}  // namespace dupin
