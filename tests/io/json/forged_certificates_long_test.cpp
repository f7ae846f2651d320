#include <gtest/gtest.h>

#include "io/json/forged_certificates.h"
#include "io/json/random_documents.h"

namespace dupin {
namespace {

/// By seed.
struct ForgedCertificatesLong : testing::TestWithParam<int> {};
struct RandomDocumentsLong : testing::TestWithParam<int> {};

TEST_P(ForgedCertificatesLong, are_not_believed) { test::expect_none_believed(GetParam(), 200); }

TEST_P(RandomDocumentsLong, are_certified_as_the_checker_agrees) {
  test::expect_all_verified(GetParam(), 400);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ForgedCertificatesLong, testing::Range(2026, 2031));
INSTANTIATE_TEST_SUITE_P(Seeds, RandomDocumentsLong, testing::Range(2026, 2031));

}  // namespace
}  // namespace dupin
