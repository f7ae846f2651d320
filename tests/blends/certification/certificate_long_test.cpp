#include <cstdlib>

#include "blends/random_blends.h"

namespace dupin {
namespace {

// All thousand take some 150 s:
//   DUPIN_RANDOM_BLENDS=1000 build/dev/tests/blends/blends_certificate_long_test
TEST(Certificate, never_claims_embedded_what_meets_itself_in_hundreds_of_blends) {
  const char* count = std::getenv("DUPIN_RANDOM_BLENDS");
  test::compare_prover_and_mesh(2026, count != nullptr ? std::atoi(count) : 200);
}

}  // namespace
}  // namespace dupin
