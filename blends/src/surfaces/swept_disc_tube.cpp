#include "surfaces/swept_disc_tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "curves/exact_radius.h"
#include "dupin/kernel/error.h"
#include "numbers/bezier.h"
#include "numbers/cosine_and_sine.h"
#include "numbers/mpfi_interval.h"
#include "numbers/polynomial.h"
#include "ringed/second_derivatives.h"

namespace dupin::surfaces {
namespace {

using Mpfi = numbers::MpfiInterval<128>;

// Of a checker: what is said to be proved is so with a little more room than that takes.
constexpr double kRounding = 0x1p-40;

// Arcs turn by less than a half turn per rational quadratic; more is put together.
constexpr double kLargestHalfTurn = 1.5;

double angle_between(const numbers::IntervalVec& a, const numbers::IntervalVec& b) {
  const numbers::Interval y = numbers::norm(numbers::cross(a, b)), x = numbers::dot(a, b);
  return angle(Mpfi::between(y.lower, y.upper), Mpfi::between(x.lower, x.upper))
      .rounded_outward()
      .upper;
}

std::vector<numbers::IntervalVec> differences(const std::vector<numbers::IntervalVec>& points) {
  std::vector<numbers::IntervalVec> result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    result.push_back(points[i + 1] - points[i]);
  }
  return result;
}

struct Controls {
  std::vector<numbers::IntervalVec> points;
  std::vector<numbers::Interval> weights;
};

Controls controls(const LineSpine& line) {
  return {{numbers::interval_vec(line.from), numbers::interval_vec(line.to)}, {}};
}

Controls controls(const HermiteSpine& h) {
  const numbers::Interval third = numbers::Interval(1) / 3;
  const numbers::IntervalVec from = numbers::interval_vec(h.from), to = numbers::interval_vec(h.to);
  return {{from, from + third * numbers::interval_vec(h.start_velocity),
           to - third * numbers::interval_vec(h.end_velocity), to},
          {}};
}

Controls controls(const BezierSpine& bezier) {
  Controls result;
  for (std::size_t i = 0; i < bezier.points.size(); ++i) {
    const numbers::Interval weight = bezier.weights.empty() ? 1 : bezier.weights[i];
    result.points.push_back(weight * numbers::interval_vec(bezier.points[i]));
  }
  result.weights = {bezier.weights.begin(), bezier.weights.end()};
  return result;
}

// The Bernstein coefficients of p' w - p w' up to a factor, where the curve is p / w.
std::vector<numbers::IntervalVec> rational_tangents(const std::vector<numbers::IntervalVec>& p,
                                                    const std::vector<numbers::Interval>& w) {
  const std::size_t n = p.size() - 1;
  std::vector<numbers::IntervalVec> result(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      const numbers::Interval share =
          numbers::Interval(numbers::binomial(n - 1, i).get_d() * numbers::binomial(n, j).get_d()) /
          numbers::binomial(2 * n - 1, i + j).get_d();
      result[i + j] = result[i + j] + share * (w[j] * (p[i + 1] - p[i]) - (w[i + 1] - w[i]) * p[j]);
    }
  }
  return result;
}

struct ArcPart {
  std::vector<numbers::IntervalVec> centers, tangents;
};

// The affine image of a circle's arc: between its ends, inside the triangle with the point where
// the end tangents meet.
ArcPart arc_part(const ArcSpine& arc, const ParameterInterval& t) {
  if (arc.angle * (t.to - t.from) > 2 * kLargestHalfTurn) {
    const double middle = (t.from + t.to) / 2;
    ArcPart result = arc_part(arc, {t.from, middle});
    const ArcPart rest = arc_part(arc, {middle, t.to});
    result.centers.insert(result.centers.end(), rest.centers.begin(), rest.centers.end());
    result.tangents.insert(result.tangents.end(), rest.tangents.begin(), rest.tangents.end());
    return result;
  }
  const numbers::IntervalVec u =
      numbers::interval_vec(arc.start) - numbers::interval_vec(arc.center);
  const numbers::IntervalVec v = numbers::cross(numbers::interval_vec(arc.axis), u);
  const numbers::Interval from = numbers::Interval(arc.angle) * t.from,
                          to = numbers::Interval(arc.angle) * t.to, half = 0.5;
  using Turn = numbers::CosineAndSine;
  const Turn first = numbers::cosine_and_sine(from),
             middle = numbers::cosine_and_sine(half * (from + to)),
             last = numbers::cosine_and_sine(to);
  const auto spoke = [&](const Turn& turn) { return turn.cosine * u + turn.sine * v; };
  const auto direction = [&](const Turn& turn) { return turn.cosine * v - turn.sine * u; };
  const numbers::IntervalVec center = numbers::interval_vec(arc.center);
  const numbers::Interval stretch =
      numbers::Interval(1) / numbers::cosine_and_sine(half * (to - from)).cosine;
  return {{center + spoke(first), center + stretch * spoke(middle), center + spoke(last)},
          {direction(first), direction(last)}};
}

// Positive and negative for a radius that grows or falls along the way; 0 for a constant one; none
// for others.
std::optional<double> trend(const RadiusLaw& law) {
  if (const auto* bezier = std::get_if<BezierRadius>(&law)) {
    const auto& c = bezier->coefficients;
    if (!std::is_sorted(c.begin(), c.end()) && !std::is_sorted(c.rbegin(), c.rend())) {
      return std::nullopt;
    }
  }
  return evaluate(law, 1).value - evaluate(law, 0).value;
}

