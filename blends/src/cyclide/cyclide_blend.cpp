#include "dupin/blends/cyclide_blend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "cyclide/pe_arc_search.h"
#include "cyclide/piece_crossing.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

struct Ends {
  PeVector start, start_tangent, end, end_tangent;
  Ring from, to;  // normals in travel direction
};

// What there is, or why there is nothing.
struct Attempt {
  std::optional<CyclideChain> chain;
  std::string reason;
};

double size(const Ends& e) { return (e.end.m - e.start.m).norm() + e.start.r + e.end.r; }

// What makes regular pieces a bad blend; empty for nothing. Turning beyond this share of a circle
// leads far away, where coordinates lose digits; of a lesser margin, meshes cross themselves.
std::string flaw(const std::vector<PeArc>& pieces, const Ends& e) {
  constexpr double kThinnest = 1.0 / 8, kLeastWeight = -15.0 / 16, kLeastMargin = 1.0 / 64;
  const double thinnest = kThinnest * std::min(e.from.radius, e.to.radius);
  for (const PeArc& piece : pieces) {
    const double least = least_radius(piece);
    if (least < thinnest) {
      return "it would get as thin as " + decimal(least, 3);
    }
    if (piece.w() < kLeastWeight) {
      return "it would turn nearly all round";
    }
    const double least_margin = margin(piece).lower;
    if (least_margin < kLeastMargin) {
      return "it would all but fold: its margin 1 - kappa R is " + decimal(least_margin, 3);
    }
  }
  return cyclide::pieces_cross(pieces, e.from, e.to)
             ? "it would cross itself or the parts at its ends"
             : "";
}

Attempt single(const Ends& e) {
  try {
    PeArc arc = PeArc::from(e.start, e.start_tangent, e.end);
    const PeVector& arriving = arc.end_tangent();
    const PeVector miss = arriving - e.end_tangent;
    if (std::hypot(miss.m.norm(), miss.r) > cyclide::tangent_rounding(e.start, e.end)) {
      const double axes =
          std::atan2(arriving.m.cross(e.end_tangent.m).norm(), arriving.m.dot(e.end_tangent.m));
      const double halves = std::atan(arriving.r) - std::atan(e.end_tangent.r);
      const auto degrees = [](double x) {
        return decimal(std::abs(x) * 180 / std::numbers::pi, 3) + " degrees";
      };
      return {{},
              "its end would be off the port's axis by " + degrees(axes) +
                  " and off its half angle by " + degrees(halves)};
    }
    std::string reason = flaw({arc}, e);
    return {reason.empty() ? std::optional(CyclideChain{{std::move(arc)}}) : std::nullopt, reason};
  } catch (const Error& error) {
    return {{}, error.message()};
  }
}

double bending_of(const DoubleCyclide& d) { return bending(d.first) + bending(d.second); }

