#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mesh/radial_order.h"

namespace dupin::mesh {
namespace {

struct Direction {
  std::array<int, 2> d;
  int number;
};

int turn(const Direction& a, const Direction& b) {
  const int sign = a.d[0] * b.d[1] - a.d[1] * b.d[0];
  return (sign > 0) - (sign < 0);
}
bool are_opposite(const Direction& a, const Direction& b) {
  return a.d[0] * b.d[0] + a.d[1] * b.d[1] < 0;
}
// Equal for coincident half-planes of so short directions, and only for them.
double angle_from(const Direction& first, const Direction& other) {
  const double turned = std::atan2(first.d[0] * other.d[1] - first.d[1] * other.d[0],
                                   first.d[0] * other.d[0] + first.d[1] * other.d[1]);
  const double angle = turned < 0 ? turned + 2 * M_PI : turned;
  return std::round(angle * 1e6);
}

TEST(RadialOrder, is_that_of_angles_from_the_first) {
  std::mt19937 random(12);
  const auto coordinate = [&random] { return static_cast<int>(random() % 9) - 4; };
  for (int round = 0; round < 2000; ++round) {
    std::vector<Direction> directions;
    while (directions.size() < 2 + static_cast<std::size_t>(round) % 9) {
      const std::array<int, 2> d{coordinate(), coordinate()};
      if (d != std::array{0, 0}) {
        directions.push_back({d, static_cast<int>(directions.size())});
      }
    }
    std::vector<Direction> expected = directions;
    std::stable_sort(expected.begin(), expected.end(), [&](const auto& a, const auto& b) {
      return angle_from(directions[0], a) < angle_from(directions[0], b);
    });
    sort_around_edge(directions, turn, are_opposite);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      ASSERT_EQ(directions[i].number, expected[i].number) << round;
    }
  }
}

}  // namespace
}  // namespace dupin::mesh
