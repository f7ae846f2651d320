#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

const std::string kDocument = R"({"units": "mm", "tolerance": 0.1, "parts": [
  {"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 2, 3], "radius": 1}},
  {"name": "b", "pipe": {"from": "a.end", "length": 4}}]})";

Certificate certificate() {
  Certificate result = certify(parse_assembly(kDocument, "d.json"));
  result.document_sha256 = sha256(kDocument);
  return result;
}

std::string refused(const Certificate& certificate) {
  try {
    require_about(certificate, kDocument, "d.json");
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    return error.what();
  }
}

TEST(CertificateJsonAbout, is_the_document_that_it_was_made_from) {
  Certificate c = certificate();
  EXPECT_EQ(refused(c), "");
  c.tolerance = 0.01;  // more than was asked for
  EXPECT_EQ(refused(c), "");
}

TEST(CertificateJsonAbout, is_no_other_whatever_the_digest_says) {
  using testing::HasSubstr;
  Certificate c = certificate();
  c.document_sha256 = sha256("another");
  EXPECT_THAT(refused(c), HasSubstr("digest"));
  c = certificate();
  c.unit = Unit::metre;
  EXPECT_THAT(refused(c), HasSubstr("unit"));
  c = certificate();
  c.tolerance = 0.11;
  EXPECT_THAT(refused(c), HasSubstr("tolerance"));
  c = certificate();
  c.parts.pop_back();
  EXPECT_THAT(refused(c), HasSubstr("as many parts"));
  c = certificate();
  c.parts[1].joined[0].reset();
  EXPECT_THAT(refused(c), HasSubstr("'b'"));
  c = certificate();
  c.parts[0].kind = "cone";
  EXPECT_THAT(refused(c), HasSubstr("'a'"));
  c = certificate();
  auto& pipe = std::get<RingedSurface>(std::get<Chain>(c.parts[0].shape).pieces[0]);
  pipe.start.center.y() = -0.0;  // one bit
  EXPECT_THAT(refused(c), HasSubstr("'a'"));
}

TEST(CertificateJsonAbout, has_the_fillets_of_its_document) {
  const std::string document = R"({"units": "mm", "tolerance": 0.1, "parts": [
    {"name": "run", "pipe": {"from": [-9, 0, 0], "to": [9, 0, 0], "radius": 2}},
    {"name": "branch", "pipe": {"from": [0, 0, 0], "to": [0, 9, 0], "radius": 1}},
    {"name": "throat", "fillet": {"between": ["run", "branch"], "radius": 0.3}}]})";
  Certificate honest = certify(parse_assembly(document, "d.json"));
  honest.document_sha256 = sha256(document);
  ASSERT_NO_THROW(require_about(honest, document, "d.json"));
  const std::vector<std::function<void(CertifiedFillet&)>> changes{
      [](CertifiedFillet& f) { f.name = "another"; },
      [](CertifiedFillet& f) { std::swap(f.between[0], f.between[1]); },
      [](CertifiedFillet& f) { f.buried[0][0] = !f.buried[0][0]; },
      [](CertifiedFillet& f) { f.loops.pop_back(); },
      [](CertifiedFillet& f) {
        double& radius = std::get<RollingThrough>(f.loops[0].motion).radius;
        radius = std::nextafter(radius, 9);
      }};
  for (const auto& change : changes) {
    Certificate c = honest;
    change(c.fillets[0]);
    EXPECT_THROW(require_about(c, document, "d.json"), Error);
  }
  honest.fillets.clear();
  EXPECT_THROW(require_about(honest, document, "d.json"), Error);
}

TEST(CertificateJsonAbout, has_the_junctions_of_its_document) {
  const std::string document = R"({"units": "mm", "tolerance": 0.1, "parts": [
    {"name": "a", "pipe": {"from": [-9, 0, 0], "to": [-5, 0, 0], "radius": 1}},
    {"name": "b", "pipe": {"from": [9, 0, 0], "to": [5, 0, 0], "radius": 1}},
    {"name": "c", "pipe": {"from": [0, 9, 0], "to": [0, 5, 0], "radius": 1}},
    {"name": "hub", "junction": {"ends": ["a.end", "b.end", "c.end"]}}]})";
  Certificate honest = certify(parse_assembly(document, "d.json"));
  honest.document_sha256 = sha256(document);
  ASSERT_NO_THROW(require_about(honest, document, "d.json"));
  ASSERT_NO_THROW(require_about(honest, document, parse_assembly(document, "d.json")));
  Certificate c = honest;
  std::swap(c.junctions[0].arms[0], c.junctions[0].arms[1]);
  EXPECT_THROW(require_about(c, document, "d.json"), Error);
  c = honest;
  c.junctions.clear();
  EXPECT_THROW(require_about(c, document, "d.json"), Error);
}

}  // namespace
}  // namespace dupin
