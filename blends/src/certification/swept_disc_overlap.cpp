#include "certification/swept_disc_overlap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "curves/exact_spine.h"

namespace dupin::certification {
namespace {

double height(const DiscHull& disc, const Vec3& point) {
  return disc.tangents.empty() ? 0
                               : numbers::dot(numbers::interval_vec(point) - disc.centers.front(),
                                              disc.tangents.front())
                                     .lower;
}

// Whether the point is proven to lie inside a disc of the stretch.
bool crosses(const SweptDiscs& sweep, const ParameterInterval& t, const Vec3& point) {
  const DiscHull discs = sweep.over(t), first = sweep.over({t.from, t.from}),
                 last = sweep.over({t.to, t.to});
  const numbers::IntervalVec p = numbers::interval_vec(point);
  const bool passes = discs.tangents.empty() ||
                      (numbers::dot(p - first.centers.front(), first.tangents.front()).lower > 0 &&
                       numbers::dot(p - last.centers.back(), last.tangents.back()).upper < 0);
  return passes &&
         std::all_of(
             discs.centers.begin(), discs.centers.end(), [&](const numbers::IntervalVec& center) {
               return numbers::norm(p - center).upper < discs.radius.lower * (1 - kDiscSlack);
             });
}

// The stretches in which the planes of discs are thought to pass the point, made short.
std::vector<ParameterInterval> crossings(const SweptDiscs& sweep, const Vec3& point) {
  constexpr int kStretches = 64, kHalvings = 12;
  if (sweep.over({0, 1}).tangents.empty()) {
    return {{0, 1}};
  }
  std::vector<ParameterInterval> result;
  for (const ParameterInterval& piece : sweep.stretches()) {
    const auto height_at = [&](double t) { return height(sweep.over({t, t}), point); };
    double before = height_at(piece.from);
    for (int i = 0; i < kStretches; ++i) {
      ParameterInterval t{piece.from + double(i) / kStretches,
                          piece.from + double(i + 1) / kStretches};
      const double after = height_at(t.to);
      if (before > 0 && after <= 0) {
        for (int k = 0; k < kHalvings; ++k) {
          const auto [left, right] = halves(t);
          t = height_at(left.to) <= 0 ? left : right;
        }
        result.push_back(
            {std::max(piece.from, t.from - size(t)), std::min(piece.to, t.to + size(t))});
      }
      before = after;
    }
  }
  return result;
}

// Points of some discs, tried on all others.
std::optional<Overlap> overlap(const SweptDiscs& a, const SweptDiscs& b, bool same) {
  constexpr int kDiscs = 24, kAngles = 8;
  if (!a.full() || !b.full()) {
    return std::nullopt;
  }
  for (int i = 0; i < kDiscs * int(a.length()); ++i) {
    const double t = (i + 0.5) / kDiscs;
    const ParameterInterval around{t - 0x1p-16, t + 0x1p-16};
    const DiscHull disc = a.over(around);
    const Vec3 axis = disc.tangents.empty() ? Vec3::UnitZ() : disc.axis;
    const Vec3 across = axis.unitOrthogonal();
    for (int k = 0; k < 2 * kAngles + 1; ++k) {
      const double angle = 2 * std::numbers::pi * k / kAngles;
      const double reach = disc.radius.lower * (k == 0 ? 0 : k <= kAngles ? 0.5 : 0.9);
      const Vec3 point =
          disc.middle() + reach * (std::cos(angle) * across + std::sin(angle) * axis.cross(across));
      if (!crosses(a, around, point)) {
        continue;
      }
      for (const ParameterInterval& other : crossings(b, point)) {
        const bool own = same && other.from <= around.to && around.from <= other.to;
        if (!own && crosses(b, other, point)) {
          return Overlap{point, around, other};
        }
      }
    }
  }
  return std::nullopt;
}

// Exactly, border included.
bool lies_in(const Ring& ring, const Vec3& point) {
  const numbers::ExactVec3 d = numbers::exact(point) - numbers::exact(ring.center);
  const mpq_class radius = ring.radius;
  return !ring.ellipse && dot(d, numbers::exact(ring.normal)) == 0 && dot(d, d) <= radius * radius;
}

}  // namespace

std::optional<Overlap> self_overlap(const SweptDiscs& sweep) { return overlap(sweep, sweep, true); }

// Centres of end rings that lie in an end ring of the other part.
std::optional<Overlap> contact(const SweptDiscs& a, const SweptDiscs& b) {
  if (!a.full() || !b.full()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < a.end_rings().size(); ++i) {
    for (std::size_t j = 0; j < b.end_rings().size(); ++j) {
      const Ring &first = a.end_rings()[i], &second = b.end_rings()[j];
      const double s = i == 0 ? 0 : a.length(), t = j == 0 ? 0 : b.length();
      for (const Vec3& point : {first.center, second.center}) {
        if (lies_in(first, point) && lies_in(second, point)) {
          return Overlap{point, {s, s}, {t, t}};
        }
      }
    }
  }
  return std::nullopt;
}

// Points of either part, tried on the other.
std::optional<Overlap> overlap(const SweptDiscs& a, const SweptDiscs& b) {
  auto result = overlap(a, b, false);
  if (!result) {
    result = overlap(b, a, false);
    if (result) {
      std::swap(result->first, result->second);
    }
  }
  return result;
}

}  // namespace dupin::certification
