#include "dupin/blends/cyclide_blend.h"

#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"
#include "tangent_rounding.h"

namespace dupin {
namespace {

struct Ends {
  PeVector start, start_tangent, end, end_tangent;
};

double size(const Ends& e) { return (e.end.m - e.start.m).norm() + e.start.r + e.end.r; }

std::optional<CyclideChain> single(const Ends& e) {
  if (validity(e.start, e.start_tangent, e.end).fault != ArcFault::none) {
    return std::nullopt;
  }
  PeArc arc = PeArc::from(e.start, e.start_tangent, e.end);
  const PeVector miss = arc.end_tangent() - e.end_tangent;
  if (std::hypot(miss.m.norm(), miss.r) > detail::tangent_rounding(e.start, e.end)) {
    return std::nullopt;
  }
  return CyclideChain{{std::move(arc)}};
}

std::optional<CyclideChain> two(const Ends& e) {
  try {
    DoubleCyclide d = double_cyclide(e.start, e.start_tangent, e.end, e.end_tangent);
    return CyclideChain{{std::move(d.first), std::move(d.second)}};
  } catch (const Error& error) {
    if (error.code() != Errc::infeasible_blend) {
      throw;
    }
    return std::nullopt;
  }
}

// The radical inverse: deterministic points that fill [0, 1) evenly (Halton 1960).
double radical_inverse(unsigned index, unsigned base) {
  double result = 0, digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) {
    result += digit * (index % base);
  }
  return result;
}

double total_bending(const CyclideChain& chain) {
  double sum = 0;
  for (const PeArc& piece : chain.pieces) {
    sum += bending(piece);
  }
  return sum;
}

// Three pieces: a first junction anywhere around the ends, then a double blend; the least bending
// of those that are regular.
std::optional<CyclideChain> three(const Ends& e) {
  constexpr unsigned kCandidates = 192, kEnough = 8;
  unsigned regular = 0;
  std::optional<CyclideChain> best;
  const Vec3 middle = (e.start.m + e.end.m) / 2;
  const double reach = size(e);
  for (unsigned i = 1; i <= kCandidates && regular < kEnough; ++i) {
    const Vec3 place(radical_inverse(i, 2), radical_inverse(i, 3), radical_inverse(i, 5));
    const double s = radical_inverse(i, 7);
    const PeVector junction{middle + reach * (2 * place - Vec3::Ones()),
                            (1 - s) * e.start.r + s * e.end.r};
    if (validity(e.start, e.start_tangent, junction).fault != ArcFault::none) {
      continue;
    }
    const PeArc first = PeArc::from(e.start, e.start_tangent, junction);
    auto rest = two({junction, first.end_tangent(), e.end, e.end_tangent});
    if (!rest) {
      continue;
    }
    ++regular;
    rest->pieces.insert(rest->pieces.begin(), first);
    if (!best || total_bending(*rest) < total_bending(*best)) {
      best = std::move(rest);
    }
  }
  return best;
}

}  // namespace

CyclideTube cyclide_blend(const Ring& from, const Ring& to) {
  validate(from);
  validate(to);
  if (from.ellipse || to.ellipse) {
    throw Error(Errc::invalid_argument,
                "cyclides join circles only; a cyclic_blend joins ellipses too");
  }
  const Ring arrival = flipped(to);
  const Ends ends{contact_sphere(from), contact_tangent(from), contact_sphere(arrival),
                  contact_tangent(arrival)};
  for (const auto attempt : {single, two, three}) {
    if (auto chain = attempt(ends)) {
      return {flipped(from), arrival, std::move(*chain), 0};
    }
  }
  throw Error(
      Errc::infeasible_blend,
      "no chain of up to three cyclide pieces joins these ends; move them further apart, or "
      "use a cyclic_blend");
}

}  // namespace dupin
