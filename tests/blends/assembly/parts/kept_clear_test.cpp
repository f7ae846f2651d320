#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using testing::HasSubstr;

// Two pipes that face each other, and what joins them.
std::string document(const std::string& part) {
  return R"({"units": "mm", "tolerance": 0.1, "parts": [
    {"name": "a", "pipe": {"from": [-30, 0, 0], "to": [-20, 0, 0], "radius": 1}},
    {"name": "b", "pipe": {"from": [20, 0, 0], "to": [30, 0, 0], "radius": 1}},
    {"name": "c", )" +
         part + "}]}";
}

const Chain& chain(const ResolvedAssembly& resolved) {
  return std::get<Chain>(resolved.parts[2].shape);
}

std::string refusal(const std::string& text) {
  try {
    (void)resolve(parse_assembly(text));
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(KeptClear, a_cyclic_blend_that_comes_too_near_becomes_a_spline) {
  const auto blend = [](const std::string& radius) {
    return document(R"("cyclic_blend": {"from": "a.end", "to": "b.start", "k": "auto", "l": "auto",
      "avoid": [{"ball": {"center": [0, 6, 0], "radius": )" +
                    radius + R"(}}], "clearance": 1})");
  };
  const Assembly far = parse_assembly(blend("2"));
  EXPECT_EQ(chain(resolve(far)).pieces.size(), 1);
  EXPECT_GT(chain(resolve(parse_assembly(blend("5")))).pieces.size(), 1);
  const Assembly again = parse_assembly(document_text(far));
  EXPECT_EQ(std::get<CyclicBlendBetween>(again.parts[2].shape).avoid->clearance, 1);
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
