#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gmock/gmock.h>

#include "blends/verification/solids_internal.h"
#include "dupin/kernel/error.h"
#include "verification/admitted.h"

namespace dupin::verification {
namespace {

const double kInfinity = std::numeric_limits<double>::infinity();

// Of the part that results, or "" if it is admitted.
std::string refused(const CertifiedPart& part) {
  try {
    (void)AdmittedPart(part);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    return error.message();
  }
}

std::string refused(const RingedSurface& surface) { return refused(test::part(surface)); }

RingedSurface changed(const std::function<void(RingedSurface&)>& change) {
  RingedSurface surface = test::elbow(4, 1.5, 1);
  change(surface);
  return surface;
}

TEST(AdmittedPart, takes_shapes_as_they_come) {
  EXPECT_EQ(refused(test::elbow(4, 1.5, 1)), "");
  EXPECT_EQ(refused(test::cone({0, 0, 0}, {1, 2, 3}, 1, 2)), "");
  EXPECT_EQ(refused(test::ball_part({1, 2, 3}, 4)), "");
  const CertifiedPart part = test::part(test::cylinder({0, 0, 0}, {1, 0, 0}, 1));
  EXPECT_EQ(&*AdmittedPart(part), &part);
}

TEST(AdmittedPart, has_numbers_in_range) {
  using testing::HasSubstr;
  for (const double bad : {kInfinity, -kInfinity, std::nan(""), 0x1p301, -0x1p301}) {
    EXPECT_THAT(refused(changed([=](auto& s) { s.start.center.y() = bad; })), HasSubstr("number"));
    EXPECT_THAT(refused(changed([=](auto& s) { s.end.slope = bad; })), HasSubstr("number"));
    EXPECT_NE(refused(changed([=](auto& s) { s.end.radius = bad; })), "");
    EXPECT_NE(refused(changed([=](auto& s) { s.radius = LinearRadius{1, bad}; })), "");
    EXPECT_NE(refused(changed([=](auto& s) { s.radius = BezierRadius{{1, bad}}; })), "");
    EXPECT_NE(refused(changed([=](auto& s) {
                s.spine = HermiteSpine{{0, 0, 0}, {1, 0, 0}, {1, 0, bad}, {1, 0, 0}};
              })),
              "");
    EXPECT_NE(refused(test::ball_part({0, bad, 0}, 1)), "");
    EXPECT_NE(refused(test::ball_part({0, 0, 0}, bad)), "");
  }
  EXPECT_EQ(refused(test::ball_part({0, 0x1p300, -0x1p300}, 0x1p300)), "");
  EXPECT_EQ(refused(test::ball_part({0, 0, 0}, 5e-324)), "");
}

TEST(AdmittedPart, has_positive_radii_and_unit_directions) {
  using testing::HasSubstr;
  for (const double bad : {0.0, -1.0}) {
    EXPECT_THAT(refused(test::ball_part({0, 0, 0}, bad)), HasSubstr("'radius'"));
    EXPECT_THAT(refused(changed([=](auto& s) { s.start.radius = bad; })), HasSubstr("'radius'"));
    for (const RadiusLaw& law : {RadiusLaw(ConstantRadius{bad}), RadiusLaw(LinearRadius{bad, 1}),
                                 RadiusLaw(LinearRadius{1, bad}), RadiusLaw(CubicRadius{1, bad}),
                                 RadiusLaw(CyclideRadius{bad, 1})}) {
      EXPECT_THAT(refused(changed([&](auto& s) { s.radius = law; })), HasSubstr("'radius'"));
    }
  }
  for (const double bad : {0.0, 2.0, 1 + 1e-8}) {
    EXPECT_THAT(refused(changed([=](auto& s) { s.end.normal *= bad; })), HasSubstr("direction"));
    EXPECT_THAT(refused(changed([=](auto& s) { std::get<ArcSpine>(s.spine).axis *= bad; })),
                HasSubstr("direction"));
  }
  EXPECT_THAT(refused(changed([](auto& s) {
                std::get<ArcSpine>(s.spine).axis = Vec3(1e-8, 0, 1).normalized();
              })),
              HasSubstr("'axis'"));
  EXPECT_THAT(refused(changed([](auto& s) {
                auto& arc = std::get<ArcSpine>(s.spine);
                arc.center = arc.start;
              })),
              HasSubstr("'axis'"));
  EXPECT_EQ(refused(changed([](auto& s) { std::get<ArcSpine>(s.spine).angle = 64; })), "");
  for (const double bad : {0.0, -1.0, 65.0}) {
    EXPECT_THAT(refused(changed([=](auto& s) { std::get<ArcSpine>(s.spine).angle = bad; })),
                HasSubstr("'angle'"));
  }
}

TEST(AdmittedPart, has_ellipses_whose_axes_are_across) {
  const auto with = [](const Vec3& axis, double across) {
    RingedSurface s = test::cylinder({0, 0, 0}, {1, 0, 0}, 1);
    s.start.ellipse = Ellipse{axis, across, 0};
    return s;
  };
  EXPECT_EQ(refused(with({0, 0, 1}, 2)), "");
  EXPECT_NE(refused(with({0, 0, 2}, 2)), "");
  EXPECT_NE(refused(with({.6, 0, .8}, 2)), "");
  EXPECT_NE(refused(with({0, 0, 1}, 0)), "");
  EXPECT_NE(refused(with({0, 0, 1}, kInfinity)), "");
}

TEST(AdmittedPart, has_few_coefficients_and_weights_in_range) {
  const auto with = [](std::size_t points, std::vector<double> weights) {
    return changed([&](auto& s) {
      BezierSpine spine;
      for (std::size_t i = 0; i < points; ++i) {
        spine.points.emplace_back(double(i), 0, 0);
      }
      spine.weights = std::move(weights);
      s.spine = spine;
    });
  };
  EXPECT_EQ(refused(with(13, {})), "");
  EXPECT_NE(refused(with(14, {})), "");
  EXPECT_NE(refused(with(1, {})), "");
  EXPECT_EQ(refused(with(2, {0x1p100, 0x1p-100})), "");
  for (const double bad : {0x1p101, 0x1p-101, 5e-309, 0.0, -1.0, std::nan("")}) {
    EXPECT_NE(refused(with(2, {1, bad})), "") << bad;
  }
  EXPECT_NE(refused(with(3, {1, 1})), "");
  const auto radii = [](std::size_t count) {
    return changed([=](auto& s) { s.radius = BezierRadius{std::vector<double>(count, 1)}; });
  };
  EXPECT_EQ(refused(radii(13)), "");
  EXPECT_NE(refused(radii(14)), "");
  EXPECT_NE(refused(radii(0)), "");
}

TEST(AdmittedPart, has_rotations_of_2_to_13_quaternions) {
  const auto with = [](std::size_t count) {
    const RingedSurface like = test::cylinder({0, 0, 0}, {1, 0, 0}, 1);
    RationalRingedTube tube{like.start, like.end, {}};
    tube.surface.center.fill(Vec3::Zero());
    tube.surface.radius.fill(1);
    tube.surface.rotation.assign(count, {1, 0, 0, 0});
    return tube;
  };
  for (const std::size_t good : {2, 13}) {
    EXPECT_EQ(refused(test::part(with(good))), "");
  }
  for (const std::size_t bad : {0, 1, 14}) {
    EXPECT_NE(refused(test::part(with(bad))), "");
  }
  RationalRingedTube tube = with(2);
  tube.surface.rotation[1][3] = kInfinity;
  EXPECT_NE(refused(test::part(tube)), "");
  tube = with(2);
  tube.surface.radius[2] = kInfinity;
  EXPECT_NE(refused(test::part(tube)), "");
}

TEST(AdmittedPart, has_walls_of_cyclide_pieces_only) {
  CertifiedPart pipe = test::part(test::cylinder({0, 0, 0}, {1, 0, 0}, 1));
  auto& chain = std::get<Chain>(pipe.shape);
  EXPECT_EQ(refused(pipe), "");
  for (const double wall : {-4.0, .5, kInfinity, std::nan("")}) {
    chain.wall = wall;
    EXPECT_THAT(refused(pipe), testing::HasSubstr("'wall'")) << wall;
  }
}

TEST(Parameter, is_a_multiple_of_a_small_number_within_the_part) {
  for (const double good : {0.0, 0x1p-64, .1, 1.0, 1.5, 2.0}) {
    EXPECT_TRUE(is_parameter(good, 2)) << good;
  }
  for (const double bad : {-0x1p-64, 0x1p-65, 5e-324, 2.0000001, kInfinity, std::nan("")}) {
    EXPECT_FALSE(is_parameter(bad, 2)) << bad;
  }
  EXPECT_TRUE(is_stretch({.5, .5}, 1));
  EXPECT_TRUE(is_stretch({0, 1}, 1));
  EXPECT_FALSE(is_stretch({.75, .5}, 1));
  EXPECT_FALSE(is_stretch({0, 1.5}, 1));
  EXPECT_FALSE(is_stretch({-.5, 1}, 1));
}

TEST(Bound, is_not_negative_and_not_too_large) {
  for (const double good : {0.0, 5e-324, 1.0, 0x1p300}) {
    EXPECT_TRUE(is_bound(good));
  }
  for (const double bad : {-5e-324, -1.0, 0x1p301, kInfinity, std::nan("")}) {
    EXPECT_FALSE(is_bound(bad));
  }
  EXPECT_TRUE(is_point({0x1p300, -0x1p300, 0}));
  EXPECT_FALSE(is_point({0, 0, std::nan("")}));
  EXPECT_FALSE(is_point({0, -kInfinity, 0}));
}

TEST(Name, takes_one_line) {
  for (const char* good : {"a pipe, or zwölf", "\u00a0\u2027\u202f\u2065\u206a", "\u0142"}) {
    EXPECT_TRUE(is_name(good)) << good;
  }
  for (const char* bad :
       {"a\nb", "\t", "\x1b[2J", "\x7f", "\xc2\x80", "a\xc2\x85", "\xc2\x9b[2J", "\xc2\x9f",
        "\u2028", "a\u2029b", "\u202a", "\u202e", "\u2066", "\u2069"}) {
    EXPECT_FALSE(is_name(bad));
  }
}

}  // namespace
}  // namespace dupin::verification
