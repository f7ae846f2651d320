#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/json/facing_pipes.h"

namespace dupin {
namespace {

using test::chain;
using test::facing_pipes_and;
using test::refusal;
using testing::HasSubstr;

TEST(KeptClear, a_cyclic_blend_that_comes_too_near_becomes_a_spline) {
  const auto blend = [](const std::string& radius) {
    return facing_pipes_and(
        R"("cyclic_blend": {"from": "a.end", "to": "b.start", "k": "auto", "l": "auto",
      "avoid": [{"ball": {"center": [0, 6, 0], "radius": )" +
        radius + R"(}}], "clearance": 1})");
  };
  const Assembly far = parse_assembly(blend("2"));
  EXPECT_EQ(chain(resolve(far)).pieces.size(), 1);
  EXPECT_GT(chain(resolve(parse_assembly(blend("5")))).pieces.size(), 1);
  const Assembly again = parse_assembly(document_text(far));
  EXPECT_EQ(std::get<CyclicBlendBetween>(again.parts[2].shape).avoid->clearance, 1);
}

// A document whose blend has no points.
TEST(KeptClear, a_cyclic_blend_proposes_no_speeds_that_lead_into_what_it_avoids) {
  const auto blend = [](const std::string& k, const std::string& l) {
    return refusal(R"({"units": "mm", "tolerance": 0.05, "wall": 1.85, "parts": [
      {"name": "a", "pipe": {"from": [-20, 0, 0], "to": [0, 0, 0], "radius": 5.62}},
      {"name": "b", "pipe": {"from": [17.36, -4.28, -12.48], "direction": [-0.54, -0.61, 0.83],
        "length": 20, "radius": 5.96}},
      {"name": "x", "cyclic_blend": {"from": "a.end", "to": "b.start", "k": )" +
                   k + R"(, "l": )" + l +
                   R"(, "avoid": [{"ball": {"center": [8.68, -2.14, -6.24], "radius": 3.97}}],
        "clearance": 1.18}}]})");
  };
  const std::string proposed = blend("\"auto\"", "\"auto\"");
  EXPECT_THAT(proposed, HasSubstr("no end speeds"));
  EXPECT_THAT(proposed, testing::Not(HasSubstr(" has enough, with")));
  const std::string followed = blend("187.1", "108.4");
  EXPECT_THAT(followed, HasSubstr("it does not keep 1.18 from 'avoid/0'"));
  EXPECT_THAT(followed, HasSubstr("a spline was to go round in its place, but the one from end to "
                                  "end, which that begins with, folds, and no straight pipes and "
                                  "elbows were found either; what may help is less clearance"));
  EXPECT_THAT(followed, testing::Not(HasSubstr("its points")));
}

TEST(KeptClear, a_ringed_blend_takes_lengths_with_which_it_keeps_clear) {
  const auto blend = [](const std::string& clearance) {
    return R"({"units": "mm", "tolerance": 0.1, "parts": [
      {"name": "a", "pipe": {"from": [-30, 0, 0], "to": [-20, 0, 0], "radius": 1}},
      {"name": "b", "pipe": {"from": [0, 20, 0], "to": [0, 30, 0], "radius": 1}},
      {"name": "c", "ringed_blend": {"from": "a.end", "to": "b.start",
        "avoid": [{"ball": {"center": [-8, 8, 0], "radius": 1}}], "clearance": )" +
           clearance + "}}]}";
  };
  const auto center = [&](const std::string& clearance) {
    const ResolvedAssembly resolved = resolve(parse_assembly(blend(clearance)));
    return std::get<RationalRingedTube>(chain(resolved).pieces[0]).surface.center;
  };
  EXPECT_NE(center("0.1"), center("3"));
  EXPECT_THAT(refusal(blend("9")), HasSubstr("too near to what it avoids: it does not keep 9 from "
                                             "'avoid/0'"));
}

}  // namespace
}  // namespace dupin
