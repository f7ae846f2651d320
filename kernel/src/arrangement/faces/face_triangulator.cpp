#include "arrangement/faces/face_triangulator.h"

#include <algorithm>

#include "arrangement/points/implicit_predicates.h"
#include "arrangement/triangle_intersection.h"
#include "dupin/kernel/error.h"
#include "support/disjoint_sets.h"

namespace dupin::arrangement {
namespace {

// Adds the members that are not there, and removes those that are.
std::vector<std::uint32_t> toggled(std::vector<std::uint32_t> cover,
                                   const std::vector<std::uint32_t>& members) {
  for (const std::uint32_t t : members) {
    const auto at = std::lower_bound(cover.begin(), cover.end(), t);
    if (at != cover.end() && *at == t) {
      cover.erase(at);
    } else {
      cover.insert(at, t);
    }
  }
  return cover;
}

}  // namespace

FaceTriangulator::FaceTriangulator(const ArrangementInput& input, const BooleanRule& rule,
                                   const Constraints& constraints)
    : input_(input),
      rule_(rule),
      constraints_(constraints),
      outlines_(input, constraints),
      triangulation_(input.points,
                     {[this](std::uint32_t a, std::uint32_t b) { return crossing(a, b); },
                      [this](std::uint32_t a, std::uint32_t b) { return both(a, b); }}) {}

void FaceTriangulator::append(std::span<const std::uint32_t> members, FaceSubdivision& result) {
  members_ = members;
  projection_ = projection_of(input_.points, input_.support(members[0]));
  const bool is_single = members.size() == 1;
  if (is_single && outlines_.find(members[0], projection_)) {
    emit_single(result, [&](std::size_t covers) { outlines_.append(covers, result.local); });
    return;
  }
  triangulation_.clear(projection_);
  slots_.clear();
  collect_points();
  collect_lines();
  if (is_single) {
    start_from_facet();
  } else {
    start_from_frame();
  }
  constrain_segments();
  triangulation_.improve(input_.support(members[0]));
  find_regions();
  if (is_single) {
    emit_single(result, [&](std::size_t covers) { emit_regions(covers, result); });
  } else {
    emit_overlapping(result);
  }
  std::vector<ConstrainedTriangulation::NewPoint>& points = triangulation_.new_points();
  std::move(points.begin(), points.end(), std::back_inserter(result.new_points));
}

ImplicitPoint FaceTriangulator::crossing(std::uint32_t a, std::uint32_t b) const {
  std::array<std::uint32_t, 3> planes{members_[0], slots_[a].partner, slots_[b].partner};
  std::sort(planes.begin(), planes.end());
  ImplicitPoint definition{ImplicitPoint::Kind::three_planes, 0, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Triangle& support = input_.support(planes[i]);
    std::copy(support.begin(), support.end(), definition.of.begin() + static_cast<long>(3 * i));
  }
  return definition;
}

std::uint32_t FaceTriangulator::both(std::uint32_t present, std::uint32_t added) {
  if (slots_[added].bounding.empty() && slots_[present].partner != kNone) {
    return present;
  }
  Slot slot{std::min(slots_[present].partner, slots_[added].partner), slots_[present].bounding};
  slot.bounding.insert(slot.bounding.end(), slots_[added].bounding.begin(),
                       slots_[added].bounding.end());
  slots_.push_back(std::move(slot));
  return last_slot();
}

void FaceTriangulator::collect_points() {
  ids_.clear();
  incidences_of_.clear();
  for (const std::uint32_t t : members_) {
    MemberIncidences& found = incidences_of_.emplace_back();
    found.corners = constraints_.facets.corners(input_, t);
    const FlatFacets::Corners& corners = found.corners;
    ids_.insert(ids_.end(), corners.all().begin(), corners.all().end());
    for (std::size_t i = 0; i < corners.count; ++i) {
      found.on_edges[i] = constraints_.on_edge(edge_key(corners[i], corners[corners.after(i)]));
      for (const auto& p : found.on_edges[i]) {
        ids_.push_back(p.point);
      }
    }
    found.insides = constraints_.inside(t);
    for (const auto& p : found.insides) {
      ids_.push_back(p.point);
    }
    found.segments = constraints_.segments_of(t);
    for (const auto& s : found.segments) {
      ids_.insert(ids_.end(), {s.from, s.to});
    }
  }
  std::sort(ids_.begin(), ids_.end());
  ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  vertices_.assign(ids_.size(), kNone);
}

std::size_t FaceTriangulator::index_of(PointId id) const {
  return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

// Sides of members, and where the planes of partners meet that of the face: segments of two that
// have the same support are in line.
void FaceTriangulator::collect_lines() {
  lines_.assign(ids_.size(), 0);
  Lines next = 1;
  const auto lies_on = [this](PointId id, Lines line) { lines_[index_of(id)] |= line; };
  for (const auto& [corners, on_edges, insides, segments] : incidences_of_) {
    for (std::size_t i = 0; i < corners.count; ++i, next <<= 1) {
      lies_on(corners[i], next);
      lies_on(corners[corners.after(i)], next);
      for (const auto& p : on_edges[i]) {
        lies_on(p.point, next);
      }
    }
  }
  planes_.clear();
  for (const MemberIncidences& found : incidences_of_) {
    for (const Constraints::Segment& s : found.segments) {
      const Lines line = line_in_plane_of(s.partner, next);
      lies_on(s.from, line);
      lies_on(s.to, line);
    }
  }
}

// `next` is the first one not yet taken, or 0 if all are. A partner lies in another plane, as its
// segments come from two that cross.
FaceTriangulator::Lines FaceTriangulator::line_in_plane_of(std::uint32_t partner, Lines& next) {
  const Triangle& support = input_.support(partner);
  const auto known = std::ranges::find(planes_, support, &std::pair<Triangle, Lines>::first);
  if (known != planes_.end()) {
    return known->second;
  }
  if (next != 0) {
    planes_.emplace_back(support, next);
    next <<= 1;
    return planes_.back().second;
  }
  return 0;
}

void FaceTriangulator::insert(PointId id) {
  const std::size_t i = index_of(id);
  if (vertices_[i] == kNone) {
    vertices_[i] = triangulation_.add(id, lines_[i]);
    triangulation_.insert(vertices_[i]);
  }
}

void FaceTriangulator::start_from_facet() {
  const auto& [corners, on_edges, insides, segments] = incidences_of_[0];
  std::array<ConstrainedTriangulation::Vertex, 4> v{};
  for (std::size_t i = 0; i < corners.count; ++i) {
    const std::size_t at = index_of(corners[i]);
    v[i] = vertices_[at] = triangulation_.add(corners[i], lines_[at]);
  }
  if (corners.count == 3) {
    triangulation_.start(v[0], v[1], v[2]);
  } else {
    triangulation_.start(std::array{std::array{v[0], v[1], v[2]}, std::array{v[2], v[3], v[0]}});
  }
  for (std::size_t i = 0; i < corners.count; ++i) {
    for (const auto& p : on_edges[i]) {
      insert(p.point);
    }
  }
  insert_remaining();
}

void FaceTriangulator::insert_remaining() {
  for (const MemberIncidences& found : incidences_of_) {
    for (const auto& s : found.segments) {
      insert(s.from);
      insert(s.to);
    }
    for (const auto& p : found.insides) {
      insert(p.point);
    }
  }
}

std::uint32_t FaceTriangulator::member_of(std::uint32_t triangle) const {
  const std::uint32_t facet = constraints_.facets.of(triangle);
  const auto at = std::ranges::lower_bound(members_, facet);
  if (at == members_.end() || *at != facet) {
    throw Error(Errc::internal, "internal error, please report it: half of a flat sheet");
  }
  return static_cast<std::uint32_t>(at - members_.begin());
}

// The two triangles at a side of a member if no member is divided along it. Both are here, see
// FlatSheets.
const TrianglePair* FaceTriangulator::inner_side(std::size_t member, std::size_t side) const {
  const FlatFacets::Corners& corners = incidences_of_[member].corners;
  return constraints_.sheets.at(edge_key(corners[side], corners[corners.after(side)]));
}

void FaceTriangulator::find_sheets() {
  support::DisjointSets sheets(members_.size());
  for (std::size_t m = 0; !constraints_.sheets.empty() && m < members_.size(); ++m) {
    for (std::size_t i = 0; i < incidences_of_[m].corners.count; ++i) {
      if (const TrianglePair* sides = inner_side(m, i)) {
        sheets.unite(member_of(sides->first), member_of(sides->second));
      }
    }
  }
  sheet_of_.resize(members_.size());
  for (std::uint32_t m = 0; m < members_.size(); ++m) {
    sheet_of_[m] = members_[sheets.find(m)];
  }
}

// Several triangles: a triangle around them all, and their edges as constraints.
void FaceTriangulator::start_from_frame() {
  find_sheets();
  triangulation_.start_around(ids_);
  for (std::size_t m = 0; m < members_.size(); ++m) {
    for (const PointId id : incidences_of_[m].corners.all()) {
      insert(id);
    }
    for (const auto& points : incidences_of_[m].on_edges) {
      for (const auto& p : points) {
        insert(p.point);
      }
    }
  }
  insert_remaining();
  for (std::size_t m = 0; m < members_.size(); ++m) {
    constrain_edges(m);
  }
}

void FaceTriangulator::constrain_edges(std::size_t member) {
  const FlatFacets::Corners& corners = incidences_of_[member].corners;
  for (std::size_t i = 0; i < corners.count; ++i) {
    if (inner_side(member, i) != nullptr) {
      continue;
    }
    const EdgeKey key = edge_key(corners[i], corners[corners.after(i)]);
    slots_.push_back({kNone, {sheet_of_[member]}});
    const std::uint32_t slot = last_slot();
    PointId from = lower_end(key);
    for (const auto& p : incidences_of_[member].on_edges[i]) {
      triangulation_.constrain(vertex(from), vertex(p.point), slot);
      from = p.point;
    }
    triangulation_.constrain(vertex(from), vertex(upper_end(key)), slot);
  }
}

void FaceTriangulator::constrain_segments() {
  for (const MemberIncidences& found : incidences_of_) {
    for (const Constraints::Segment& s : found.segments) {
      slots_.push_back({s.partner, {}});
      triangulation_.constrain(vertex(s.from), vertex(s.to), last_slot());
    }
  }
}

// The parts of the face that no constraint divides.
void FaceTriangulator::find_regions() {
  const auto& faces = triangulation_.faces();
  region_of_.assign(faces.size(), kNone);
  first_in_region_.clear();
  in_order_.clear();
  for (std::uint32_t seed = 0; seed < faces.size(); ++seed) {
    if (region_of_[seed] != kNone) {
      continue;
    }
    const auto region = static_cast<std::uint32_t>(first_in_region_.size());
    first_in_region_.push_back(static_cast<std::uint32_t>(in_order_.size()));
    region_of_[seed] = region;
    in_order_.push_back(seed);
    for (std::size_t i = in_order_.size() - 1; i < in_order_.size(); ++i) {
      const ConstrainedTriangulation::Face& face = faces[in_order_[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t n = face.neighbours[k];
        if (n != kNone && face.slots[k] == kNone && region_of_[n] == kNone) {
          region_of_[n] = region;
          in_order_.push_back(n);
        }
      }
    }
  }
  first_in_region_.push_back(static_cast<std::uint32_t>(in_order_.size()));
}

// Which members cover each region, ascending. Crossing a member's edge enters or leaves it.
std::vector<FaceTriangulator::Members> FaceTriangulator::find_covers() const {
  std::vector<Members> covers(region_count());
  const auto& faces = triangulation_.faces();
  std::vector<std::uint32_t> queue{region_of_[triangulation_.face_at_frame()]};
  std::vector<std::uint8_t> known(covers.size(), 0);
  known[queue[0]] = 1;
  for (std::size_t q = 0; q < queue.size(); ++q) {
    const std::uint32_t region = queue[q];
    for (std::uint32_t i = first_in_region_[region]; i < first_in_region_[region + 1]; ++i) {
      const ConstrainedTriangulation::Face& face = faces[in_order_[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        if (face.slots[k] == kNone || face.neighbours[k] == kNone) {
          continue;
        }
        const std::uint32_t other = region_of_[face.neighbours[k]];
        if (!known[other]) {
          known[other] = 1;
          covers[other] = toggled(covers[region], slots_[face.slots[k]].bounding);
          queue.push_back(other);
        }
      }
    }
  }
  return covers;
}

std::vector<SignedTriangle> FaceTriangulator::signed_cover(
    std::span<const std::uint32_t> members) const {
  std::vector<SignedTriangle> cover;
  for (const std::uint32_t t : members) {
    int sign = 1;
    if (t != members_[0]) {
      const Triangle& s = input_.support(t);
      sign = projection_.orientation * turn(input_.points, s[0], s[1], s[2], projection_.axis);
    }
    for (const SignedTriangle& c : input_.cover(t)) {
      cover.push_back({c.triangle, sign * c.sign});
    }
  }
  std::sort(cover.begin(), cover.end(),
            [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
  return cover;
}

// All regions of a facet alone have one cover.
template <class Emit>
void FaceTriangulator::emit_single(FaceSubdivision& result, Emit&& emit) const {
  const std::vector<SignedTriangle> cover = signed_cover(members_);
  if (is_cancelled(input_, rule_, cover)) {
    return;
  }
  result.local.covers.insert(result.local.covers.end(), cover.begin(), cover.end());
  emit(cover.size());
}

void FaceTriangulator::emit_regions(std::size_t covers, FaceSubdivision& result) const {
  const auto end = static_cast<std::uint32_t>(result.local.covers.size());
  for (std::uint32_t region = 0; region < region_count(); ++region) {
    result.local.regions.push_back({end - static_cast<std::uint32_t>(covers), end, members_[0]});
    emit_sub_triangles(region, false, result);
  }
}

void FaceTriangulator::emit_overlapping(FaceSubdivision& result) const {
  const std::vector<Members> covers = find_covers();
  Subdivision& local = result.local;
  for (std::uint32_t region = 0; region < covers.size(); ++region) {
    std::vector<SignedTriangle> cover = signed_cover(covers[region]);
    if (is_cancelled(input_, rule_, cover)) {
      continue;
    }
    // A region of one triangle takes its orientation: it may be joined to others around a corner.
    const bool reversed = covers[region].size() == 1 && cover.front().sign < 0;
    for (SignedTriangle& t : cover) {
      t.sign = reversed ? -t.sign : t.sign;
    }
    const auto first = static_cast<std::uint32_t>(local.covers.size());
    local.covers.insert(local.covers.end(), cover.begin(), cover.end());
    local.regions.push_back({first, static_cast<std::uint32_t>(local.covers.size()),
                             reversed ? covers[region][0] : members_[0]});
    emit_sub_triangles(region, reversed, result);
  }
}

void FaceTriangulator::emit_sub_triangles(std::uint32_t region, bool reversed,
                                          FaceSubdivision& result) const {
  const auto number = static_cast<std::uint32_t>(result.local.regions.size() - 1);
  const auto known_points = static_cast<PointId>(result.new_points.size());
  const auto& faces = triangulation_.faces();
  for (std::uint32_t i = first_in_region_[region]; i < first_in_region_[region + 1]; ++i) {
    const ConstrainedTriangulation::Face& face = faces[in_order_[i]];
    Subdivision::SubTriangle triangle{{}, number, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId id = triangulation_.point(face.corners[k]);
      triangle.corners[k] = id < ConstrainedTriangulation::kNewPoint ? id : id + known_points;
      if (face.neighbours[k] == kNone || face.slots[k] != kNone) {
        triangle.open = static_cast<std::uint8_t>(triangle.open | (1u << k));
      }
    }
    if (reversed) {
      std::swap(triangle.corners[1], triangle.corners[2]);
      triangle.open = static_cast<std::uint8_t>((triangle.open & 1u) | (triangle.open & 2u) << 1 |
                                                (triangle.open & 4u) >> 1);
    }
    result.local.triangles.push_back(triangle);
  }
}

}  // namespace dupin::arrangement
