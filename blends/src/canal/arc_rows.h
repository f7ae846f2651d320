#pragma once

#include <array>

#include "canal/series.h"
#include "dupin/blends/canal_fillet.h"

namespace dupin::canal {

constexpr std::size_t kArcOrders = 5;
using ArcSeries = Series<kArcOrders>;

/// The arcs of a loop as rational curves of degree 2, as functions of the loop's parameter:
/// homogeneous control points, the first and the last of weight 1 and at the arc's ends.
struct ArcRows {
  std::array<std::array<ArcSeries, 3>, 3> points;  ///< times their weights
  ArcSeries weight;                                ///< of the middle one: cos of half the angle
};

/// Taylor coefficients at all parameters of `at`, which lies in `stretch`; that has corners at its
/// ends at most, and what is told of a corner is what holds on its side of it. Where the balls have
/// no arcs, or the numbers do not tell, they are not finite.
[[nodiscard]] ArcRows arc_rows(const CanalFillet& loop, const ParameterInterval& at,
                               const ParameterInterval& stretch);

}  // namespace dupin::canal
