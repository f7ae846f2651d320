#include "arrangement/faces/face_outlines.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "arrangement/points/implicit_predicates.h"
#include "dupin/kernel/error.h"
#include "support/sequences.h"

namespace dupin::arrangement {
namespace {

/// Outlines with more corners are left to the triangulation of the whole face, which takes less.
constexpr std::size_t kMostCorners = 512;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

FaceOutlines::FaceOutlines(const ArrangementInput& input, const Constraints& constraints)
    : input_(input), constraints_(constraints), plane_(input.points, {}) {}

bool FaceOutlines::find(std::uint32_t triangle, const Projection& projection) {
  triangle_ = triangle;
  projection_ = projection;
  plane_.clear(projection);
  collect_outer_points();
  return collect_segments() && segments_keep_apart() && sort_around_points() && trace();
}

void FaceOutlines::collect_outer_points() {
  facet_ = constraints_.facets.corners(input_, triangle_);
  ids_.clear();
  sides_.clear();
  for (std::size_t i = 0; i < facet_.count; ++i) {
    const auto side = static_cast<std::uint8_t>(1U << i);
    corners_[i] = static_cast<Vertex>(ids_.size());
    ids_.push_back(facet_[i]);
    sides_.push_back(static_cast<std::uint8_t>(side | 1U << facet_.before(i)));
    const PointId to = facet_[facet_.after(i)];
    const auto points = constraints_.on_edge(edge_key(facet_[i], to));
    for (std::size_t k = 0; k < points.size(); ++k) {
      ids_.push_back(points[facet_[i] < to ? k : points.size() - 1 - k].point);
      sides_.push_back(side);
    }
  }
  outer_ = static_cast<std::uint32_t>(ids_.size());
}

std::uint32_t& FaceOutlines::slot_of(PointId id) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = id * std::size_t{0x9E3779B97F4A7C15U} >> 32 & mask;
  while (slots_[slot] != kNone && ids_[slots_[slot]] != id) {
    slot = (slot + 1) & mask;
  }
  return slots_[slot];
}

bool FaceOutlines::collect_segments() {
  const auto segments = constraints_.segments_of(triangle_);
  slots_.assign(std::bit_ceil(2 * (ids_.size() + 2 * segments.size())), kNone);
  for (Vertex v = 0; v < outer_; ++v) {
    std::uint32_t& slot = slot_of(ids_[v]);
    if (slot != kNone) {
      return false;
    }
    slot = v;
  }
  segments_.clear();
  for (const Constraints::Segment& s : segments) {
    Segment segment{};
    for (const std::size_t end : {0U, 1U}) {
      const PointId id = end == 0 ? s.from : s.to;
      std::uint32_t& slot = slot_of(id);
      if (slot == kNone) {
        slot = static_cast<Vertex>(ids_.size());
        ids_.push_back(id);
        sides_.push_back(0);
      }
      segment[end] = slot;
    }
    if ((sides_[segment[0]] & sides_[segment[1]]) != 0) {
      return false;  // along an edge
    }
    std::ranges::sort(segment);
    segments_.push_back(segment);
  }
  for (const Constraints::Inside& p : constraints_.inside(triangle_)) {
    if (slot_of(p.point) == kNone) {
      return false;
    }
  }
  support::sort_unique(segments_);
  for (std::size_t v = 0; v < ids_.size(); ++v) {
    plane_.add(ids_[v], sides_[v]);
  }
  return true;
}

bool FaceOutlines::segments_keep_apart() {
  boxes_.clear();
  for (std::uint32_t i = 0; i < segments_.size(); ++i) {
    const auto &a = plane_.intervals(segments_[i][0]), &b = plane_.intervals(segments_[i][1]);
    SegmentBox box{{}, {}, i};
    for (std::size_t k = 0; k < 2; ++k) {
      box.low[k] = std::min(a[k].inf(), b[k].inf());
      box.high[k] = std::max(a[k].sup(), b[k].sup());
      if (!(box.low[k] <= box.high[k])) {
        return false;  // no numbers
      }
    }
    boxes_.push_back(box);
  }
  const std::size_t x = thinner_axis(), y = 1 - x;
  std::ranges::sort(boxes_, {},
                    [=](const SegmentBox& box) { return std::pair(box.low[x], box.segment); });
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const SegmentBox& box = boxes_[i];
    for (std::size_t k = i + 1; k < boxes_.size() && boxes_[k].low[x] <= box.high[x]; ++k) {
      const SegmentBox& other = boxes_[k];
      if (other.low[y] <= box.high[y] && box.low[y] <= other.high[y] &&
          !keep_apart(segments_[box.segment], segments_[other.segment])) {
        return false;
      }
    }
  }
  return true;
}

