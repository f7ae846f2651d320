#include "blends/random_blends.h"

namespace dupin {
namespace {

TEST(Certificate, never_claims_embedded_what_meets_itself_in_a_thousand_blends) {
  test::compare_prover_and_mesh(2026, 1000);
}

}  // namespace
}  // namespace dupin
