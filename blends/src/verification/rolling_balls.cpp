#include "verification/rolling_balls.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

namespace dupin::verification {
namespace {

// Cosine and sine of the angle whose tangent is x / (1 - x), and of its double less pi/2.
struct Place {
  explicit Place(double x) {
    const Interval rest = Interval(1) - x;
    const Interval length = sqrt(square(rest) + square(Interval(x)));
    cosine = rest / length;
    sine = Interval(x) / length;
  }
  [[nodiscard]] Interval double_sine() const { return Interval(2) * sine * cosine; }
  [[nodiscard]] Interval minus_double_cosine() const { return square(sine) - square(cosine); }

  Interval cosine, sine;
};

}  // namespace

std::optional<TurnStretch> turn_stretch(const ParameterInterval& t) {
  const double half = t.from < 1 ? 0 : 1;
  const double from = t.from - half, to = t.to - half;  // exact
  if (!(from >= 0 && from <= to && to <= 1 && half <= 1)) {
    return std::nullopt;
  }
  const Place first(from), last(to);
  const Interval falling{last.cosine.lower, first.cosine.upper};  // cosine and sine of the rest
  const Interval rising{first.sine.lower, last.sine.upper};
  Interval cosine = hull(first.double_sine(), last.double_sine());
  if (from <= 0.5 && to >= 0.5) {
    cosine = hull(cosine, 1);
  }
  const Interval sine = hull(first.minus_double_cosine(), last.minus_double_cosine());
  const double nearest = std::clamp(0.5, from, to);
  const Interval squared = square(Interval(1) - nearest) + square(Interval(nearest));
  const double length = (Interval(2) * (Interval(to) - from) / squared).upper;
  if (half == 0) {
    return TurnStretch{cosine, sine, falling, rising, 1, length};
  }
  return TurnStretch{-cosine, -sine, -rising, falling, -1, length};
}

std::optional<double> turn_reach(const ParameterInterval& t) {
  const double middle = std::midpoint(t.from, t.to);
  const auto before = turn_stretch({t.from, middle}), after = turn_stretch({middle, t.to});
  return before && after ? std::optional(std::max(before->length, after->length)) : std::nullopt;
}

bool rolls_on_cones(const CanalFillet& loop) {
  return std::holds_alternative<RollingOnCones>(loop.motion) ||
         std::holds_alternative<RollingPartlyOnCones>(loop.motion);
}

}  // namespace dupin::verification