// Along which the boxes are shorter as a part of the way along all of them: fewer of them are side
// by side. Segments across a long strip, as many as there are, all are along the other one.
std::size_t FaceOutlines::thinner_axis() const {
  std::array<double, 2> sum{};
  SegmentBox all{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}, 0};
  for (const SegmentBox& box : boxes_) {
    for (std::size_t k = 0; k < 2; ++k) {
      sum[k] += box.high[k] - box.low[k];
      all.low[k] = std::min(all.low[k], box.low[k]);
      all.high[k] = std::max(all.high[k], box.high[k]);
    }
  }
  return sum[1] * (all.high[0] - all.low[0]) < sum[0] * (all.high[1] - all.low[1]) ? 1 : 0;
}

// Whether they meet in a common end only. Those that run along each other from it are left to the
// order around it.
bool FaceOutlines::keep_apart(const Segment& s, const Segment& t) const {
  if (s[0] == t[0] || s[0] == t[1] || s[1] == t[0] || s[1] == t[1]) {
    return true;
  }
  const auto on_one_side = [&](const Segment& line, const Segment& other, const auto& turn) {
    const int first = (plane_.*turn)(line[0], line[1], other[0]);
    return first != 0 && first == (plane_.*turn)(line[0], line[1], other[1]);
  };
  const auto certain = &ConstrainedTriangulation::certain_turn;
  const auto exact = &ConstrainedTriangulation::turn;
  return on_one_side(s, t, certain) || on_one_side(t, s, certain) || on_one_side(s, t, exact) ||
         on_one_side(t, s, exact);
}

bool FaceOutlines::sort_around_points() {
  const auto count = static_cast<Vertex>(ids_.size());
  first_.assign(count + 1, 0);
  for (const Segment& segment : segments_) {
    ++first_[segment[0] + 1];
    ++first_[segment[1] + 1];
  }
  for (Vertex v = 0; v < count; ++v) {
    first_[v + 1] += first_[v];
  }
  out_.resize(first_[count]);
  seen_.assign(first_.begin(), first_.end() - 1);
  for (HalfEdge h = outer_; h < outer_ + 2 * segments_.size(); ++h) {
    out_[seen_[origin(h)]++] = h;
  }
  for (Vertex v = 0; v < count; ++v) {
    if (!sort_around(v)) {
      return false;
    }
  }
  return true;
}

// False if two run the same way, or a point inside ends one only.
bool FaceOutlines::sort_around(Vertex v) {
  const std::size_t begin = first_[v], end = first_[v + 1];
  if (v < outer_) {
    return sort_strictly(v, begin, end);
  }
  if (end - begin < 2) {
    return false;
  }
  const Vertex first = target(out_[begin]);
  if (end - begin == 2) {
    const Vertex second = target(out_[begin + 1]);
    return certainly_go_opposite_ways(v, first, second) ||
           plane_.certain_turn(v, first, second) != 0 || go_opposite_ways(v, first, second) ||
           plane_.turn(v, first, second) != 0;
  }
  // Those to the left of the first one come before those to its right.
  const auto at = out_.begin();
  const auto middle = std::partition(
      at + static_cast<std::ptrdiff_t>(begin) + 1, at + static_cast<std::ptrdiff_t>(end),
      [&](HalfEdge h) { return plane_.turn(v, first, target(h)) > 0; });
  const auto split = static_cast<std::size_t>(middle - at);
  for (std::size_t i = split; i < end; ++i) {
    if (plane_.turn(v, first, target(out_[i])) == 0) {
      return false;  // straight on among others: rare
    }
  }
  return sort_strictly(v, begin + 1, split) && sort_strictly(v, split, end);
}

// Of half-edges within half a turn.
bool FaceOutlines::sort_strictly(Vertex v, std::size_t begin, std::size_t end) {
  const auto turns_left = [&](HalfEdge a, HalfEdge b) {
    return plane_.turn(v, target(a), target(b)) > 0;
  };
  const std::span<HalfEdge> range = std::span(out_).subspan(begin, end - begin);
  std::ranges::sort(range, turns_left);
  return std::ranges::adjacent_find(range, std::not_fn(turns_left)) == range.end();
}

