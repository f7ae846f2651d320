#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pages/page_sections.h"

namespace dupin::pages {
namespace {

Certificate of_two_parts() {
  Certificate certificate;
  certificate.parts = {{"a", "pipe", Chain(), {}}, {"b", "pipe", Chain(), {}}};
  PartClaims good;
  good.regular = RegularClaim{Verdict::proved, 0.5, {}, {}};
  good.embedded = EmbeddedClaim{Verdict::proved, {}, {}};
  good.mesh = MeshClaim{8, 0, {}, 0.01};
  PartClaims bad = good;
  bad.embedded = EmbeddedClaim{Verdict::refuted, {}, Overlap{{1, 2, 3}, {}, {}}};
  bad.mesh.reset();
  certificate.claims = {good, bad};
  return certificate;
}

TEST(CertificateSection, has_what_is_not_proved_first_and_where_it_fails) {
  const PageSection section = certificate_section(of_two_parts());
  ASSERT_EQ(section.rows.size(), 6);
  EXPECT_EQ(section.rows[0].cells,
            (std::vector<std::string>{"refuted", "embedded", "b", "it crosses itself"}));
  EXPECT_EQ(section.rows[0].place->at, Vec3(1, 2, 3));
  EXPECT_EQ(section.rows[1].cells[0], "undecided");
  EXPECT_EQ(section.rows[1].cells[1], "mesh error");
  EXPECT_EQ(section.rows[2].cells[3], "above 0.5");
  EXPECT_THAT(section.note, testing::HasSubstr("embedded: 1 proved, 1 refuted, 0 undecided"));
}

TEST(CertificateSection, says_of_which_fillets_it_is_proved_that_they_touch) {
  Certificate certificate = of_two_parts();
  certificate.fillets = {{"near", {0, 1}, {}, {}}, {"unknown", {0, 1}, {}, {}}};
  LoopClaims near;
  near.contact = ContactClaim{0.001, 0.002};
  certificate.fillet_claims = {{near}, {LoopClaims()}};
  const PageSection section = certificate_section(certificate);
  EXPECT_THAT(section.note, testing::HasSubstr("tangent: 1 proved, 0 refuted, 1 undecided"));
  for (const PageRow& row : section.rows) {
    if (row.cells[1] == "tangent") {
      const bool is_near = row.cells[2] == "near";
      EXPECT_EQ(row.cells[0], is_near ? "proved" : "undecided");
      EXPECT_EQ(row.cells[3], is_near ? "within 0.002 rad" : "");
    }
  }
}

TEST(CertificateSection, leaves_out_pairs_that_are_far_apart) {
  Certificate certificate = of_two_parts();
  for (int i = 300; i > 0; --i) {
    certificate.clearances.push_back({0, 1, Verdict::proved, double(i), {}, {}});
  }
  const PageSection section = certificate_section(certificate);
  EXPECT_EQ(section.rows.size(), 106);
  EXPECT_EQ(section.rows.back().cells[3], "at least 100 mm");
  EXPECT_THAT(section.note, testing::HasSubstr("200 pairs further apart"));
  EXPECT_THAT(section.note, testing::HasSubstr("clearance: 300 proved"));
}

}  // namespace
}  // namespace dupin::pages
