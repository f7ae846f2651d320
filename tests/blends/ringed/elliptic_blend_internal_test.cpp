#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "ringed/elliptic_blend.h"

namespace dupin::ringed {
namespace {

const Ring kFrom{Vec3(0, 0, 0), Vec3::UnitX(), 0.5, 0, Ellipse{Vec3::UnitY(), 0.4}};

TEST(EllipticBlend, is_the_one_that_the_library_makes) {
  const Ring to{Vec3(10, 4, 0), -Vec3::UnitX(), 1};
  const EllipticTube blend = elliptic_blend_without(kFrom, to, {}, {});
  EXPECT_EQ(blend.start, flipped(kFrom));
  EXPECT_EQ(blend.spine, elliptic_blend(kFrom, to, {}).spine);
}

TEST(EllipticBlend, names_what_is_wrong_with_the_speeds_that_it_proposes) {
  const Ring to{Vec3(3.576, 0.044, 1.598), -Vec3::UnitY(), 1};
  const auto why = [&](const BlendFault& also) -> std::string {
    try {
      (void)elliptic_blend_without(kFrom, to, {}, also);
    } catch (const Error& error) {
      return error.message();
    }
    return {};
  };
  EXPECT_THAT(why({}), testing::HasSubstr(" has enough, with a spine that is "));
  EXPECT_THAT(why([](const RingedSurface&) { return std::optional<std::string>("is red"); }),
              testing::AllOf(testing::HasSubstr(" has enough for the blend alone, with a spine"),
                             testing::HasSubstr(", but the blend is red")));
}

}  // namespace
}  // namespace dupin::ringed