// Whether two points lie on different sides of a third along some axis, if intervals tell.
bool FaceOutlines::certainly_go_opposite_ways(Vertex v, Vertex first, Vertex second) const {
  for (std::size_t k = 0; k < 2; ++k) {
    const Interval &at = plane_.intervals(v)[k], &one = plane_.intervals(first)[k],
                   &other = plane_.intervals(second)[k];
    if ((one.sup() < at.inf() && at.sup() < other.inf()) ||
        (other.sup() < at.inf() && at.sup() < one.inf())) {
      return true;
    }
  }
  return false;
}

// The same, exactly.
bool FaceOutlines::go_opposite_ways(Vertex v, Vertex first, Vertex second) const {
  for (const int axis : {(projection_.axis + 1) % 3, (projection_.axis + 2) % 3}) {
    if (compare(input_.points, ids_[first], ids_[v], axis) *
            compare(input_.points, ids_[second], ids_[v], axis) <
        0) {
      return true;
    }
  }
  return false;
}

// Having come by the reverse of one half-edge, an outline goes on by the next one clockwise.
void FaceOutlines::link_half_edges() {
  onward_.resize(outer_ + 2 * segments_.size());
  for (Vertex v = 0; v < ids_.size(); ++v) {
    const std::uint32_t begin = first_[v], end = first_[v + 1];
    for (std::uint32_t i = begin; i < end; ++i) {
      const HalfEdge arriving = ((out_[i] - outer_) ^ 1U) + outer_;
      onward_[arriving] = i > begin ? out_[i - 1] : v < outer_ ? v : out_[end - 1];
    }
    if (v < outer_) {
      onward_[v == 0 ? outer_ - 1 : v - 1] = end > begin ? out_[end - 1] : v;
    }
  }
}

// A connected plane graph of n points and m edges has m - n + 1 bounded regions. Of c parts, each
// but the one with the facet's sides has an outside that is traced as well, and there are c - 1
// more regions: as many outlines as that only if all hangs together.
bool FaceOutlines::trace() {
  link_half_edges();
  traced_.clear();
  first_traced_.assign(1, 0);
  outline_of_.assign(onward_.size(), 0);
  seen_.assign(ids_.size(), 0);
  for (HalfEdge start = 0; start < onward_.size(); ++start) {
    if (outline_of_[start] != 0) {
      continue;
    }
    const auto number = static_cast<std::uint32_t>(first_traced_.size());
    for (HalfEdge h = start; outline_of_[h] == 0; h = onward_[h]) {
      const Vertex v = origin(h);
      if (seen_[v] == number) {
        return false;  // it touches itself
      }
      seen_[v] = outline_of_[h] = number;
      traced_.push_back(h);
    }
    const std::size_t corners = traced_.size() - first_traced_.back();
    if (corners < 3 || corners > kMostCorners) {
      return false;
    }
    first_traced_.push_back(static_cast<std::uint32_t>(traced_.size()));
  }
  return first_traced_.size() + ids_.size() == outer_ + segments_.size() + 2;
}

// Some corner of the facet on that side of the half-edge's line.
PointId FaceOutlines::point_to_the_left(HalfEdge h) const {
  if (h < outer_) {
    std::size_t side = facet_.count - 1;
    while (h < corners_[side]) {
      --side;
    }
    return facet_[facet_.before(side)];
  }
  for (std::size_t i = 0; i < facet_.count; ++i) {
    if (plane_.certain_turn(origin(h), target(h), corners_[i]) > 0) {
      return facet_[i];
    }
  }
  return point_beside_partner(h);
}

// The same by the plane that the segment comes from: where its ends all but coincide, that says
// more of its direction than they do. n the facet's normal and m the partner's, what lies to the
// left of n x m, n x (n x m), has the product (n . m)^2 - n^2 m^2 < 0 with m: it is behind.
PointId FaceOutlines::point_beside_partner(HalfEdge h) const {
  const PointId from = ids_[origin(h)], to = ids_[target(h)];
  for (const Constraints::Segment& s : constraints_.segments_of(triangle_)) {
    const bool is_along = s.from == from && s.to == to;
    if (!is_along && !(s.from == to && s.to == from)) {
      continue;
    }
    const int side = is_along == (triangle_ < s.partner) ? -1 : 1;
    const auto& [a, b, c] = input_.support(s.partner);
    const PlaneSides sides(input_.points, a, b, c);
    for (const PointId corner : facet_.all()) {
      if (sides.of(corner) == side) {
        return corner;
      }
    }
  }
  throw Error(Errc::internal, "internal error, please report it: a segment outside its face");
}

