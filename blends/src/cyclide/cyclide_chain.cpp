#include "dupin/blends/cyclide_chain.h"

#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "cyclide/pe_arc_search.h"
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
                    " must be the arriving one up to rounding, but differs by " +
                    decimal(size, kMessageDigits));
  }
}

PeVector turned(const PeVector& a, const Eigen::AngleAxisd& rotation, const Vec3& center) {
  return {center + rotation * (a.m - center), a.r};
}

}  // namespace

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
  return cyclide::double_at(start, start_tangent, end, end_tangent, tau);
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
