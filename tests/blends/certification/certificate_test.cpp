#include "blends/random_blends.h"

namespace dupin {
namespace {

TEST(Certificate, never_claims_embedded_what_meets_itself) { test::compare_prover_and_mesh(1, 40); }

}  // namespace
}  // namespace dupin
