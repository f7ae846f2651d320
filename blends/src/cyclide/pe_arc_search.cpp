#include "cyclide/pe_arc_search.h"

#include <cmath>
#include <limits>
#include <utility>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::cyclide {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSearchSamples = 64;

// The conic of all possible junctions: points of an arc that itself need not be a tube. The
// complementary half is reached by the negated tangent.
class JunctionLocus {
 public:
  JunctionLocus(const PeVector& start, const PeVector& start_tangent, const PeVector& end,
                const PeVector& end_tangent)
      : start_(start), end_(end) {
    const PeVector v = end - start;
    const double vv = squared_tangential_distance(start, end);
    const PeVector direction =
        start_tangent + ((2 * product(v, end_tangent) / vv) * v - end_tangent);
    const double norm2 = product(direction, direction);
    exists_ = vv > 0 && norm2 > 0;
    if (exists_) {
      chord_ = std::sqrt(vv);
      tangent_ = (1 / std::sqrt(norm2)) * direction;
      w_ = product(v, tangent_) / chord_;
    }
  }

  [[nodiscard]] bool exists() const { return exists_ && w_ > -1; }

  [[nodiscard]] double weight() const { return w_; }

  [[nodiscard]] PeVector at(double tau) const {
    const double b0 = (1 - tau) * (1 - tau), b1 = 2 * tau * (1 - tau), b2 = tau * tau;
    const PeVector middle = w_ * start_ + (chord_ / 2) * tangent_;
    return (1 / (b0 + b1 * w_ + b2)) * (b0 * start_ + b1 * middle + b2 * end_);
  }

 private:
  PeVector start_, end_, tangent_;
  double chord_ = 0, w_ = 0;
  bool exists_ = false;
};

[[noreturn]] void refuse_locus() {
  throw Error(Errc::infeasible_blend,
              "no double-cyclide blend: the ends have no locus of junction spheres; move the "
              "ends apart or turn them towards each other");
}

JunctionLocus required_locus(const PeVector& start, const PeVector& start_tangent,
                             const PeVector& end, const PeVector& end_tangent) {
  JunctionLocus locus(start, start_tangent, end, end_tangent);
  if (!locus.exists()) {
    refuse_locus();
  }
  return locus;
}

// Minimises `objective` (infinite where invalid) over tau in (0, 1): samples, then golden section
// around the best.
template <class Objective>
double best_tau(Objective objective) {
  // Of samples that are equal but for rounding, as mirrored ones are, always the first.
  constexpr double kLess = 1 - 0x1p-30;
  double best = 0, value = kInfinity;
  for (int i = 1; i < kSearchSamples; ++i) {
    const double tau = static_cast<double>(i) / kSearchSamples, f = objective(tau);
    if (f < kLess * value) {
      value = f;
      best = tau;
    }
  }
  if (value == kInfinity) {
    return -1;
  }
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = best - 1.0 / kSearchSamples, high = best + 1.0 / kSearchSamples;
  while (high - low > std::ldexp(1.0, -40)) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    if (a <= 0 || b >= 1 || objective(a) <= objective(b)) {
      high = b;
    } else {
      low = a;
    }
    if (low <= 0) {
      low = std::ldexp(1.0, -41);
    }
  }
  const double refined = (low + high) / 2;
  return refined > 0 && refined < 1 && objective(refined) <= value ? refined : best;
}

// Whether the junction of `tau` gives two regular pieces, by the rounded numbers.
bool seems_regular(const JunctionLocus& locus, const PeVector& start, const PeVector& start_tangent,
                   const PeVector& end, double tau) {
  const PeVector junction = locus.at(tau);
  if (!(junction.r > 0) || !junction.m.allFinite()) {
    return false;
  }
  const ArcValidity first = rounded_validity(start, start_tangent, junction);
  if (first.fault != ArcFault::none) {
    return false;
  }
  const PeVector tangent =
      (2 * first.w / std::sqrt(first.squared_length)) * (junction - start) - start_tangent;
  return rounded_validity(junction, tangent, end).fault == ArcFault::none;
}

DoubleCyclide at_tau(const JunctionLocus& locus, const PeVector& start,
                     const PeVector& start_tangent, const PeVector& end, double tau) {
  const PeVector junction = locus.at(tau);
  if (!(junction.r > 0)) {
    throw Error(Errc::infeasible_blend,
                "no double-cyclide blend: the junction sphere would have the radius " +
                    decimal(junction.r, kMessageDigits) + "; choose another tau");
  }
  PeArc first = PeArc::from(start, start_tangent, junction);
  PeArc second = PeArc::from(first.end(), first.end_tangent(), end);
  return {std::move(first), std::move(second), tau};
}

}  // namespace

DoubleCyclide double_at(const PeVector& start, const PeVector& start_tangent, const PeVector& end,
                        const PeVector& end_tangent, double tau) {
  return at_tau(required_locus(start, start_tangent, end, end_tangent), start, start_tangent, end,
                tau);
}

DoubleCyclide best_double(const PeVector& start, const PeVector& start_tangent, const PeVector& end,
                          const PeVector& end_tangent,
                          const std::function<double(const DoubleCyclide&)>& objective) {
  const JunctionLocus locus = required_locus(start, start_tangent, end, end_tangent);
  const double tau = best_tau([&](double t) {
    if (!seems_regular(locus, start, start_tangent, end, t)) {
      return kInfinity;
    }
    try {
      return objective(at_tau(locus, start, start_tangent, end, t));
    } catch (const Error& error) {
      if (error.code() != Errc::infeasible_blend) {
        throw;
      }
      return kInfinity;  // what is irregular by less than rounding
    }
  });
  if (tau < 0) {
    throw Error(Errc::infeasible_blend,
                "no double-cyclide blend: no junction sphere of the locus gives two regular "
                "pieces; use three pieces or move the ends apart");
  }
  return at_tau(locus, start, start_tangent, end, tau);
}

// The locus is 1 / sqrt(1 - w^2) chords wide: 22 at the least weight that is taken. The root in the
// tangent and the chord's direction leave an error of a few ulps in w, far below the first bound.
void refuse_far_locus(const PeVector& start, const PeVector& start_tangent, const PeVector& end,
                      const PeVector& end_tangent) {
  constexpr double kAtInfinity = -1 + 0x1p-40, kLeastWeight = -1 + 0x1p-10;
  const double w = required_locus(start, start_tangent, end, end_tangent).weight();
  if (w < kAtInfinity) {
    refuse_locus();
  }
  if (w < kLeastWeight) {
    throw Error(Errc::infeasible_blend,
                "no double-cyclide blend: the locus of junction spheres leads nearly through "
                "infinity; move the ends apart or turn them towards each other");
  }
}

double tangent_rounding(const PeVector& start, const PeVector& end) {
  const double chord = std::sqrt(squared_tangential_distance(start, end));
  const double size = start.m.cwiseAbs().maxCoeff() + end.m.cwiseAbs().maxCoeff() +
                      (end.m - start.m).norm() + start.r + end.r;
  return 64 * std::numeric_limits<double>::epsilon() * size / chord;
}

}  // namespace dupin::cyclide
