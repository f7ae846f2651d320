#include "tessellation/face_strip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "dupin/kernel/error.h"
#include "tessellation/plane_segments.h"
#include "tessellation/refined_region.h"
#include "tessellation/shortest_way.h"

namespace dupin::tessellation {
namespace {

constexpr double kNear = 1e-9;  // of a segment

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

// The sides of an outline by columns across the axis, of which a ray along the axis looks at one.
class FaceStrip::OutlineColumns {
 public:
  OutlineColumns(const std::vector<std::uint32_t>& outline, const std::vector<Vec2>& places,
                 double around)
      : width_(around / kColumns) {
    Vec2 a = places[outline.back()];
    for (const std::uint32_t corner : outline) {
      const Vec2& b = places[corner];
      const auto [left, right] = std::minmax({a.x(), b.x()});
      for (double column = column_of(left); column <= column_of(right); ++column) {
        columns_[column].push_back({a, b});
      }
      a = b;
    }
  }

  [[nodiscard]] bool contain(const Vec2& place) const {
    bool inside = false;
    const auto column = columns_.find(column_of(place.x()));
    if (column == columns_.end()) {
      return false;
    }
    for (const auto& [a, b] : column->second) {
      if ((a.x() <= place.x()) != (b.x() <= place.x())) {
        const double share = (place.x() - a.x()) / (b.x() - a.x());
        inside ^= a.y() + share * (b.y() - a.y()) < place.y();
      }
    }
    return inside;
  }

 private:
  static constexpr double kColumns = 256;  // of a turn

  [[nodiscard]] double column_of(double x) const { return std::floor(x / width_); }