void FaceOutlines::append(std::size_t covers, Subdivision& subdivision) const {
  const auto end_cover = static_cast<std::uint32_t>(subdivision.covers.size());
  const auto first_cover = static_cast<std::uint32_t>(subdivision.covers.size() - covers);
  for (std::size_t i = 0; i + 1 < first_traced_.size(); ++i) {
    const auto begin = static_cast<std::uint32_t>(subdivision.outline_corners.size());
    for (std::uint32_t k = first_traced_[i]; k < first_traced_[i + 1]; ++k) {
      const Vertex from = origin(traced_[k]);
      subdivision.outline_corners.push_back(
          {ids_[from], point_to_the_left(traced_[k]), sides_[from]});
    }
    subdivision.outlines.push_back(
        {static_cast<std::uint32_t>(subdivision.regions.size()), begin,
         static_cast<std::uint32_t>(subdivision.outline_corners.size())});
    subdivision.regions.push_back({first_cover, end_cover, triangle_});
  }
}

OutlineTriangulator::OutlineTriangulator(const ArrangementInput& input)
    : input_(input), triangulation_(input.points, {}) {}

void OutlineTriangulator::append(const Subdivision& subdivision,
                                 const Subdivision::Outline& outline,
                                 std::vector<Subdivision::SubTriangle>& triangles) {
  const auto corners =
      std::span(subdivision.outline_corners).subspan(outline.begin, outline.end - outline.begin);
  if (corners.size() == 3) {
    triangles.push_back(
        {{corners[0].point, corners[1].point, corners[2].point}, outline.region, 7});
    return;
  }
  const Triangle& support = input_.support(subdivision.regions[outline.region].support);
  triangulation_.clear(projection_of(input_.points, support));
  for (const Subdivision::OutlineCorner& corner : corners) {
    triangulation_.add(corner.point, corner.sides);
  }
  cut_ears();
  triangulation_.start(ears_);
  triangulation_.improve(support);
  for (const ConstrainedTriangulation::Face& face : triangulation_.faces()) {
    Subdivision::SubTriangle triangle{{}, outline.region, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.corners[k] = triangulation_.point(face.corners[k]);
      triangle.open |= static_cast<std::uint8_t>((face.neighbours[k] == kNone ? 1U : 0U) << k);
    }
    triangles.push_back(triangle);
  }
}

// A polygon that is not a triangle has an ear: a convex corner v with no other one in or on its
// triangle. Corners that do not turn left suffice as others, since some such one lies there if any
// does. Cutting an ear off leaves convex corners convex.
void OutlineTriangulator::cut_ears() {
  exactly_ = false;
  ears_.clear();
  corners_.clear();
  const auto count = static_cast<Vertex>(triangulation_.vertex_count());
  for (Vertex v = 0; v < count; ++v) {
    const Vertex before = v == 0 ? count - 1 : v - 1, after = v + 1 == count ? 0 : v + 1;
    corners_.push_back({before, after, turn(before, v, after) > 0});
  }
  Vertex v = 0;
  for (Vertex left = count; left > 3; --left) {
    v = next_ear(v);
    const Vertex a = corners_[v].previous, c = corners_[v].next;
    ears_.push_back({a, v, c});
    corners_[a].next = c;
    corners_[c].previous = a;
    for (const Vertex w : {a, c}) {
      corners_[w].is_convex =
          corners_[w].is_convex || turn(corners_[w].previous, w, corners_[w].next) > 0;
    }
    v = corners_[c].next;  // not one ear next to the other, for better shapes
  }
  ears_.push_back({corners_[v].previous, v, corners_[v].next});
}

bool OutlineTriangulator::is_ear(Vertex v) const {
  const auto& [a, c, is_convex] = corners_[v];
  if (!is_convex) {
    return false;
  }
  for (Vertex w = corners_[c].next; w != a; w = corners_[w].next) {
    if (!corners_[w].is_convex && turn(c, a, w) >= 0 && turn(a, v, w) >= 0 && turn(v, c, w) >= 0) {
      return false;
    }
  }
  return true;
}

// From `first` on.
OutlineTriangulator::Vertex OutlineTriangulator::next_ear(Vertex first) {
  while (true) {
    Vertex v = first;
    do {
      if (is_ear(v)) {
        return v;
      }
      v = corners_[v].next;
    } while (v != first);
    if (exactly_) {
      throw Error(Errc::internal, "internal error, please report it: a polygon without an ear");
    }
    exactly_ = true;
    do {
      corners_[v].is_convex = turn(corners_[v].previous, v, corners_[v].next) > 0;
      v = corners_[v].next;
    } while (v != first);
  }
}

}  // namespace dupin::arrangement
