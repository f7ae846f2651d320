#include <string>

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

}  // namespace
}  // namespace dupin
