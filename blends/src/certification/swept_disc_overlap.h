#pragma once

#include <optional>
#include <vector>

#include "certification/swept_discs.h"

namespace dupin::certification {

/// Whoever checks a claim rounds in his own way: nothing is claimed that hangs on a smaller share.
constexpr double kDiscSlack = 0x1p-40;

/// A point inside discs at two places of the same part, if one is found.
[[nodiscard]] std::optional<Overlap> self_overlap(const SweptDiscs& sweep);

/// The point of both between their axes, if it is one: that of most pipes that cross, at the cost
/// of some discs of each.
[[nodiscard]] std::optional<Overlap> overlap_between_axes(const SweptDiscs& first,
                                                          const SweptDiscs& second);

/// A point inside discs of both parts, if one is found. That between the axes is not asked again.
[[nodiscard]] std::optional<Overlap> overlap(const SweptDiscs& first, const SweptDiscs& second);

/// A point of something else, at a parameter of that.
struct PlacedPoint {
  Vec3 point;
  double parameter = 0;
};

/// One of the points that is inside discs of the part, if there is one.
[[nodiscard]] std::optional<Overlap> overlap(const SweptDiscs& part,
                                             const std::vector<PlacedPoint>& points);

/// The centre of an end ring of either part that lies in an end ring of the other, exactly.
[[nodiscard]] std::optional<Overlap> contact(const SweptDiscs& first, const SweptDiscs& second);

}  // namespace dupin::certification
