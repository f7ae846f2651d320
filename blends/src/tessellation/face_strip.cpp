#include "tessellation/face_strip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dupin/kernel/error.h"
#include "tessellation/refined_region.h"

namespace dupin::tessellation {
namespace {

constexpr double kNear = 1e-9;  // of a segment

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Nothing here needs to be exact: what is wrong is refused when it is triangulated.
bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto differ = [](double x, double y) { return !(x * y > 0); };
  return differ(cross(b - a, c - a), cross(b - a, d - a)) &&
         differ(cross(d - c, a - c), cross(d - c, b - c));
}

// The least sine between a direction and the curve at one of its corners.
double steepness(const UnrolledCurve& curve, std::size_t corner, const Vec2& direction,
                 double around) {
  double least = 1;
  for (const std::size_t other : {corner + 1, corner + curve.places.size() - 1}) {
    Vec2 side = curve.places[other % curve.places.size()] - curve.places[corner];
    side.x() = std::remainder(side.x(), around);
    least = std::min(least, std::abs(cross(side, direction)) / (side.norm() * direction.norm()));
  }
  return least;
}

}  // namespace

bool FaceStrip::contains(const UnrolledCurve& hole) const {
  const Vec2& place = hole.places[inner_corner(hole)];
  return is_below(lower_, place) && !is_below(upper_, place);
}

// One that the hole has to itself: on a common one it is on neither side of the curves.
std::size_t FaceStrip::inner_corner(const UnrolledCurve& hole) const {
  const auto is_own = [&](std::uint32_t corner) {
    return std::ranges::find(lower_.corners, corner) == lower_.corners.end() &&
           std::ranges::find(upper_.corners, corner) == upper_.corners.end();
  };
  const auto own = std::ranges::find_if(hole.corners, is_own);
  return own == hole.corners.end() ? 0 : std::size_t(own - hole.corners.begin());
}

