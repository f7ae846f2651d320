#include "disc_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "exact_radius.h"
#include "interval_bezier.h"
#include "mpfi_interval.h"
#include "polynomial.h"

namespace dupin::detail {
namespace {

using Mpfi = MpfiInterval<128>;

// Arcs turn by less than a half turn per rational quadratic; more is put together.
constexpr double kLargestHalfTurn = 1.5;

Vec3 center(const IntervalVec& v) {
  return {(v[0].lower + v[0].upper) / 2, (v[1].lower + v[1].upper) / 2,
          (v[2].lower + v[2].upper) / 2};
}

Interval narrowed(const Mpfi& x) {
  const Enclosure e = x.rounded_outward();
  return {e.lower, e.upper};
}

double angle_between(const IntervalVec& a, const IntervalVec& b) {
  const Interval y = norm(cross(a, b)), x = dot(a, b);
  return angle(Mpfi::between(y.lower, y.upper), Mpfi::between(x.lower, x.upper))
      .rounded_outward()
      .upper;
}

std::vector<IntervalVec> differences(const std::vector<IntervalVec>& points) {
  std::vector<IntervalVec> result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    result.push_back(points[i + 1] - points[i]);
  }
  return result;
}

struct Controls {
  std::vector<IntervalVec> points;
  std::vector<Interval> weights;
};

Controls controls(const LineSpine& line) {
  return {{interval_vec(line.from), interval_vec(line.to)}, {}};
}

Controls controls(const HermiteSpine& h) {
  const Interval third = Interval(1) / 3;
  const IntervalVec from = interval_vec(h.from), to = interval_vec(h.to);
  return {{from, from + third * interval_vec(h.start_velocity),
           to - third * interval_vec(h.end_velocity), to},
          {}};
}

Controls controls(const BezierSpine& bezier) {
  Controls result;
  for (std::size_t i = 0; i < bezier.points.size(); ++i) {
    const Interval weight = bezier.weights.empty() ? 1 : bezier.weights[i];
    result.points.push_back(weight * interval_vec(bezier.points[i]));
  }
  result.weights = {bezier.weights.begin(), bezier.weights.end()};
  return result;
}

// The Bernstein coefficients of p' w - p w' up to a factor, where the curve is p / w.
std::vector<IntervalVec> rational_tangents(const std::vector<IntervalVec>& p,
                                           const std::vector<Interval>& w) {
  const std::size_t n = p.size() - 1;
  std::vector<IntervalVec> result(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      const Interval share = Interval(binomial(n - 1, i).get_d() * binomial(n, j).get_d()) /
                             binomial(2 * n - 1, i + j).get_d();
      result[i + j] = result[i + j] + share * (w[j] * (p[i + 1] - p[i]) - (w[i + 1] - w[i]) * p[j]);
    }
  }
  return result;
}

struct ArcPart {
  std::vector<IntervalVec> centers, tangents;
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
  const IntervalVec u = interval_vec(arc.start) - interval_vec(arc.center);
  const IntervalVec v = cross(interval_vec(arc.axis), u);
  const Mpfi from = Mpfi(arc.angle) * t.from, to = Mpfi(arc.angle) * t.to;
  const auto spoke = [&](const Mpfi& turned) {
    return narrowed(cosine(turned)) * u + narrowed(sine(turned)) * v;
  };
  const auto direction = [&](const Mpfi& turned) {
    return narrowed(cosine(turned)) * v - narrowed(sine(turned)) * u;
  };
  const IntervalVec center = interval_vec(arc.center);
  const Interval stretch = Interval(1) / narrowed(cosine((to - from) / 2));
  return {{center + spoke(from), center + stretch * spoke((from + to) / 2), center + spoke(to)},
          {direction(from), direction(to)}};
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

std::vector<Interval> coefficients(const RadiusLaw& law) {
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

}  // namespace

Vec3 DiscHull::middle() const { return (center(centers.front()) + center(centers.back())) / 2; }

double DiscHull::extent() const {
  double length = 0;
  for (std::size_t i = 0; i + 1 < centers.size(); ++i) {
    length += (center(centers[i + 1]) - center(centers[i])).norm();
  }
  return length;
}

// A disc of normal T reaches as far as R |T x w|; the sine of the angle between T and w is largest
// at the normal nearest to a right angle, which the cone about the axis bounds.
double support(const DiscHull& hull, const Vec3& w) {
  const IntervalVec direction = interval_vec(w), axis = interval_vec(hull.axis);
  Interval sine = 1;
  if (hull.cosine > 0) {
    const Interval scale = norm(axis) * norm(direction), cosine = hull.cosine;
    const Interval across = norm(cross(axis, direction)) / scale;
    Interval along = dot(axis, direction) / scale;
    along = {0, along.magnitude()};
    if (across.upper <= hull.cosine) {
      sine = across * cosine + along * sqrt(Interval(1) - square(cosine));
    }
  }
  double furthest = -std::numeric_limits<double>::infinity();
  for (const IntervalVec& point : hull.centers) {
    furthest = std::max(furthest, dot(point, direction).upper);
  }
  const Interval reach = Interval(hull.radius.upper) * norm(direction) * std::min(sine.upper, 1.0);
  return (Interval(furthest) + reach).upper;
}

Vec3 support_point(const DiscHull& hull, const Vec3& direction) {
  Vec3 furthest = center(hull.centers.front());
  for (const IntervalVec& point : hull.centers) {
    if (center(point).dot(direction) > furthest.dot(direction)) {
      furthest = center(point);
    }
  }
  Vec3 across = direction;
  if (hull.cosine > 0) {
    across -= direction.dot(hull.axis) * hull.axis;
  }
  // Along the axis, what is left is rounding and every point of the disc is as far as its centre.
  const double length = across.norm();
  return length > 0x1p-40 * direction.norm() ? Vec3(furthest + hull.radius.upper / length * across)
                                             : furthest;
}

DiscSweep::DiscSweep(const Sphere& sphere) : sphere_(sphere) {}

DiscSweep::DiscSweep(const RingedSurface& surface, const std::array<double, 2>& extension)
    : surface_(surface), extension_(extension) {}

DiscSweep::Part DiscSweep::curve(const ParameterInterval& t) const {
  if (const auto* arc = std::get_if<ArcSpine>(&surface_.spine)) {
    ArcPart part = arc_part(*arc, t);
    return {std::move(part.centers), std::move(part.tangents)};
  }
  struct Visitor {
    Controls operator()(const LineSpine& s) const { return controls(s); }
    Controls operator()(const HermiteSpine& s) const { return controls(s); }
    Controls operator()(const BezierSpine& s) const { return controls(s); }
    Controls operator()(const ArcSpine&) const { return {}; }
  };
  const Controls whole = std::visit(Visitor{}, surface_.spine);
  const Interval range(t.from, t.to);
  Part part{bezier_part(whole.points, range), {}};
  if (whole.weights.empty()) {
    part.tangents = bezier_part(differences(whole.points), range);
    return part;
  }
  part.tangents = bezier_part(rational_tangents(whole.points, whole.weights), range);
  const auto weights = bezier_part(whole.weights, range);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    part.centers[i] = Interval(1) / weights[i] * part.centers[i];
  }
  return part;
}

