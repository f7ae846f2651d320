#include "ringed/curvature_ratio.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "curves/exact_spine.h"
#include "dupin/kernel/error.h"

namespace dupin::ringed {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// For y' = h / w^2: y' x y'' = h x h' / w^4, so kappa^2 = |h x h'|^2 w^4 / |h|^6.
SquaredCurvature of_velocity(const numbers::VectorPolynomial& h,
                             const numbers::Polynomial& w = {1}) {
  const numbers::Polynomial v = numbers::squared_norm(h);
  const numbers::Polynomial c = numbers::trimmed(
      numbers::squared_norm(numbers::trimmed(numbers::cross(h, numbers::derivative(h)))));
  return {numbers::product(c, numbers::square(numbers::square(w))),
          numbers::product(v, numbers::square(v))};
}

// Multiplies both by their common denominator.
void make_integers(std::vector<mpq_class> a, const std::vector<mpq_class>& b,
                   numbers::Bernstein& a_out, numbers::Bernstein& b_out) {
  const auto size = static_cast<std::ptrdiff_t>(a.size());
  a.insert(a.end(), b.begin(), b.end());
  const numbers::OverDenominator both(a);
  a_out.assign(both.numerators.begin(), both.numerators.begin() + size);
  b_out.assign(both.numerators.begin() + size, both.numerators.end());
}

numbers::Interval at_end_point(const mpz_class& numerator, const mpz_class& denominator,
                               const numbers::Interval* radius) {
  if (sgn(denominator) <= 0) {
    return numbers::Interval::whole();  // the spine stops
  }
  const numbers::Interval q = numbers::quotient(numerator, denominator);
  if (radius == nullptr) {
    return q;
  }
  return {std::max(0.0, numbers::next_below(q.lower *
                                            numbers::next_below(radius->lower * radius->lower))),
          numbers::next_above(q.upper * numbers::next_above(radius->upper * radius->upper))};
}

bool refutes_at(const mpz_class& numerator, const mpz_class& denominator,
                const numbers::Interval* radius, const mpq_class& bound) {
  mpq_class squared_radius = 1;
  if (radius != nullptr) {
    squared_radius = mpq_class(radius->lower) * radius->lower;
  }
  return squared_radius * numerator >= bound * denominator;
}

}  // namespace

SquaredCurvature squared_curvature(const Spine& spine) {
  struct Visitor {
    SquaredCurvature operator()(const LineSpine& line) const {
      return {{0}, numbers::squared_norm(curves::velocity(line))};
    }
    SquaredCurvature operator()(const ArcSpine& arc) const {
      return {{1}, numbers::squared_norm({numbers::exact(arc.start) - numbers::exact(arc.center)})};
    }
    SquaredCurvature operator()(const HermiteSpine& hermite) const {
      return of_velocity(curves::velocity(hermite));
    }
    SquaredCurvature operator()(const BezierSpine& bezier) const {
      const curves::RationalVelocity v = curves::velocity(bezier);
      return of_velocity(v.numerator, v.weight);
    }
  };
  return std::visit(Visitor{}, spine);
}

CurvatureRatio::CurvatureRatio(const RingedSurface& surface) {
  const SquaredCurvature curvature = squared_curvature(surface.spine);
  const std::optional<numbers::Polynomial> radius = curves::polynomial(surface.radius);
  const numbers::Polynomial numerator =
      radius ? numbers::product(curvature.numerator, numbers::square(*radius))
             : curvature.numerator;
  // Without the radius, room is left for the square of its linear bound.
  const std::size_t room = radius ? 0 : 2;
  const std::size_t degree =
      std::max(numerator.size() - 1 + room, curvature.denominator.size() - 1);
  make_integers(numbers::bernstein(numerator, degree - room),
                numbers::bernstein(curvature.denominator, degree), whole_.numerator,
                whole_.denominator);
  if (!radius) {
    law_ = std::get<CyclideRadius>(surface.radius);
    if (!(std::isfinite(law_->start * law_->end) && law_->start > 0 && law_->end > 0)) {
      throw Error(Errc::invalid_argument, "a surface's radii must be positive, finite numbers");
    }
    second_derivative_bound_ = curves::second_derivative_bound(*law_);
    whole_.start_radius = curves::enclosed_radius(*law_, 0);
    whole_.end_radius = curves::enclosed_radius(*law_, 1);
  }
}

std::pair<CurvatureRatio::Leaf, CurvatureRatio::Leaf> CurvatureRatio::split(
    const Leaf& leaf) const {
  auto [numerator_left, numerator_right] = numbers::halves(leaf.numerator);
  auto [denominator_left, denominator_right] = numbers::halves(leaf.denominator);
  const double middle = (leaf.from + leaf.to) / 2;
  Leaf left{leaf.from,
            middle,
            leaf.depth + 1,
            std::move(numerator_left),
            std::move(denominator_left),
            leaf.start_radius,
            {}};
  Leaf right{middle,
             leaf.to,
             leaf.depth + 1,
             std::move(numerator_right),
             std::move(denominator_right),
             {},
             leaf.end_radius};
  if (law_) {
    left.end_radius = right.start_radius = curves::enclosed_radius(*law_, middle);
    // The numerator's degree is lower by two, so its halves lack a factor of 4.
    for (Leaf* half : {&left, &right}) {
      for (mpz_class& x : half->numerator) {
        x <<= 2;
      }
    }
  }
  return {std::move(left), std::move(right)};
}

