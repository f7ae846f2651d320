#include "io/json/random_documents.h"

#include <string>

#include <gtest/gtest.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"

namespace dupin {
namespace {

TEST(RandomDocuments, are_certified_as_the_checker_agrees) { test::expect_all_verified(7, 100); }

Certificate verified(const std::string& document) {
  const Certificate certificate = certify(parse_assembly(document, "d.json"));
  EXPECT_NO_THROW(verify(parse_certificate(certificate_json(certificate))));
  return certificate;
}

// The leaves of a ball have no length to lose, those of the pipe that it nearly touches do.
TEST(RandomDocuments, of_a_ball_that_nearly_touches_are_verified) {
  verified(R"({"units": "mm", "tolerance": 0.05, "parts": [
    {"name": "p", "pipe": {"from": [0, 0, 0], "to": [10, 0, 0], "radius": 0.3972133285859532}},
    {"name": "q", "sphere": {"center": [9.403353041677809, 0, 1.7132049776509986],
                             "radius": 1.3159916490415817}}]})");
}

// Prover and checker know its curvature, which should be 0, to other last bits.
TEST(RandomDocuments, of_equal_curvature_between_cones_are_verified) {
  const Certificate certificate = verified(R"({"units": "mm", "tolerance": 0.02, "parts": [
    {"name": "in", "cone": {"from": [-3.8372469696941134, 0.41081022416962154, 1.5091561517601628],
                            "to": [0, 0, 0], "radii": [0.29889539001019416, 0.3236357467958464]}},
    {"name": "out", "cone": {"from": [3.8590791059663627, 1.1307545, -1.327218051946017],
      "direction": [0.9535648283136055, -0.16249843765669422, 0.25359096190987906],
      "length": 0.8914217022195896, "radii": [0.97340026172576, 0.8747017448363362]}},
    {"name": "blend", "cyclic_blend": {"from": "in.end", "to": "out.start", "radius_law": "R1",
      "k": "auto", "l": "auto", "continuity": "G2"}}]})");
  for (const TangencyClaim& end : certificate.claims[2].tangency) {
    ASSERT_TRUE(end.curvature);
    EXPECT_LT(*end.curvature, 1e-9);
  }
}

}  // namespace
}  // namespace dupin
