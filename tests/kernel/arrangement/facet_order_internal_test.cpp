#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "arrangement/facet_order.h"

namespace dupin::arrangement {
namespace {

// Fins at the edge from point 0 to point 1, which runs along (1, 2, 2).
struct Fins {
  ArrangementInput input;
  std::vector<double> angles;
  std::vector<HalfPlane> half_planes;
};

Fins random_fins(std::mt19937& random, std::uint32_t count) {
  const Vec3 axis(1, 2, 2), u(2, 1, -2), w = axis.cross(u) / 3;
  Fins fins;
  fins.input.points.add(Vec3(Vec3::Zero()));
  fins.input.points.add(axis);
  for (std::uint32_t i = 0; i < count; ++i) {
    // Whole steps, so that no two are nearly equal; opposite ones occur.
    double angle = 0;
    do {
      angle = 2 * M_PI * static_cast<double>(random() % 24) / 24;
    } while (std::find(fins.angles.begin(), fins.angles.end(), angle) != fins.angles.end());
    fins.angles.push_back(angle);
    const double along = static_cast<double>(random() % 9) - 4;
    const PointId apex =
        fins.input.points.add(Vec3(along * axis + std::cos(angle) * u + std::sin(angle) * w));
    const bool forward = random() % 2 == 0;
    fins.input.triangles.push_back(forward ? Triangle{0, 1, apex} : Triangle{1, 0, apex});
    fins.half_planes.push_back({apex, i, forward, i});
  }
  return fins;
}

TEST(FacetOrder, is_that_of_angles_from_the_first) {
  const UpwardRounding rounding;
  std::mt19937 random(23);
  for (int round = 0; round < 500; ++round) {
    Fins fins = random_fins(random, 2 + static_cast<std::uint32_t>(round) % 10);
    const auto from_first = [&](const HalfPlane& h) {
      const double turned = fins.angles[h.owner] - fins.angles[0];
      return turned < 0 ? turned + 2 * M_PI : turned;
    };
    std::vector<HalfPlane> expected = fins.half_planes;
    std::ranges::sort(expected, {}, from_first);
    order_facets_around_edge(fins.input, fins.half_planes);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(fins.half_planes[i].owner, expected[i].owner) << round;
    }
  }
}

}  // namespace
}  // namespace dupin::arrangement
