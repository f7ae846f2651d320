#pragma once

#include <gtest/gtest.h>

#include "verification/claims/mesh_claim.h"

namespace dupin::verification {

/// The least error bound that follows, of those below `high`, to a share of it.
inline double least_bound(const Solid& solid, MeshClaim about, double high, double share) {
  double low = 0;
  about.error_bound = high;
  EXPECT_TRUE(follows(solid, about));
  while (high - low > share * high) {
    about.error_bound = (low + high) / 2;
    (follows(solid, about) ? high : low) = about.error_bound;
  }
  return high;
}

}  // namespace dupin::verification
