#include "dupin/blends/cyclide_chain.h"

#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "cyclide/double_search.h"
#include "cyclide/rounded_validity.h"
#include "cyclide/tangent_rounding.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSearchSamples = 64;

double euclidean_square(const PeVector& a, const PeVector& b) {
  return (a.m - b.m).squaredNorm() + (a.r - b.r) * (a.r - b.r);
}

PeVector normalised(const PeVector& a) { return (1 / std::sqrt(product(a, a))) * a; }

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

[[noreturn]] void throw_no_locus() {
  throw Error(Errc::infeasible_blend,
              "no double-cyclide blend: the ends have no locus of junction spheres; move the ends "
              "apart or turn them towards each other");
}

// Minimises `objective` (infinite where invalid) over tau in (0, 1): samples, then golden section
// around the best.
template <class Objective>
double best_tau(Objective objective) {
  double best = 0, value = kInfinity;
  for (int i = 1; i < kSearchSamples; ++i) {
    const double tau = static_cast<double>(i) / kSearchSamples, f = objective(tau);
    if (f < value) {
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
  const ArcValidity first = cyclide::rounded_validity(start, start_tangent, junction);
  if (first.fault != ArcFault::none) {
    return false;
  }
  const PeVector tangent =
      (2 * first.w / std::sqrt(first.squared_length)) * (junction - start) - start_tangent;
  return cyclide::rounded_validity(junction, tangent, end).fault == ArcFault::none;
}

DoubleCyclide at_tau(const JunctionLocus& locus, const PeVector& start,
                     const PeVector& start_tangent, const PeVector& end, double tau) {
  const PeVector junction = locus.at(tau);
  if (!(junction.r > 0)) {
    throw Error(Errc::infeasible_blend,
                "no double-cyclide blend: the junction sphere would have the radius " +
                    decimal(junction.r) + "; choose another tau");
  }
  PeArc first = PeArc::from(start, start_tangent, junction);
  PeArc second = PeArc::from(first.end(), first.end_tangent(), end);
  return {std::move(first), std::move(second), tau};
}

void check_junction(std::size_t junction, std::size_t last) {
  if (junction < 1 || junction > last) {
    throw Error(Errc::invalid_argument, "junction " + std::to_string(junction) +
                                            " cannot be moved; the junctions 1 to " +
                                            std::to_string(last) + " can");
  }
}

// The tangents of a double-cyclide blend's end and of what it meets there are equal but for what
// cancellation leaves of the spheres' coordinates.
void check_pin(const PeVector& arriving, const PinnedTangent& pin, const PeVector& before,
               const PeVector& at) {
  const PeVector miss = arriving - pin.tangent;
  const double size = std::hypot(miss.m.norm(), miss.r);
  if (!(size <= cyclide::tangent_rounding(before, at))) {
    throw Error(Errc::invalid_argument,
                "the tangent given at sphere " + std::to_string(pin.sphere) +
                    " must be the arriving one up to rounding, but differs by " + decimal(size));
  }
}

PeVector turned(const PeVector& a, const Eigen::AngleAxisd& rotation, const Vec3& center) {
  return {center + rotation * (a.m - center), a.r};
}

}  // namespace

namespace cyclide {

DoubleCyclide best_double(const PeVector& start, const PeVector& start_tangent, const PeVector& end,
                          const PeVector& end_tangent,
                          const std::function<double(const DoubleCyclide&)>& objective) {
  const JunctionLocus locus(start, start_tangent, end, end_tangent);
  if (!locus.exists()) {
    throw_no_locus();
  }
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

}  // namespace cyclide

double bending(const PeArc& arc) {
  // The squared PE curvature <K, K> = 4 (1 - w^2) / L^2 is constant along the arc.
  return 4 * std::abs((1 - arc.w()) * (1 + arc.w())) / (arc.chord() * arc.chord()) * pe_length(arc);
}

PeVector initial_tangent(const PeVector& first, const PeVector& second, const PeVector& third) {
  const PeVector d1 = second - first, d2 = third - first;
  const double s1 = squared_tangential_distance(first, second);
  const double s2 = squared_tangential_distance(first, third);
  if (!(s1 > 0 && s2 > 0 && squared_tangential_distance(second, third) > 0)) {
    throw Error(Errc::infeasible_blend,
                "no cyclide through three spheres of which one contains another");
  }
  return normalised((1 / s1) * d1 - (1 / s2) * d2);
}

PeArc through_three(const PeVector& first, const PeVector& second, const PeVector& third) {
  return PeArc::from(first, initial_tangent(first, second, third), third);
}

CyclideChain compose(std::span<const PeVector> spheres, const PeVector& tangent,
                     std::span<const PinnedTangent> pinned) {
  if (spheres.size() < 3 || spheres.size() % 2 == 0) {
    throw Error(Errc::invalid_argument,
                "a chain needs an odd number of spheres, three at least, not " +
                    std::to_string(spheres.size()));
  }
  CyclideChain chain;
  PeVector direction = tangent;
  for (std::size_t i = 0; i + 2 < spheres.size(); i += 2) {
    for (const PinnedTangent& pin : pinned) {
      if (pin.sphere == i) {
        check_pin(direction, pin, i == 0 ? spheres[0] : spheres[i - 2], spheres[i]);
        direction = pin.tangent;
      }
    }
    try {
      chain.pieces.push_back(PeArc::from(spheres[i], direction, spheres[i + 2]));
    } catch (const Error& error) {
      throw PieceError(i / 2, error);
    }
    direction = chain.pieces.back().end_tangent();
  }
  return chain;
}

std::vector<std::size_t> bias_warnings(const CyclideChain& chain,
                                       std::span<const PeVector> spheres) {
  std::vector<std::size_t> warnings;
  for (std::size_t i = 0; i < chain.pieces.size() && 2 * i + 1 < spheres.size(); ++i) {
    const auto p = bezier_points(chain.pieces[i]);
    double forward = kInfinity, complementary = kInfinity;
    for (int k = 0; k <= kSearchSamples; ++k) {
      const double t = static_cast<double>(k) / kSearchSamples;
      const double b0 = (1 - t) * (1 - t), b1 = 2 * t * (1 - t), b2 = t * t;
      for (const double sign : {1.0, -1.0}) {
        const double weight = b0 + sign * b1 * p[1].weight + b2;
        const PeVector q =
            (1 / weight) * (b0 * p[0].sphere + (sign * b1) * p[1].sphere + b2 * p[2].sphere);
        double& least = sign > 0 ? forward : complementary;
        if (weight != 0) {  // else a point at infinity, which is near nothing
          least = std::min(least, euclidean_square(q, spheres[2 * i + 1]));
        }
      }
    }
    if (complementary < forward) {
      warnings.push_back(i);
    }
  }
  return warnings;
}

DoubleCyclide double_cyclide(const PeVector& start, const PeVector& start_tangent,
                             const PeVector& end, const PeVector& end_tangent, double tau) {
  if (!(tau > 0 && tau < 1)) {
    throw Error(Errc::invalid_argument, "the junction parameter tau must lie between 0 and 1");
  }
  const JunctionLocus locus(start, start_tangent, end, end_tangent);
  if (!locus.exists()) {
    throw_no_locus();
  }
  return at_tau(locus, start, start_tangent, end, tau);
}

DoubleCyclide double_cyclide(const PeVector& start, const PeVector& start_tangent,
                             const PeVector& end, const PeVector& end_tangent) {
  return cyclide::best_double(start, start_tangent, end, end_tangent, [](const DoubleCyclide& d) {
    return bending(d.first) + bending(d.second);
  });
}

DoubleCyclide double_cyclide_near(const PeVector& start, const PeVector& start_tangent,
                                  const PeVector& end, const PeVector& end_tangent,
                                  const PeVector& sphere) {
  return cyclide::best_double(start, start_tangent, end, end_tangent, [&](const DoubleCyclide& d) {
    return euclidean_square(d.first.end(), sphere);
  });
}

EditedChain move_on_locus(const CyclideChain& chain, std::size_t junction, const PeVector& sphere) {
  check_junction(junction, chain.pieces.size() - 1);
  const PeArc &before = chain.pieces[junction - 1], &after = chain.pieces[junction];
  DoubleCyclide pair = double_cyclide_near(before.start(), before.start_tangent(), after.end(),
                                           after.end_tangent(), sphere);
  EditedChain edited{chain, {junction - 1, junction}};
  edited.chain.pieces[junction - 1] = std::move(pair.first);
  edited.chain.pieces[junction] = std::move(pair.second);
  return edited;
}

EditedChain move_junction(const CyclideChain& chain, std::size_t junction, const PeVector& sphere) {
  check_junction(junction, chain.pieces.size() - 2);
  const PeArc &before = chain.pieces[junction - 1], &last = chain.pieces[junction + 1];
  PeArc first = PeArc::from(before.start(), before.start_tangent(), sphere);
  DoubleCyclide pair = double_cyclide_near(first.end(), first.end_tangent(), last.end(),
                                           last.end_tangent(), last.start());
  EditedChain edited{chain, {junction - 1, junction, junction + 1}};
  edited.chain.pieces[junction - 1] = std::move(first);
  edited.chain.pieces[junction] = std::move(pair.first);
  edited.chain.pieces[junction + 1] = std::move(pair.second);
  return edited;
}

EditedChain twist(const CyclideChain& chain, std::size_t junction, double angle) {
  check_junction(junction, chain.pieces.size() - 1);
  const PeVector hinge = chain.pieces[junction].start();
  const Eigen::AngleAxisd rotation(angle, chain.pieces[junction].start_tangent().m.normalized());
  EditedChain edited{chain, {}};
  PeVector direction = chain.pieces[junction].start_tangent();
  for (std::size_t i = junction; i < chain.pieces.size(); ++i) {
    const PeVector start = i == junction ? hinge : edited.chain.pieces[i - 1].end();
    edited.chain.pieces[i] =
        PeArc::from(start, direction, turned(chain.pieces[i].end(), rotation, hinge.m));
    direction = edited.chain.pieces[i].end_tangent();
    edited.changed.push_back(i);
  }
  return edited;
}

CyclideChain offset(const CyclideChain& chain, double h) {
  CyclideChain result;
  const PeVector shift{Vec3::Zero(), h};
  PeVector direction;
  for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
    const PeArc& piece = chain.pieces[i];
    direction = i == 0 ? piece.start_tangent() : direction;
    try {
      result.pieces.push_back(PeArc::from(piece.start() + shift, direction, piece.end() + shift));
    } catch (const Error& error) {
      throw PieceError(i, error);
    }
    direction = result.pieces.back().end_tangent();
  }
  return result;
}

}  // namespace dupin