// How far the radius may leave its chord on the leaf.
double CurvatureRatio::bulge(const Leaf& leaf) const {
  const double h = leaf.to - leaf.from;  // exact: dyadic
  return numbers::next_above(second_derivative_bound_ * (h * h / 8));
}

CurvatureRatio::Scaled CurvatureRatio::with_radius(const Leaf& leaf, const Line& radius) const {
  const mpq_class start(radius.start), end(radius.end);
  const mpz_class scale = lcm(start.get_den(), end.get_den());  // a power of two
  const mpz_class a(start.get_num() * (scale / start.get_den()));
  const mpz_class b(end.get_num() * (scale / end.get_den()));
  const numbers::Bernstein squared_line{a * a, 2 * a * b, b * b};
  const numbers::Bernstein rest = numbers::binomial_scaled(leaf.numerator);
  Scaled result{numbers::Bernstein(rest.size() + 2),
                -2 * static_cast<long>(mpz_sizeinbase(scale.get_mpz_t(), 2) - 1)};
  for (std::size_t i = 0; i < rest.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result.coefficients[i + j] += rest[i] * squared_line[j];
    }
  }
  return result;
}

// The radius is monotone and near its chord; the tighter of both bounds is used.
CurvatureRatio::Scaled CurvatureRatio::upper_numerator(const Leaf& leaf) const {
  if (!law_) {
    return {numbers::binomial_scaled(leaf.numerator), 0};
  }
  const double start = leaf.start_radius.upper, end = leaf.end_radius.upper, e = bulge(leaf);
  const double largest = std::max(start, end);
  return with_radius(leaf, 2 * e < std::abs(end - start)
                               ? Line{numbers::next_above(start + e), numbers::next_above(end + e)}
                               : Line{largest, largest});
}

CurvatureRatio::Scaled CurvatureRatio::lower_numerator(const Leaf& leaf) const {
  if (!law_) {
    return {numbers::binomial_scaled(leaf.numerator), 0};
  }
  const double start = leaf.start_radius.lower, end = leaf.end_radius.lower, e = bulge(leaf);
  const double least = std::min(start, end);
  const Line chord{numbers::next_below(start - e), numbers::next_below(end - e)};
  const bool use_chord = 2 * e < std::abs(end - start) && std::min(chord.start, chord.end) > 0;
  return with_radius(leaf, use_chord ? chord : Line{least, least});
}

numbers::Interval CurvatureRatio::range(const Leaf& leaf) const {
  const numbers::Bernstein denominator = numbers::binomial_scaled(leaf.denominator);
  if (std::any_of(denominator.begin(), denominator.end(),
                  [](const mpz_class& x) { return sgn(x) <= 0; })) {
    return {0, kInfinity};
  }
  // A quotient of Bernstein polynomials with positive denominators lies between its least and
  // largest coefficient quotients.
  double least = kInfinity, most = 0;
  const Scaled upper = upper_numerator(leaf);
  const Scaled lower = law_ ? lower_numerator(leaf) : upper;
  for (std::size_t i = 0; i < denominator.size(); ++i) {
    if (sgn(upper.coefficients[i]) > 0) {
      most = std::max(
          most, numbers::quotient(upper.coefficients[i], denominator[i], upper.exponent).upper);
    }
    least =
        sgn(lower.coefficients[i]) <= 0
            ? 0
            : std::min(
                  least,
                  numbers::quotient(lower.coefficients[i], denominator[i], lower.exponent).lower);
  }
  return {least, most};
}

numbers::Interval CurvatureRatio::at_start(const Leaf& leaf) const {
  return at_end_point(leaf.numerator.front(), leaf.denominator.front(),
                      law_ ? &leaf.start_radius : nullptr);
}

numbers::Interval CurvatureRatio::at_end(const Leaf& leaf) const {
  return at_end_point(leaf.numerator.back(), leaf.denominator.back(),
                      law_ ? &leaf.end_radius : nullptr);
}

bool CurvatureRatio::proves_below(const Leaf& leaf, const mpq_class& bound) const {
  const numbers::Bernstein denominator = numbers::binomial_scaled(leaf.denominator);
  const Scaled upper = upper_numerator(leaf);
  const mpz_class& numerator_factor = bound.get_den();
  const mpz_class denominator_factor = bound.get_num()
                                       << static_cast<unsigned long>(-upper.exponent);
  for (std::size_t i = 0; i < denominator.size(); ++i) {
    if (numerator_factor * upper.coefficients[i] >= denominator_factor * denominator[i]) {
      return false;
    }
  }
  return true;
}

bool CurvatureRatio::refutes_below(const Leaf& leaf, const mpq_class& bound) const {
  return refutes_at(leaf.numerator.front(), leaf.denominator.front(),
                    law_ ? &leaf.start_radius : nullptr, bound) ||
         refutes_at(leaf.numerator.back(), leaf.denominator.back(),
                    law_ ? &leaf.end_radius : nullptr, bound);
}

}  // namespace dupin::ringed