void FaceStrip::append_triangles(std::vector<Triangle>& triangles, const NewCorner& new_corner) {
  find_cut();
  append_outline(new_corner);
  for (const UnrolledCurve* hole : holes_) {
    append_hole(*hole);
  }
  const RefinedRegion region = refined_region(places_, polygons_);
  for (std::size_t i = places_.size(); i < region.points.size(); ++i) {
    corners_.push_back(new_corner(region.points[i]));
  }
  for (const Triangle& t : region.triangles) {
    triangles.push_back({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
  }
}

// Whether a ray from the place downwards crosses the curve an odd number of times. A corner has one
// x for both of its sides, and belongs to one half of the turn: no side is counted twice, or not at
// all, however the x are rounded.
bool FaceStrip::is_below(const UnrolledCurve& curve, const Vec2& place) const {
  bool below = false;
  for_each_side(curve, place.x(), [&](const Vec2& a, const Vec2& b) {
    const bool crosses = (a.x() <= 0) != (b.x() <= 0);
    if (crosses && std::abs(b.x() - a.x()) <= around_ / 2) {
      const double share = -a.x() / (b.x() - a.x());
      below ^= a.y() + share * (b.y() - a.y()) < place.y();
    }
  });
  return below;
}

// Sides by how far around their corners are from x, within half a turn either way: those opposite
// to x go from one end of this to the other.
template <class Visit>
void FaceStrip::for_each_side(const UnrolledCurve& curve, double x, const Visit& visit) const {
  const auto beside = [&](const Vec2& p) {
    return Vec2(std::remainder(p.x() - x, around_), p.y());
  };
  Vec2 a = beside(curve.places.back());
  for (const Vec2& place : curve.places) {
    const Vec2 b = beside(place);
    visit(a, b);
    a = b;
  }
}

bool FaceStrip::is_crossed(const Vec2& from, const Vec2& to) const {
  bool crossed = false;
  const Vec2 origin(0, from.y()), end(to.x() - from.x(), to.y());
  const auto visit = [&](const Vec2& a, const Vec2& b) {
    const auto is_end = [&](const Vec2& p) {
      return (p - origin).cwiseAbs().maxCoeff() < kNear || (p - end).cwiseAbs().maxCoeff() < kNear;
    };
    const bool is_opposite = std::abs(b.x() - a.x()) > around_ / 2;
    crossed = crossed ||
              (!is_opposite && !is_end(a) && !is_end(b) && cross_each_other(origin, end, a, b));
  };
  for_each_side(lower_, from.x(), visit);
  for_each_side(upper_, from.x(), visit);
  for (const UnrolledCurve* hole : holes_) {
    for_each_side(*hole, from.x(), visit);
  }
  return crossed;
}

// How far, around, the nearest corner of a hole is, if less than this.
double FaceStrip::clearance_of_holes(double x) const {
  double least = 2;
  for (const UnrolledCurve* hole : holes_) {
    for (const Vec2& place : hole->places) {
      least = std::min(least, std::abs(std::remainder(place.x() - x, around_)));
    }
  }
  return least;
}

// From a corner below to that above which is nearest around: steep, away from holes, across the
// curves, and crossed by nothing.
void FaceStrip::find_cut() {
  struct Candidate {
    double merit;
    std::array<std::size_t, 2> cut;
    std::array<Vec2, 2> at;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < lower_.places.size(); ++i) {
    const Vec2& from = lower_.places[i];
    const auto aside = [&](const Vec2& p) { return std::remainder(p.x() - from.x(), around_); };
    const auto nearest = std::ranges::min_element(
        upper_.places, {}, [&](const Vec2& p) { return std::abs(aside(p)); });
    const double off = aside(*nearest);
    const Vec2 to(from.x() + off, nearest->y());
    if (to.y() > from.y()) {
      const auto above = std::size_t(nearest - upper_.places.begin());
      const double merit = clearance_of_holes(from.x()) / 2 - std::abs(off) +
                           std::min(steepness(lower_, i, to - from, around_),
                                    steepness(upper_, above, to - from, around_));
      candidates.push_back({merit, {i, above}, {from, to}});
    }
  }
  std::ranges::stable_sort(candidates, std::greater(), &Candidate::merit);
  const auto open = std::ranges::find_if(
      candidates, [&](const Candidate& c) { return !is_crossed(c.at[0], c.at[1]); });
  if (open == candidates.end()) {
    throw Error(Errc::self_intersecting, "no way was found between the curves on a tube's face");
  }
  cut_ = open->cut;
  cut_at_ = open->at;
}

std::uint32_t FaceStrip::add_corner(std::uint32_t corner, const Vec2& place) {
  corners_.push_back(corner);
  places_.push_back(place);
  return std::uint32_t(corners_.size() - 1);
}

// From a corner on to it again, which is there twice.
std::vector<std::uint32_t> FaceStrip::once_around(const UnrolledCurve& curve, std::size_t first,
                                                  double x) {
  std::vector<std::uint32_t> result;
  Vec2 place(x, 0);
  for (std::size_t i = 0; i <= curve.corners.size(); ++i) {
    const std::size_t at = (first + i) % curve.corners.size();
    place.y() = curve.places[at].y();
    if (i == curve.corners.size()) {
      place.x() = x + around_;
    } else {
      place.x() += std::remainder(curve.places[at].x() - place.x(), around_);
    }
    result.push_back(add_corner(curve.corners[at], place));
  }
  return result;
}

void FaceStrip::append_outline(const NewCorner& new_corner) {
  const auto below = once_around(lower_, cut_[0], cut_at_[0].x());
  auto above = once_around(upper_, cut_[1], cut_at_[1].x());
  const Vec2 along = cut_at_[1] - cut_at_[0];
  const auto parts = std::max<long>(1, std::lround(along.norm() / Refinement{}.spacing));
  std::vector<std::uint32_t> left, right;  // of the cut, upwards
  for (long i = 1; i < parts; ++i) {
    const Vec2 place = cut_at_[0] + double(i) / double(parts) * along;
    const std::uint32_t corner = new_corner(place);
    left.push_back(add_corner(corner, place));
    right.push_back(add_corner(corner, place + Vec2(around_, 0)));
  }
  std::vector<std::uint32_t> outline = below;
  outline.insert(outline.end(), right.begin(), right.end());
  outline.insert(outline.end(), above.rbegin(), above.rend());
  outline.insert(outline.end(), left.rbegin(), left.rend());
  polygons_.push_back(std::move(outline));
}

// The hole is between the cut and the cut a turn further on: told by the corner that is farthest
// from both.
void FaceStrip::append_hole(const UnrolledCurve& hole) {
  const auto from_cut = [&](const Vec2& place) {
    const double share = (place.y() - cut_at_[0].y()) / (cut_at_[1].y() - cut_at_[0].y());
    return place.x() - (cut_at_[0].x() + share * (cut_at_[1].x() - cut_at_[0].x()));
  };
  const auto clearance = [&](const Vec2& place) {
    return std::abs(std::remainder(from_cut(place), around_));
  };
  const Vec2& farthest = *std::ranges::max_element(hole.places, {}, clearance);
  const double shift = -around_ * std::floor(from_cut(farthest) / around_);
  std::vector<std::uint32_t> polygon;
  for (std::size_t i = 0; i < hole.corners.size(); ++i) {
    const auto [entry, is_new] =
        in_hole_.try_emplace(hole.corners[i], std::uint32_t(corners_.size()));
    if (is_new) {
      add_corner(hole.corners[i], hole.places[i] + Vec2(shift, 0));
    }
    polygon.push_back(entry->second);
  }
  polygons_.push_back(std::move(polygon));
}

void append_band(const UnrolledCurve& lower, const UnrolledCurve& upper, double around,
                 std::vector<Triangle>& triangles) {
  const auto aside = [&](const Vec2& p) {
    return std::remainder(p.x() - lower.places.front().x(), around);
  };
  const auto nearest =
      std::ranges::min_element(upper.places, {}, [&](const Vec2& p) { return std::abs(aside(p)); });
  const auto first = std::size_t(nearest - upper.places.begin()), count = lower.corners.size();
  const bool leans_on = aside(*nearest) >= 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t a = lower.corners[i], b = lower.corners[(i + 1) % count],
                        c = upper.corners[(first + i + 1) % count],
                        d = upper.corners[(first + i) % count];
    triangles.push_back(leans_on ? Triangle{a, b, d} : Triangle{a, b, c});
    triangles.push_back(leans_on ? Triangle{b, c, d} : Triangle{a, c, d});
  }
}

}  // namespace dupin::tessellation
