#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "certification/swept_discs.h"
#include "dupin/blends/certificate.h"

namespace dupin::certification {

/// Of ways between discs that are looked at: on longer ones some piece turns too much.
constexpr double kLongestWay = 2;

/// A lower bound of the distance of two sets of discs, all of `first` being behind and all of
/// `second` in front of a slab of that width across `direction`; not positive if none was found.
struct Separation {
  Vec3 direction = Vec3::UnitX();
  double distance = 0;
  double nearest = 0;  ///< roughly the distance of the two convex hulls, from above
};

[[nodiscard]] Separation separation(const DiscHull& first, const DiscHull& second);

/// Proves or refutes that the discs at any two parameters are disjoint, given that they are locally
/// with this margin.
[[nodiscard]] EmbeddedClaim prove_embedded(const SweptDiscs& sweep, double margin,
                                           std::size_t boxes, double longest_way = kLongestWay);

/// The ends at which two parts are joined.
struct JoinedEnds {
  End first, second;
};

/// Proves or refutes that two parts that are joined have nothing in common but the discs of the
/// joints.
[[nodiscard]] ClearanceClaim prove_joint(const SweptDiscs& first, const SweptDiscs& second,
                                         const std::vector<JoinedEnds>& joints, std::size_t boxes);

/// Finds a lower bound of the distance of two sets of discs, or a point in both. The bound is nine
/// tenths of the distance where that takes no more than `tight` boxes, six with twice as many, then
/// three.
[[nodiscard]] ClearanceClaim prove_clearance(
    const SweptDiscs& first, const SweptDiscs& second, std::size_t boxes,
    std::size_t tight = std::numeric_limits<std::size_t>::max() / 2);

}  // namespace dupin::certification