// The sound one of least bending; the reason is that of the one of least bending of all.
Attempt two(const Ends& e) {
  std::string first_flaw;
  try {
    cyclide::refuse_far_locus(e.start, e.start_tangent, e.end, e.end_tangent);
    const DoubleCyclide any = double_cyclide(e.start, e.start_tangent, e.end, e.end_tangent);
    first_flaw = flaw({any.first, any.second}, e);
    if (first_flaw.empty()) {
      return {CyclideChain{{any.first, any.second}}, {}};
    }
    DoubleCyclide sound = cyclide::best_double(
        e.start, e.start_tangent, e.end, e.end_tangent, [&](const DoubleCyclide& d) {
          return flaw({d.first, d.second}, e).empty() ? bending_of(d)
                                                      : std::numeric_limits<double>::infinity();
        });
    return {CyclideChain{{std::move(sound.first), std::move(sound.second)}}, {}};
  } catch (const Error& error) {
    if (error.code() != Errc::infeasible_blend) {
      throw;
    }
    return {{}, first_flaw.empty() ? error.message() : first_flaw};
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

// Bending alone would prefer the widest detour; with this, a circle costs least whose radius is the
// size of the ends.
double cost(const CyclideChain& chain, const Ends& e) {
  double sum = 0;
  for (const PeArc& piece : chain.pieces) {
    sum += bending(piece) + pe_length(piece) / (size(e) * size(e));
  }
  return sum;
}

// The regular pieces to a first junction and from there, two.
std::optional<CyclideChain> through(const Ends& e, const PeVector& junction) {
  try {
    const PeArc first = PeArc::from(e.start, e.start_tangent, junction);
    const DoubleCyclide rest = double_cyclide(junction, first.end_tangent(), e.end, e.end_tangent);
    return CyclideChain{{first, rest.first, rest.second}};
  } catch (const Error& error) {
    if (error.code() != Errc::infeasible_blend) {
      throw;
    }
    return std::nullopt;
  }
}

// Axes that turn with the ends: along the start's, towards the end or, where that lies straight
// ahead, towards its axis; if all are on one line, no direction is better than another.
Eigen::Matrix3d axes(const Ends& e) {
  constexpr double kStraight = 0x1p-30;
  const Vec3 along = e.from.normal.normalized(), chord = e.end.m - e.start.m;
  const auto across = [&](const Vec3& v) -> Vec3 { return v - v.dot(along) * along; };
  Vec3 side = across(chord);
  if (side.norm() <= kStraight * size(e)) {
    side = across(e.to.normal.normalized());
    if (side.norm() <= kStraight) {
      side = along.unitOrthogonal();
    }
  }
  side.normalize();
  Eigen::Matrix3d result;
  result << side, along.cross(side), along;
  return result;
}

// A first junction anywhere around the ends; the cheapest of the first that are sound.
Attempt three(const Ends& e) {
  constexpr unsigned kCandidates = 192, kMostRegular = 64, kEnough = 8;
  unsigned tried = 0, regular = 0, sound = 0;
  std::optional<CyclideChain> best;
  const Vec3 middle = (e.start.m + e.end.m) / 2;
  const double reach = size(e);
  const Eigen::Matrix3d turned = axes(e);
  while (tried < kCandidates && regular < kMostRegular && sound < kEnough) {
    const unsigned i = ++tried;
    const Vec3 place(radical_inverse(i, 2), radical_inverse(i, 3), radical_inverse(i, 5));
    const double s = radical_inverse(i, 7);
    auto chain = through(e, {middle + turned * (reach * (2 * place - Vec3::Ones())),
                             (1 - s) * e.start.r + s * e.end.r});
    if (!chain) {
      continue;
    }
    ++regular;
    if (!flaw(chain->pieces, e).empty()) {
      continue;
    }
    ++sound;
    if (!best || cost(*chain, e) < cost(*best, e)) {
      best = std::move(chain);
    }
  }
  return {best, "of " + std::to_string(tried) + " first junctions that were tried, " +
                    std::to_string(regular) +
                    " lead to regular pieces, all of which cross themselves or the parts at the "
                    "ends, get too thin, all but fold or turn nearly all round"};
}

Ends ends_of(const Ring& from, const Ring& to) {
  validate(from);
  validate(to);
  if (from.ellipse || to.ellipse) {
    throw Error(Errc::invalid_argument,
                "cyclides join circles only; a cyclic_blend joins ellipses too");
  }
  const Ring arrival = flipped(to);
  return {contact_sphere(from),
          contact_tangent(from),
          contact_sphere(arrival),
          contact_tangent(arrival),
          from,
          arrival};
}

}  // namespace

CyclideSearch search_cyclide_blend(const Ring& from, const Ring& to) {
  const Ends ends = ends_of(from, to);
  struct Construction {
    const char* name;
    Attempt (*attempt)(const Ends&);
  };
  CyclideSearch result;
  for (const auto& [name, attempt] :
       {Construction{"single", single}, {"double", two}, {"triple", three}}) {
    Attempt found = attempt(ends);
    if (found.chain) {
      result.tube = cyclide_tube(*found.chain, flipped(from), ends.to);
      return result;
    }
    result.rejected.push_back(std::string(name) + ": " + found.reason);
  }
  return result;
}

Chain cyclide_blend(const Ring& from, const Ring& to) {
  CyclideSearch search = search_cyclide_blend(from, to);
  if (search.tube) {
    return std::move(*search.tube);
  }
  std::string reasons;
  for (const std::string& reason : search.rejected) {
    reasons += "; " + reason;
  }
  throw Error(
      Errc::infeasible_blend,
      "no chain of up to three cyclide pieces joins these ends; move them further apart, or "
      "use a cyclic_blend" +
          reasons);
}

}  // namespace dupin
