#include <gtest/gtest.h>

#include "io/json/forged_certificates.h"
#include "io/json/random_documents.h"

namespace dupin {
namespace {

TEST(ForgedCertificates, are_not_believed_by_the_thousand) {
  test::expect_none_believed(2026, 5000);
}

TEST(RandomDocuments, are_certified_as_the_checker_agrees_by_the_thousand) {
  test::expect_all_verified(2026, 2000);
}

}  // namespace
}  // namespace dupin
