#include "io/json/forged_certificates.h"

#include <gtest/gtest.h>

namespace dupin {
namespace {

TEST(ForgedCertificates, are_forged_in_many_ways) { EXPECT_GE(test::forgeries().size(), 20U); }

TEST(ForgedCertificates, are_not_believed) { test::expect_none_believed(15, 300); }

}  // namespace
}  // namespace dupin