std::vector<numbers::Interval> coefficients(const RadiusLaw& law) {
  if (const auto* linear = std::get_if<LinearRadius>(&law)) {
    return {linear->start, linear->end};
  }
  if (const auto* cubic = std::get_if<CubicRadius>(&law)) {
    return {cubic->start, cubic->start, cubic->end, cubic->end};
  }
  if (const auto* bezier = std::get_if<BezierRadius>(&law)) {
    return {bezier->coefficients.begin(), bezier->coefficients.end()};
  }
  return {std::get<ConstantRadius>(law).radius};
}

numbers::Interval range(const RadiusLaw& law, const ParameterInterval& t) {
  const auto* cyclide = std::get_if<CyclideRadius>(&law);
  return cyclide != nullptr ? numbers::hull(curves::enclosed_radius(*cyclide, t.from),
                                            curves::enclosed_radius(*cyclide, t.to))
                            : numbers::bezier_range(coefficients(law), {t.from, t.to});
}

}  // namespace

SweptDiscTube::SweptDiscTube(const RingedSurface& surface)
    : spine_(surface.spine), radii_{surface.radius} {}

SweptDiscTube::SweptDiscTube(const EllipticTube& tube)
    : spine_(tube.spine), radii_{tube.first, tube.second} {}

SweptDiscTube::Part SweptDiscTube::curve(const ParameterInterval& t) const {
  if (const auto* arc = std::get_if<ArcSpine>(&spine_)) {
    ArcPart part = arc_part(*arc, t);
    return {std::move(part.centers), std::move(part.tangents)};
  }
  struct Visitor {
    Controls operator()(const LineSpine& s) const { return controls(s); }
    Controls operator()(const HermiteSpine& s) const { return controls(s); }
    Controls operator()(const BezierSpine& s) const { return controls(s); }
    Controls operator()(const ArcSpine&) const { return {}; }
  };
  const Controls whole = std::visit(Visitor{}, spine_);
  const numbers::Interval stretch(t.from, t.to);
  Part part{numbers::bezier_part(whole.points, stretch), {}};
  if (whole.weights.empty()) {
    part.tangents = numbers::bezier_part(differences(whole.points), stretch);
    return part;
  }
  part.tangents = numbers::bezier_part(rational_tangents(whole.points, whole.weights), stretch);
  const auto weights = numbers::bezier_part(whole.weights, stretch);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    part.centers[i] = numbers::Interval(1) / weights[i] * part.centers[i];
  }
  return part;
}

numbers::Interval SweptDiscTube::radius(const ParameterInterval& t) const {
  numbers::Interval result = range(radii_.front(), t);
  for (const RadiusLaw& law : radii_) {
    result = max(result, range(law, t));
  }
  return result;
}

// The direction of a Bezier polynomial turns by no more than that of its control polygon.
double SweptDiscTube::turning(const ParameterInterval& t) const {
  const std::vector<numbers::IntervalVec> tangents = curve(t).tangents;
  numbers::Interval sum = 0;
  for (std::size_t i = 0; i + 1 < tangents.size(); ++i) {
    sum = sum + angle_between(tangents[i], tangents[i + 1]);
  }
  return sum.upper;
}

struct SweptDiscTube::ArcRoom {
  double angle;  ///< by which the whole arc turns
  double least;  ///< how far the discs stay from the axis, by its distance
};

std::optional<SweptDiscTube::ArcRoom> SweptDiscTube::room_on_arc(const ParameterInterval& t) const {
  const auto* arc = std::get_if<ArcSpine>(&spine_);
  if (arc == nullptr) {
    return std::nullopt;
  }
  const double distance = (arc->start - arc->center).norm();
  const double least = 1 - radius(t).magnitude() / distance - kRounding;
  return least > 0 ? std::optional(ArcRoom{arc->angle, least}) : std::nullopt;
}

bool SweptDiscTube::stays_on_one_side(const ParameterInterval& t) const {
  if (const auto* line = std::get_if<LineSpine>(&spine_)) {
    return line->from != line->to;
  }
  const auto room = room_on_arc(t);
  const double half = room ? room->angle * (t.to - t.from) / 2 : 0;
  return room && half < std::numbers::pi / 2 && std::cos(half) * room->least > kRounding;
}

bool SweptDiscTube::turns_little(const ParameterInterval& t, double margin) const {
  constexpr double kSlack = 1 - kRounding;
  if (const auto room = room_on_arc(t); room && room->angle < 2 * std::numbers::pi * kSlack) {
    return true;
  }
  const numbers::Interval all = radius(t);
  if (!(turning(t) <= std::numbers::pi / 2 * kSlack) || !(all.lower > 0)) {
    return false;
  }
  bool monotone = true, grows = true, falls = true;
  for (const RadiusLaw& law : radii_) {
    const auto own = trend(law);
    monotone = monotone && own.has_value();
    grows = grows && own.value_or(0) >= 0;
    falls = falls && own.value_or(0) <= 0;
  }
  return (monotone && (grows || falls)) ||
         ((numbers::Interval(1) - margin) * all.upper).upper <= all.lower * kSlack;
}

std::optional<DiscPace> SweptDiscTube::pace(const ParameterInterval& t) const {
  try {
    const ringed::SpineBounds bounds = ringed::spine_bounds(spine_, {t.from, t.to});
    return DiscPace{bounds.speed.lower, 0, bounds.turning, radius(t),
                    (numbers::Interval(t.to) - t.from).upper};
  } catch (const Error&) {
    return std::nullopt;  // the spine may stop there
  }
}

}  // namespace dupin::surfaces
