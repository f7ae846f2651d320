// Certificates of junctions: what is claimed, and that nothing else can be.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

const Certificate& honest() {
  static const Certificate certificate =
      certify(parse_assembly(R"({"units": "mm", "tolerance": 0.05,
    "parts": [
      {"name": "a", "pipe": {"from": [-12, 0, 0], "to": [-7, 0, 0], "radius": 1}},
      {"name": "b", "cone": {"from": [12, 1, 0], "to": [7, 0.5, 0], "radii": [1, 1.3]}},
      {"name": "c", "pipe": {"from": [0, 12, 2], "to": [0, 6, 1], "radius": 0.7}},
      {"name": "beside", "pipe": {"from": [-9, -9, 0], "to": [9, -9, 0], "radius": 1}},
      {"name": "hub", "junction": {"ends": ["a.end", "b.end", "c.end"]}}]})"));
  return certificate;
}

ClearanceClaim& at_hub(Certificate& c, std::size_t arm) {
  const auto& [hub, arms] = c.junctions.front();
  return *std::ranges::find_if(c.clearances, [&](const ClearanceClaim& claim) {
    return claim.first == arms[arm] && claim.second == hub;
  });
}

TEST(CertificateJunctions, are_proved_and_verified) {
  EXPECT_EQ(honest().findings(), 0);
  ASSERT_EQ(honest().junctions.size(), 1);
  EXPECT_EQ(honest().parts.back().name, "hub");
  EXPECT_EQ(honest().parts.back().kind, "junction");
  EXPECT_EQ(honest().junctions[0].arms.size(), 3);
  ASSERT_TRUE(honest().claims.back().mesh);
  EXPECT_LT(honest().claims.back().mesh->error_bound, 0.08);
  EXPECT_TRUE(honest().joined(at_hub(const_cast<Certificate&>(honest()), 0)));
  EXPECT_NO_THROW(verify(honest()));
  const Certificate again = parse_certificate(certificate_json(honest()));
  EXPECT_NO_THROW(verify(again));
  EXPECT_EQ(certificate_json(again), certificate_json(honest()));
}

TEST(CertificateJunctions, that_are_forged_do_not_follow) {
  const std::vector<std::pair<std::string, std::function<void(Certificate&)>>> forgeries{
      {"a larger hub",
       [](Certificate& c) { std::get<Sphere>(c.parts.back().shape).radius += 0.1; }},
      {"a hub elsewhere",
       [](Certificate& c) {
         auto& center = std::get<Sphere>(c.parts.back().shape).center;
         center.x() = std::nextafter(center.x(), 9);
       }},
      {"a hub without its arms", [](Certificate& c) { c.junctions[0].arms.resize(1); }},
      {"no hub at all", [](Certificate& c) { c.junctions.clear(); }},
      {"a hub twice", [](Certificate& c) { c.junctions.push_back(c.junctions[0]); }},
      {"an arm twice",
       [](Certificate& c) { c.junctions[0].arms.push_back(c.junctions[0].arms[0]); }},
      {"an arm that is none", [](Certificate& c) { c.junctions[0].arms.push_back(3); }},
      {"an arm for a hub", [](Certificate& c) { c.junctions[0].hub = c.junctions[0].arms[0]; }},
      {"a hub that is no part", [](Certificate& c) { c.junctions[0].hub = 99; }},
      {"arms that are no parts", [](Certificate& c) { c.junctions[0].arms[0] = 99; }},
      {"an arm of which some is not looked at",
       [](Certificate& c) { at_hub(c, 0).leaves.pop_back(); }},
      {"an arm looked at once, whatever it does",
       [](Certificate& c) {
         auto& leaves = at_hub(c, 1).leaves;
         leaves = {{{0, 1}, {0, 1}, {}}, {{1, 2}, {0, 1}, {}}};
       }},
      {"an arm that keeps clear of its hub", [](Certificate& c) { at_hub(c, 0).distance = 1e-6; }},
      {"a mesh without an error", [](Certificate& c) { c.claims.back().mesh->error_bound = 1e-6; }},
      {"a finer mesh than its bound is for",
       [](Certificate& c) { c.claims.back().mesh->segments /= 2; }},
      {"a hub that is joined to something",
       [](Certificate& c) {
         c.parts[c.junctions[0].arms[0]].joined[1] = EndIndex{3, End::start};
       }},
      {"a hub that is regular", [](Certificate& c) { c.claims.back().regular.emplace(); }},
  };
  for (const auto& [what, forge] : forgeries) {
    Certificate c = honest();
    forge(c);
    try {
      verify(c);
      ADD_FAILURE() << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument) << what << ": " << error.what();
    }
    try {
      verify(parse_certificate(certificate_json(c)));
      ADD_FAILURE() << what << ", read back";
    } catch (const Error&) {
    }
  }
}

// Wider caps on a smaller hub would overlap; the arms' own numbers say so.
TEST(CertificateJunctions, caps_that_overlap_are_found) {
  Certificate c = honest();
  const auto& arms = c.junctions[0].arms;
  // The arm of one pipe, once more.
  c.parts[arms[1]].shape = c.parts[arms[0]].shape;
  c.claims[arms[1]] = c.claims[arms[0]];
  c.parts[arms[1]].joined = {};
  c.parts[1].joined = {};
  try {
    verify(c);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'caps' does not follow"));
  }
}

}  // namespace
}  // namespace dupin
