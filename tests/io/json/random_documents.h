#pragma once

#include <cstdint>

namespace dupin::test {

/// Certifies so many random documents of a few parts each, near misses among them, and verifies
/// what was written; fails for each that is refused, or takes 10 s.
void expect_all_verified(std::uint64_t seed, int count);

}  // namespace dupin::test