DiscSweep::Part DiscSweep::extended(const ParameterInterval& t) const {
  const bool before = t.to <= 0;
  const Part end = curve({0, 1});
  const IntervalVec& from = before ? end.centers.front() : end.centers.back();
  const IntervalVec& along = before ? end.tangents.front() : end.tangents.back();
  const Interval length = extension_[before ? 0 : 1];
  const auto at = [&](double parameter) {
    return from + length * (Interval(parameter) - (before ? 0 : 1)) / norm(along) * along;
  };
  return {{at(t.from), at(t.to)}, {along}};
}

Interval DiscSweep::radius(const ParameterInterval& t) const {
  const auto* cyclide = std::get_if<CyclideRadius>(&surface_.radius);
  if (t.from >= 0 && t.to <= 1) {
    return cyclide != nullptr
               ? hull(enclosed_radius(*cyclide, t.from), enclosed_radius(*cyclide, t.to))
               : bezier_range(coefficients(surface_.radius), {t.from, t.to});
  }
  const bool before = t.to <= 0;
  const double seam = before ? 0 : 1;
  const Interval distance =
      extension_[before ? 0 : 1] * hull(Interval(t.from) - seam, Interval(t.to) - seam);
  const Interval slope = before ? -surface_.start.slope : surface_.end.slope;
  return evaluate(surface_.radius, seam).value + distance * slope;
}

DiscHull DiscSweep::over(const ParameterInterval& t) const {
  if (sphere_) {
    return {{interval_vec(sphere_->center)}, {}, Vec3::Zero(), 0, sphere_->radius};
  }
  Part part = t.from >= 0 && t.to <= 1 ? curve(t) : extended(t);
  DiscHull result{std::move(part.centers), std::move(part.tangents), Vec3::Zero(), 1, radius(t)};
  for (const IntervalVec& tangent : result.tangents) {
    result.axis += center(tangent).normalized();
  }
  result.axis.normalize();
  const IntervalVec axis = interval_vec(result.axis);
  for (const IntervalVec& tangent : result.tangents) {
    const Interval scale = norm(tangent) * norm(axis);
    const double cosine = scale.lower > 0 ? (dot(tangent, axis) / scale).lower : 0;
    result.cosine = std::min(result.cosine, std::max(cosine, 0.0));
  }
  return result;
}

// The direction of a Bezier polynomial turns by no more than that of its control polygon.
double DiscSweep::turning(const ParameterInterval& t) const {
  const std::vector<IntervalVec> tangents = curve(t).tangents;
  Interval sum = 0;
  for (std::size_t i = 0; i + 1 < tangents.size(); ++i) {
    sum = sum + angle_between(tangents[i], tangents[i + 1]);
  }
  return sum.upper;
}

bool DiscSweep::turns_little(const ParameterInterval& t, double margin) const {
  const ParameterInterval inner{std::clamp(t.from, 0.0, 1.0), std::clamp(t.to, 0.0, 1.0)};
  // A little less than proven to be enough, for a checker's own rounding.
  constexpr double kSlack = 1 - 0x1p-40;
  if (inner.from < inner.to && !(turning(inner) <= std::numbers::pi / 2 * kSlack)) {
    return false;
  }
  Interval all = radius(inner);
  std::vector<double> trends;
  bool monotone = true;
  if (inner.from < inner.to) {
    const auto own = trend(surface_.radius);
    monotone = own.has_value();
    trends.push_back(own.value_or(0));
  }
  if (t.from < 0) {
    all = hull(all, radius({t.from, std::min(t.to, 0.0)}));
    trends.push_back(-surface_.start.slope);
  }
  if (t.to > 1) {
    all = hull(all, radius({std::max(t.from, 1.0), t.to}));
    trends.push_back(surface_.end.slope);
  }
  if (!(all.lower > 0)) {
    return false;
  }
  const auto [least, most] = std::minmax_element(trends.begin(), trends.end());
  return (monotone && (*least >= 0 || *most <= 0)) ||
         ((Interval(1) - margin) * all.upper).upper <= all.lower * kSlack;
}

}  // namespace dupin::detail