  double width_;
  std::map<double, std::vector<std::array<Vec2, 2>>> columns_;
};

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

// What is between two such would be a piece of the face by itself. Those that cross are refused
// later, so that all corners are inside, or none; on the border they may seem to be either.
void FaceStrip::refuse_nested() const {
  const auto is_inside = [this](const UnrolledCurve& hole, const UnrolledCurve& other) {
    return &hole != &other && other.low <= hole.low && hole.high <= other.high &&
           std::ranges::all_of(hole.places,
                               [&](const Vec2& place) { return is_below(other, place); });
  };
  for (const UnrolledCurve* hole : holes_) {
    if (std::ranges::any_of(holes_, [&](const auto* other) { return is_inside(*hole, *other); })) {
      throw Error(Errc::self_intersecting, "a curve on a tube's face lies inside another one");
    }
  }
}

void FaceStrip::append_triangles(std::vector<Triangle>& triangles, const NewCorner& new_corner) {
  refuse_nested();
  find_cut();
  append_outline(new_corner);
  const OutlineColumns outline(polygons_.front(), places_, around_);
  for (const UnrolledCurve* hole : holes_) {
    append_hole(*hole, outline);
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
  const Vec2 origin(0, from.y()), end(to.x() - from.x(), to.y());
  const auto is_end = [&](const Vec2& p) {
    return (p - origin).cwiseAbs().maxCoeff() < kNear || (p - end).cwiseAbs().maxCoeff() < kNear;
  };
  const auto [low, high] = std::minmax({from.y(), to.y()});
  const auto is_crossed_by = [&, low = low, high = high](const UnrolledCurve& curve) {
    bool crossed = false;
    if (curve.low <= high && low <= curve.high) {
      for_each_side(curve, from.x(), [&](const Vec2& a, const Vec2& b) {
        const bool is_opposite = std::abs(b.x() - a.x()) > around_ / 2;
        crossed = crossed ||
                  (!is_opposite && !is_end(a) && !is_end(b) && cross_each_other(origin, end, a, b));
      });
    }
    return crossed;
  };
  return is_crossed_by(lower_) || is_crossed_by(upper_) ||
         std::ranges::any_of(holes_, [&](const auto* hole) { return is_crossed_by(*hole); });
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
bool FaceStrip::find_straight_cut() {
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
    return false;
  }
  cut_ = open->cut;
  cut_at_ = open->at;
  return true;
}

void FaceStrip::find_cut() {
  if (!find_straight_cut() && !find_cut_through_holes()) {
    throw Error(Errc::self_intersecting, "no way was found between the curves on a tube's face");
  }
}

// Between corners that are nearest, unless something is in between: then other curves are nearer.
// Curves that touch bound the face together: a step between them would tear it in two.
std::optional<FaceStrip::Step> FaceStrip::shortest_step(const UnrolledCurve& from,
                                                        const UnrolledCurve& to,
                                                        std::optional<std::size_t> not_from) const {
  Step step{0, 0, Vec2::Zero()};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < from.places.size(); ++i) {
    for (std::size_t k = 0; k < to.places.size(); ++k) {
      if (from.corners[i] == to.corners[k]) {
        return std::nullopt;
      }
      Vec2 along = to.places[k] - from.places[i];
      along.x() = std::remainder(along.x(), around_);
      if (along.squaredNorm() < least && i != not_from) {
        least = along.squaredNorm();
        step = {i, k, along};
      }
    }
  }
  const Vec2& at = from.places[step.from];
  return is_crossed(at, at + step.along) ? std::nullopt : std::optional(step);
}

bool FaceStrip::find_cut_through_holes() {
  std::vector<const UnrolledCurve*> curves{&lower_, &upper_};
  curves.insert(curves.end(), holes_.begin(), holes_.end());
  std::vector<HeightRange> heights;
  for (const UnrolledCurve* curve : curves) {
    heights.push_back({curve->low, curve->high});
  }
  const UnrolledCurve* at = &lower_;
  std::optional<std::size_t> in;  // where it was come to
  const auto way = shortest_way(heights, [&](std::size_t from, std::size_t to) {
    const auto step = shortest_step(*curves[from], *curves[to], std::nullopt);
    return step ? std::optional(step->along.norm()) : std::nullopt;
  });
  for (const std::size_t next : way) {
    const auto step = shortest_step(*at, *curves[next], in);
    if (!step) {
      return false;
    }
    if (in) {
      via_.push_back({at, *in, step->from});
    } else {
      cut_[0] = step->from;
      cut_at_[0] = lower_.places[step->from];
    }
    at = curves[next];
    in = step->to;
  }
  cut_[1] = in.value_or(0);
  return in.has_value();
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

// On both sides of the cut: where it ends.
Vec2 FaceStrip::append_step(const Vec2& from, const Vec2& to, const NewCorner& new_corner,
                            CutSides& sides) {
  const Vec2 along = to - from;
  const auto parts = std::max<long>(1, std::lround(along.norm() / Refinement{}.spacing));
  for (long i = 1; i < parts; ++i) {
    const Vec2 place = from + double(i) / double(parts) * along;
    const std::uint32_t corner = new_corner(place);
    sides.left.push_back(add_corner(corner, place));
    sides.right.push_back(add_corner(corner, place + Vec2(around_, 0)));
  }
  return to;
}

// To the right of the cut is what is on its left side, and the sides of a hole that are to the
// right of the way through it.
void FaceStrip::append_via(const Via& via, const Vec2& place, CutSides& sides) {
  const auto& [hole, in, out] = via;
  const std::size_t count = hole->corners.size();
  const bool turns_left = twice_area(*hole) > 0;
  for (const bool is_left : {true, false}) {
    const Vec2 shift = place - hole->places[in] + Vec2(is_left ? 0 : around_, 0);
    auto& side = is_left ? sides.left : sides.right;
    const std::size_t step = is_left == turns_left ? 1 : count - 1;
    for (std::size_t i = in;; i = (i + step) % count) {
      side.push_back(add_hole_corner(hole->corners[i], hole->places[i] + shift));
      if (i == out) {
        break;
      }
    }
  }
}

void FaceStrip::append_outline(const NewCorner& new_corner) {
  const auto below = once_around(lower_, cut_[0], cut_at_[0].x());
  CutSides sides;
  Vec2 at = cut_at_[0];
  const auto beside = [&](const Vec2& place) {
    return Vec2(at.x() + std::remainder(place.x() - at.x(), around_), place.y());
  };
  for (const Via& via : via_) {
    at = append_step(at, beside(via.hole->places[via.in]), new_corner, sides);
    append_via(via, at, sides);
    at += via.hole->places[via.out] - via.hole->places[via.in];
  }
  cut_at_[1] = append_step(at, beside(upper_.places[cut_[1]]), new_corner, sides);
  const auto above = once_around(upper_, cut_[1], cut_at_[1].x());
  std::vector<std::uint32_t> outline = below;
  outline.insert(outline.end(), sides.right.begin(), sides.right.end());
  outline.insert(outline.end(), above.rbegin(), above.rend());
  outline.insert(outline.end(), sides.left.rbegin(), sides.left.rend());
  polygons_.push_back(std::move(outline));
}

// By which its places are inside: most of them, as they are rounded.
double FaceStrip::turns_into_outline(const UnrolledCurve& hole,
                                     const OutlineColumns& outline) const {
  const double first = std::round((cut_at_[0].x() - hole.places.front().x()) / around_);
  double turns = first;
  std::ptrdiff_t most = 0;
  for (double tried = first - 2; tried <= first + 3; ++tried) {
    const auto inside = std::ranges::count_if(hole.places, [&](const Vec2& place) {
      return outline.contain(place + Vec2(tried * around_, 0));
    });
    turns = inside > most ? tried : turns;
    most = std::max(most, inside);
  }
  return turns;
}

std::uint32_t FaceStrip::add_hole_corner(std::uint32_t corner, const Vec2& place) {
  const auto [first, last] = in_hole_.equal_range(corner);
  const auto known = std::find_if(first, last, [&](const auto& entry) {
    return std::abs(places_[entry.second].x() - place.x()) < around_ / 2;
  });
  if (known != last) {
    return known->second;
  }
  const std::uint32_t added = add_corner(corner, place);
  in_hole_.emplace(corner, added);
  return added;
}

// One that is not cut is between the cut and the cut a turn further on.
void FaceStrip::append_hole(const UnrolledCurve& hole, const OutlineColumns& outline) {
  if (std::ranges::any_of(via_, [&](const Via& via) { return via.hole == &hole; })) {
    return;
  }
  const Vec2 shift(turns_into_outline(hole, outline) * around_, 0);
  std::vector<std::uint32_t> polygon;
  for (std::size_t i = 0; i < hole.corners.size(); ++i) {
    polygon.push_back(add_hole_corner(hole.corners[i], hole.places[i] + shift));
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
