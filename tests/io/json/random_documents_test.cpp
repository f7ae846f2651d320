#include "io/json/random_documents.h"

#include <gtest/gtest.h>

namespace dupin {
namespace {

TEST(RandomDocuments, are_certified_as_the_checker_agrees) { test::expect_all_verified(7, 100); }

}  // namespace
}  // namespace dupin
