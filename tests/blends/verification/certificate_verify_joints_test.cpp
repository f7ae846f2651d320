// That the rings of pieces are where the pieces end, whatever tolerance a certificate states.
#include <gmock/gmock.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

// A ring is off by less than the other end's is wide, and by more than its own.
TEST(VerifyCertificate, of_pieces_is_about_each_ring_at_its_own_end) {
  for (const bool narrows : {false, true}) {
    const Vec3 wide(0, 0, 0), narrow(9, 0, 0);
    const ConeBetween cone =
        narrows ? ConeBetween{wide, narrow, 2, .5} : ConeBetween{narrow, wide, .5, 2};
    Certificate c = certify({"d.json", Unit::millimetre, 0.5, {}, {{"cone", cone}}});
    c.tolerance = 1e3;
    EXPECT_NO_THROW(verify(c));
    const std::size_t at = narrows ? 1 : 0;
    c.claims[0].tangency[1 - at].offset = 1;
    EXPECT_NO_THROW(verify(c)) << narrows;
    c.claims[0].tangency[at].offset = 1;
    try {
      verify(c);
      ADD_FAILURE() << narrows;
    } catch (const Error& error) {
      EXPECT_THAT(error.message(), testing::HasSubstr("'joints'")) << narrows;
    }
  }
}

}  // namespace
}  // namespace dupin
