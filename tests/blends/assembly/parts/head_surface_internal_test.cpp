#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "assembly/parts/head_surface.h"
#include "dupin/blends/part_measures.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

constexpr double kPi = std::numbers::pi;
const Ring kStart{{1, 2, 3}, {0, 0, -1}, 2};

// Along the axis from the start, and off it, at a parameter of a chain.
std::pair<double, double> meridian(const PartSurface& head, double at) {
  const Chain& chain = std::get<Chain>(head);
  const auto piece = std::min(std::size_t(at), chain.pieces.size() - 1);
  const auto& tube = std::get<RingedSurface>(chain.pieces[piece]);
  const double t = at - double(piece);
  return {evaluate(tube.spine, t).position.z() - 3, evaluate(tube.radius, t).value};
}

template <class Check>
void along(const PartSurface& head, const Check& check) {
  const auto pieces = double(std::get<Chain>(head).pieces.size());
  for (int i = 0; i <= 400; ++i) {
    const auto [level, radius] = meridian(head, pieces * i / 400);
    check(level, radius);
  }
}

TEST(HeadSurface, of_an_ellipsoid_is_within_what_it_says) {
  along(head_surface(kStart, EllipsoidProfile{0.7}), [](double level, double radius) {
    // The gradient of the ellipsoid's function is at least 1 here: off by no more than its value.
    EXPECT_NEAR(std::hypot(level / 0.7, radius / 2), 1, kHeadDeviation * 2);
  });
}

TEST(HeadSurface, of_a_torisphere_lies_on_the_torus_and_on_the_sphere) {
  const double crown = 3.2, knuckle = 0.5, off = 2 - knuckle, apart = crown - knuckle;
  const double center = -std::sqrt(apart * apart - off * off);
  along(head_surface(kStart, TorisphereProfile{crown, knuckle}), [&](double level, double radius) {
    const double torus = std::hypot(level, radius - off) - knuckle,
                 sphere = std::hypot(level - center, radius) - crown;
    EXPECT_NEAR(std::min(std::abs(torus), std::abs(sphere)), 0, kHeadDeviation * 2);
  });
}

TEST(HeadSurface, pieces_share_rings_and_end_in_the_tip) {
  const PartSurface head = head_surface(kStart, TorisphereProfile{4, 0.4});
  const Chain& chain = std::get<Chain>(head);
  EXPECT_EQ(*port_ring(head, End::start), kStart);
  for (std::size_t i = 1; i < chain.pieces.size(); ++i) {
    EXPECT_EQ(end_ring(chain.pieces[i], End::start),
              flipped(end_ring(chain.pieces[i - 1], End::end)));
  }
  EXPECT_NEAR(port_ring(head, End::end)->radius, 2.0 / 256, 1e-15);
}

// The tip that is cut off has less than 1e-9 of the volume.
TEST(HeadSurface, has_the_volume_of_its_form) {
  const auto volume = [](const HeadProfile& profile) {
    return measures(head_surface(kStart, profile)).solid->volume;
  };
  const double ellipsoid = 2 * kPi / 3 * 4 * 1;
  EXPECT_NEAR(volume(EllipsoidProfile{1}), ellipsoid, 1e-9 * ellipsoid);
  // Ball caps and tori by Pappus: of crown R, knuckle r and a = radius - r, the knuckle's part
  // between 0 and z1 = r sin p is pi (a^2 z1 + 2 a (half of a segment) + r^2 z1 - z1^3 / 3).
  const double crown = 4, r = 0.4, a = 2 - r,
               sine = std::sqrt(1 - a * a / ((crown - r) * (crown - r)));
  const double z1 = r * sine, angle = std::asin(sine);
  const double strip = (r * r * angle + z1 * std::sqrt(r * r - z1 * z1)) / 2;  // of cos over z
  const double knuckle = kPi * (a * a * z1 + 2 * a * strip + r * r * z1 - z1 * z1 * z1 / 3);
  const double height = crown - crown * sine, cap = kPi * height * height * (crown - height / 3);
  EXPECT_NEAR(volume(TorisphereProfile{crown, r}), knuckle + cap, 1e-9 * (knuckle + cap));
}

TEST(HeadSurface, of_a_bore_is_parallel_or_says_why_there_is_none) {
  const double wall = 0.25;
  const Ring& ring = *port_ring(inner_head(kStart, TorisphereProfile{4, 0.4}, wall), End::start);
  EXPECT_EQ(ring.radius, 1.75);
  const double inner = port_ring(inner_head(kStart, TorisphereProfile{4, 0.4}, wall), End::end)
                           ->center.z(),
               outer =
                   port_ring(head_surface(kStart, TorisphereProfile{4, 0.4}), End::end)->center.z();
  EXPECT_NEAR(outer - inner, wall, 1e-5);
  EXPECT_THROW((void)inner_head(kStart, TorisphereProfile{4, 0.2}, wall), Error);
  EXPECT_THROW((void)inner_head(kStart, EllipsoidProfile{0.2}, wall), Error);
  // Outwards, for insulation.
  EXPECT_EQ(port_ring(inner_head(kStart, EllipsoidProfile{1}, -wall), End::start)->radius, 2.25);
}

}  // namespace
}  // namespace dupin::assembly
