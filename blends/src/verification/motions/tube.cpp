#include "verification/motions/tube.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dupin/kernel/enclosure.h"
#include "dupin/kernel/error.h"
#include "verification/motions/jet.h"

namespace dupin::verification {
namespace {

IntervalVec coefficient(const Curve& curve, std::size_t i) {
  return {enclosed(curve[0][i]), enclosed(curve[1][i]), enclosed(curve[2][i])};
}

Interval cyclide_radius(const CyclideRadius& law, double t) {
  const Mpfi start = law.start, end = law.end;
  const Mpfi c = (end - start) * cosine(Mpfi::pi() * t);
  return narrowed((square_root(square(c) + 4 * start * end) - c) / 2);
}

// Between its ends, an arc lies inside the triangle with the point where the end tangents meet.
Discs arc_discs(const ArcSpine& arc, double from, double to) {
  constexpr double kLargestTurn = 3;
  if (arc.angle * (to - from) > kLargestTurn) {
    Discs all = arc_discs(arc, from, (from + to) / 2);
    const Discs rest = arc_discs(arc, (from + to) / 2, to);
    all.centers.insert(all.centers.end(), rest.centers.begin(), rest.centers.end());
    all.tangents.insert(all.tangents.end(), rest.tangents.begin(), rest.tangents.end());
    return all;
  }
  const IntervalVec center = numbers::interval_vec(arc.center);
  const IntervalVec u = numbers::interval_vec(arc.start) - center;
  const IntervalVec v = numbers::cross(numbers::interval_vec(arc.axis), u);
  const auto direction = [&](const Mpfi& turned) {
    return narrowed(cosine(turned)) * v - narrowed(sine(turned)) * u;
  };
  const auto spoke = [&](const Mpfi& turned) {
    return narrowed(cosine(turned)) * u + narrowed(sine(turned)) * v;
  };
  const Mpfi first = Mpfi(arc.angle) * from, last = Mpfi(arc.angle) * to;
  const Interval stretch = Interval(1) / narrowed(cosine((last - first) / 2));
  return {
      {center + spoke(first), center + stretch * spoke((first + last) / 2), center + spoke(last)},
      {direction(first), direction(last)},
      {},
      0};
}

}  // namespace

Interval enclosed(const mpq_class& value) {
  const Enclosure e = enclosure_of(value);
  return {e.lower, e.upper};
}

Tube::Tube(const RingedSurface& surface) : surface_(surface), weight_{1} {
  std::vector<Vec3> points;
  const auto* bezier = std::get_if<BezierSpine>(&surface.spine);
  const auto* hermite = std::get_if<HermiteSpine>(&surface.spine);
  if (const auto* line = std::get_if<LineSpine>(&surface.spine)) {
    points = {line->from, line->to};
  } else if (hermite != nullptr) {
    points = {hermite->from, hermite->from, hermite->to, hermite->to};
  } else if (bezier != nullptr) {
    points = bezier->points;
    if (!bezier->weights.empty()) {
      weight_ = {bezier->weights.begin(), bezier->weights.end()};
    }
  }
  if (arc() == nullptr &&
      (points.size() < 2 ||
       (bezier != nullptr && !bezier->weights.empty() && weight_.size() != points.size()) ||
       std::any_of(weight_.begin(), weight_.end(), [](const auto& w) { return w <= 0; }))) {
    throw Error(Errc::invalid_argument, "the spine's points and weights make no curve");
  }
  for (int k = 0; k < 3; ++k) {
    Polynomial& p = points_[k];
    for (std::size_t i = 0; i < points.size(); ++i) {
      p.emplace_back(mpq_class(points[i][k]) * weight_[weight_.size() == 1 ? 0 : i]);
    }
    if (hermite != nullptr) {
      p[1] += mpq_class(hermite->start_velocity[k]) / 3;
      p[2] -= mpq_class(hermite->end_velocity[k]) / 3;
    }
  }
  if (const auto* constant = std::get_if<ConstantRadius>(&surface.radius)) {
    radius_ = {constant->radius};
  } else if (const auto* linear = std::get_if<LinearRadius>(&surface.radius)) {
    radius_ = {linear->start, linear->end};
  } else if (const auto* cubic = std::get_if<CubicRadius>(&surface.radius)) {
    radius_ = {cubic->start, cubic->start, cubic->end, cubic->end};
  } else if (const auto* law = std::get_if<BezierRadius>(&surface.radius)) {
    radius_ = {law->coefficients.begin(), law->coefficients.end()};
  }
  if (radius_.empty() && !std::holds_alternative<CyclideRadius>(surface.radius)) {
    throw Error(Errc::invalid_argument, "a radius needs coefficients");
  }
}

bool Tube::is_cone() const {
  return std::holds_alternative<LineSpine>(surface_.spine) &&
         (std::holds_alternative<ConstantRadius>(surface_.radius) ||
          std::holds_alternative<LinearRadius>(surface_.radius));
}

Stretch Tube::stretch(double from, double to) const {
  Stretch result;
  result.weight = part(weight_, from, to);
  for (std::size_t k = 0; k < 3; ++k) {
    Polynomial& p = result.points[k] = part(points_[k], from, to);
    result.tangent[k] = weight_.size() == 1 ? derivative(p)
                                            : difference(product(derivative(p), result.weight),
                                                         product(p, derivative(result.weight)));
  }
  return result;
}

Polynomial Tube::radius(double from, double to) const {
  return radius_.empty() ? radius_ : part(radius_, from, to);
}

double Tube::radius_at(End end) const {
  if (const auto* law = std::get_if<CyclideRadius>(&surface_.radius)) {
    return end == End::end ? law->end : law->start;
  }
  return (end == End::end ? radius_.back() : radius_.front()).get_d();
}

Interval Tube::radius_range(double from, double to) const {
  if (const auto* law = std::get_if<CyclideRadius>(&surface_.radius)) {
    return numbers::hull(cyclide_radius(*law, from), cyclide_radius(*law, to));  // it is monotone
  }
  const Polynomial r = radius(from, to);
  const auto [least, most] = std::minmax_element(r.begin(), r.end());
  return numbers::hull(enclosed(*least), enclosed(*most));
}

Discs Tube::discs(double from, double to) const {
  spend(4);
  if (from == to) {  // stretches have their ends' tangents
    const bool at_end = from == 1;
    const Discs around = at_end ? discs(0, 1) : discs(from, 1);
    return {{at_end ? around.centers.back() : around.centers.front()},
            {at_end ? around.tangents.back() : around.tangents.front()},
            radius_range(from, from),
            0};
  }
  Discs result;
  if (arc() != nullptr) {
    result = arc_discs(*arc(), from, to);
  } else {
    const Stretch s = stretch(from, to);
    for (std::size_t i = 0; i < s.points[0].size(); ++i) {
      const Interval weight = enclosed(s.weight[s.weight.size() == 1 ? 0 : i]);
      result.centers.push_back(Interval(1) / weight * coefficient(s.points, i));
    }
    for (std::size_t i = 0; i < s.tangent[0].size(); ++i) {
      result.tangents.push_back(coefficient(s.tangent, i));
    }
  }
  result.radius = radius_range(from, to);
  return result;
}

// A disc of normal T reaches R |T x w| from its centre. Where all tangents are on one side of the
// plane across w, so is their cone, and its largest angle to w is that of one of them.
double furthest(const Discs& discs, const IntervalVec& w) {
  spend(1);
  const Interval length = numbers::norm(w);
  double sine = 0;
  bool with = !discs.tangents.empty(), against = with;
  for (const IntervalVec& tangent : discs.tangents) {
    const Interval cosine = numbers::dot(tangent, w), scale = numbers::norm(tangent) * length;
    with = with && cosine.lower > 0;
    against = against && cosine.upper < 0;
    sine = scale.lower > 0
               ? std::max(sine, (numbers::norm(numbers::cross(tangent, w)) / scale).upper)
               : 1;
  }
  // Whatever the radius law says: a disc of negative radius would reach less far than its centre.
  const Interval reach =
      Interval(discs.radius.magnitude()) * length *
      (with || against ? std::min((Interval(sine) + discs.spread).upper, 1.0) : 1);
  double result = -std::numeric_limits<double>::infinity();
  for (const IntervalVec& center : discs.centers) {
    result = std::max(result, (numbers::dot(center, w) + reach).upper);
  }
  return result;
}

double turning(const std::vector<IntervalVec>& tangents) {
  Interval sum = 0;
  for (std::size_t i = 0; i + 1 < tangents.size(); ++i) {
    const Interval y = numbers::norm(numbers::cross(tangents[i], tangents[i + 1]));
    const Interval x = numbers::dot(tangents[i], tangents[i + 1]);
    sum = sum + narrowed(angle(Mpfi::between(y.lower, y.upper), Mpfi::between(x.lower, x.upper)));
  }
  return sum.upper;
}

}  // namespace dupin::verification
