#include "arrangement/faces/constrained_triangulation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "arrangement/faces/frame.h"
#include "arrangement/faces/plane_frame.h"
#include "arrangement/points/implicit_predicates.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "predicates/sign_filter.h"

namespace dupin::arrangement {
namespace {

/// From so many faces on, ways through them are kept short: fans have ways as long as they are
/// wide.
constexpr std::uint32_t kMany = 512;

constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
constexpr int previous(int i) { return i == 0 ? 2 : i - 1; }
constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
constexpr PointId kFrame = ConstrainedTriangulation::kFirstFrameCorner;

}  // namespace

ConstrainedTriangulation::ConstrainedTriangulation(const PointTable& points, Caller caller)
    : points_(points), caller_(std::move(caller)) {}

void ConstrainedTriangulation::clear(const Projection& projection) {
  projection_ = projection;
  vertices_.clear();
  intervals_.clear();
  reach_ = radius_ = turn_bound_ = 0;
  faces_.clear();
  new_points_.clear();
  balls_.clear();
  frame_corners_.clear();
  in_cavity_.clear();
  is_improved_ = false;
  hint_ = 0;
  random_ = 1;
}

ConstrainedTriangulation::Vertex ConstrainedTriangulation::add(PointId id, Lines lines) {
  const int u = (projection_.axis + 1) % 3, v = (projection_.axis + 2) % 3;
  return add_vertex(points_.interval(id, u), points_.interval(id, v), id, lines);
}

// The bound, for rounding upward: differences of middles are below 2 reach (1 + 2^-51), products of
// them below 4.01 reach^2, and by stage A of [She97] with u = 2^-52 their difference is off by less
// than (3 + 16 u) u times two of these. Those of the points are off them by 2 radius at most, which
// changes the value by less than 2 radius times four of them and 8 radius^2. The addend covers
// underflow. What is no number is no bound.
ConstrainedTriangulation::Vertex ConstrainedTriangulation::add_vertex(const Interval& u,
                                                                      const Interval& v, PointId id,
                                                                      Lines lines) {
  const double middle_u = (u.inf() + u.sup()) / 2, middle_v = (v.inf() + v.sup()) / 2;
  vertices_.push_back({middle_u, middle_v, id, kNone, lines});
  intervals_.push_back({u, v});
  const auto grow = [](double& largest, double value) {
    largest = value <= largest ? largest : value;
  };
  for (const double radius :
       {u.sup() - middle_u, middle_u - u.inf(), v.sup() - middle_v, middle_v - v.inf()}) {
    grow(radius_, radius);
  }
  grow(reach_, std::abs(middle_u - vertices_[0].u));
  grow(reach_, std::abs(middle_v - vertices_[0].v));
  turn_bound_ = 25 * 0x1p-52 * reach_ * reach_ + 17 * radius_ * (reach_ + radius_) + 0x1p-900;
  return static_cast<Vertex>(vertices_.size() - 1);
}

ConstrainedTriangulation::Vertex ConstrainedTriangulation::add_frame_corner(
    const Eigen::Vector2d& place) {
  const auto id = static_cast<PointId>(kFrame + frame_corners_.size());
  Vec3& corner = frame_corners_.emplace_back(Vec3::Zero());
  corner[(projection_.axis + 1) % 3] = place[0];
  corner[(projection_.axis + 2) % 3] = place[1];
  return add_vertex(Interval(place[0]), Interval(place[1]), id, 0);
}

void ConstrainedTriangulation::start_around(std::span<const PointId> ids) {
  const std::array<Eigen::Vector2d, 3> frame = frame_around(points_, ids, projection_);
  const Vertex a = add_frame_corner(frame[0]), b = add_frame_corner(frame[1]);
  start(a, b, add_frame_corner(frame[2]));
}

void ConstrainedTriangulation::start(std::span<const std::array<Vertex, 3>> ears) {
  after_.assign(vertices_.size(), kNone);
  for (const auto& [a, v, c] : ears) {
    const std::uint32_t face = add_face(a, v, c);
    connect(face, 2, after_[a], kNone);
    connect(face, 0, after_[v], kNone);
    after_[a] = face;
  }
  const auto& [a, v, c] = ears.back();
  connect(after_[a], 1, after_[c], kNone);
}

std::uint32_t ConstrainedTriangulation::face_at_frame() const {
  return std::ranges::find_if(vertices_, [](const VertexData& v) { return v.id >= kFrame; })->face;
}

const mesh::ExactPoint& ConstrainedTriangulation::exact(Vertex v, mesh::ExactPoint& scratch) const {
  const PointId id = vertices_[v].id;
  if (id >= kFrame) {
    const Vec3& corner = frame_corners_[id - kFrame];
    scratch = {corner[0], corner[1], corner[2], 1};
    return scratch;
  }
  if (id < kNewPoint) {
    return points_.exact(id, scratch);
  }
  NewPoint& point = new_points_[id - kNewPoint];
  if (point.exact[3].sign() == 0) {
    point.exact = evaluate_exact(points_, point.definition);
  }
  return point.exact;
}

exact::BallPoint ConstrainedTriangulation::ball(Vertex v) const {
  const PointId id = vertices_[v].id;
  if (id >= kFrame) {
    const Vec3& corner = frame_corners_[id - kFrame];
    return {corner[0], corner[1], corner[2]};
  }
  if (id < kNewPoint) {
    return points_.ball(id);
  }
  const std::size_t index = id - kNewPoint;
  balls_.resize(new_points_.size());
  if (!balls_[index]) {
    balls_[index] = evaluate_ball(points_, new_points_[index].definition);
  }
  return *balls_[index];
}

Vec3 ConstrainedTriangulation::approximation(Vertex v) const {
  const PointId id = vertices_[v].id;
  if (id >= kFrame) {
    return frame_corners_[id - kFrame];
  }
  if (id < kNewPoint) {
    return points_.approximation(id);
  }
  const IntervalPoint& box = new_points_[id - kNewPoint].box;
  return {box[0].sup(), box[1].sup(), box[2].sup()};
}

int ConstrainedTriangulation::exact_turn(Vertex a, Vertex b, Vertex c) const {
  if (a == b || b == c || c == a) {
    return 0;  // in line, but with no line in common
  }
  if (collinear_ <= kMostCollinear) {
    const FilteredSign fine = turn_of(ball(a), ball(b), ball(c), projection_.axis);
    if (fine.certain) {
      collinear_ = std::max(collinear_ - 1, -kMostCollinear);
      return projection_.orientation * fine.sign;
    }
    ++collinear_;
  }
  std::array<mesh::ExactPoint, 3> scratch;
  const mesh::ExactPoint& x = exact(a, scratch[0]);
  const mesh::ExactPoint& y = exact(b, scratch[1]);
  const int sign = arrangement::exact_turn(x, y, exact(c, scratch[2]), projection_.axis);
  if (sign == 0) {
    align(a, b, c);
    align(b, c, a);
    align(c, a, b);
  }
  return projection_.orientation * sign;
}

std::uint32_t ConstrainedTriangulation::next_random() {
  random_ = random_ * 1664525u + 1013904223u;
  return random_ >> 16;
}

// What cannot happen as long as the vertices lie in the plane and in the first triangle: in every
// build an error, so that nothing goes on with a triangulation that is none.
void ConstrainedTriangulation::fail(Vertex v, const char* what) const {
  const std::string place =
      vertices_[v].id < kFrame ? decimal(approximation(v)) : "a corner of the frame";
  throw Error(Errc::internal, std::string("internal error, please report it: ") + what +
                                  " in the triangulation at " + place);
}

ConstrainedTriangulation::Location ConstrainedTriangulation::location_in(
    std::uint32_t face, const std::array<int, 3>& sides) {
  for (int k = 0; k < 3; ++k) {
    if (sides[at(k)] == 0) {
      const int other = sides[at(next(k))] == 0       ? next(k)
                        : sides[at(previous(k))] == 0 ? previous(k)
                                                      : -1;
      return other == -1 ? Location{face, k, false} : Location{face, 3 - k - other, true};
    }
  }
  return {face, -1, false};
}

// A walk that starts each step at a random edge ends in any triangulation (O. Devillers, S. Pion,
// M. Teillaud, Walking in a triangulation, 2002); sooner than this, or all faces are looked at.
ConstrainedTriangulation::Location ConstrainedTriangulation::locate(Vertex p) {
  std::uint32_t face = hint_, from = kNone;
  for (std::size_t steps = 8 * faces_.size() + 64; steps > 0; --steps) {
    const Face& f = faces_[face];
    std::array<int, 3> sides{1, 1, 1};
    std::uint32_t onward = kNone;
    int i = static_cast<int>(next_random() % 3);
    for (int n = 0; n < 3 && onward == kNone; ++n, i = next(i)) {
      if (f.neighbours[at(i)] == from && from != kNone) {
        continue;
      }
      sides[at(i)] = turn(f.corners[at(next(i))], f.corners[at(previous(i))], p);
      if (sides[at(i)] < 0) {
        onward = f.neighbours[at(i)];
        if (onward == kNone) {
          fail(p, "a vertex lies outside");
        }
      }
    }
    if (onward == kNone) {
      hint_ = face;
      return location_in(face, sides);
    }
    from = face;
    face = onward;
  }
  return search(p);
}

ConstrainedTriangulation::Location ConstrainedTriangulation::search(Vertex p) const {
  for (std::uint32_t face = 0; face < faces_.size(); ++face) {
    const auto& c = faces_[face].corners;
    const std::array<int, 3> sides{turn(c[1], c[2], p), turn(c[2], c[0], p), turn(c[0], c[1], p)};
    if (sides[0] >= 0 && sides[1] >= 0 && sides[2] >= 0) {
      return location_in(face, sides);
    }
  }
  fail(p, "a vertex lies outside");
}

void ConstrainedTriangulation::insert(Vertex p) {
  const Location at_p = locate(p);
  if (at_p.at_corner) {
    fail(p, "two vertices coincide");
  }
  const std::size_t before = faces_.size();
  std::uint32_t beyond = kNone;
  if (at_p.corner == -1) {
    split_face(at_p.face, p);
  } else {
    beyond = faces_[at_p.face].neighbours[at(at_p.corner)];
    split_edge(at_p.face, at_p.corner, p);
  }
  if (is_improved_ || faces_.size() >= kMany) {
    push_edges(is_improved_ || before >= kMany ? before : 0, faces_.size());
    push_edges(at_p.face, at_p.face + 1);
    push_edges(beyond, beyond == kNone ? beyond : beyond + 1);
    const int sign = projection_.orientation;
    const auto place = [&](Vertex v) { return std::array{sign * vertices_[v].u, vertices_[v].v}; };
    flip_towards_delaunay(place, true);
  }
}

std::uint32_t ConstrainedTriangulation::add_face(Vertex a, Vertex b, Vertex c) {
  faces_.push_back({});
  const auto face = static_cast<std::uint32_t>(faces_.size() - 1);
  set_face(face, a, b, c);
  return face;
}

void ConstrainedTriangulation::set_face(std::uint32_t face, Vertex a, Vertex b, Vertex c) {
  faces_[face] = {{a, b, c}, {kNone, kNone, kNone}, {kNone, kNone, kNone}};
  vertices_[a].face = vertices_[b].face = vertices_[c].face = face;
}

// Makes `neighbour`, whose matching edge must be the one that `face` has at `corner`, adjacent.
void ConstrainedTriangulation::connect(std::uint32_t face, int corner, std::uint32_t neighbour,
                                       std::uint32_t slot) {
  Face& f = faces_[face];
  f.neighbours[at(corner)] = neighbour;
  f.slots[at(corner)] = slot;
  if (neighbour == kNone) {
    return;
  }
  const Vertex from = f.corners[at(next(corner))];
  Face& g = faces_[neighbour];
  const int other = next(corner_of(neighbour, from));  // its edge runs to `from`
  g.neighbours[at(other)] = face;
  g.slots[at(other)] = slot;
}

void ConstrainedTriangulation::split_face(std::uint32_t face, Vertex p) {
  const Face old = faces_[face];
  const auto [a, b, c] = old.corners;
  set_face(face, a, b, p);
  const std::uint32_t g = add_face(b, c, p), h = add_face(c, a, p);
  connect(face, 2, old.neighbours[2], old.slots[2]);
  connect(g, 2, old.neighbours[0], old.slots[0]);
  connect(h, 2, old.neighbours[1], old.slots[1]);
  connect(face, 0, g, kNone);
  connect(g, 0, h, kNone);
  connect(h, 0, face, kNone);
}

void ConstrainedTriangulation::split_edge(std::uint32_t face, int corner, Vertex p) {
  const Face old = faces_[face];
  const std::uint32_t other = old.neighbours[at(corner)], slot = old.slots[at(corner)];
  const Vertex a = old.corners[at(corner)], b = old.corners[at(next(corner))],
               c = old.corners[at(previous(corner))];
  const int far = other == kNone ? 0 : corner_facing(other, face);
  const Face old_other = other == kNone ? Face{} : faces_[other];
  align(b, c, p);
  // This side: a b p and a p c.
  set_face(face, a, b, p);
  const std::uint32_t g = add_face(a, p, c);
  connect(face, 2, old.neighbours[at(previous(corner))], old.slots[at(previous(corner))]);
  connect(g, 1, old.neighbours[at(next(corner))], old.slots[at(next(corner))]);
  connect(face, 1, g, kNone);
  if (other == kNone) {
    faces_[face].slots[0] = faces_[g].slots[0] = slot;
    return;
  }
  // Far side, seen from its corner d: d c p and d p b.
  const Vertex d = old_other.corners[at(far)];
  set_face(other, d, c, p);
  const std::uint32_t h = add_face(d, p, b);
  connect(other, 2, old_other.neighbours[at(previous(far))], old_other.slots[at(previous(far))]);
  connect(h, 1, old_other.neighbours[at(next(far))], old_other.slots[at(next(far))]);
  connect(other, 1, h, kNone);
  connect(face, 0, h, slot);
  connect(g, 0, other, slot);
}

void ConstrainedTriangulation::mark(std::uint32_t face, int corner, std::uint32_t slot) {
  Face& f = faces_[face];
  std::uint32_t& present = f.slots[at(corner)];
  present = present == kNone ? slot : caller_.both(present, slot);
  if (const std::uint32_t other = f.neighbours[at(corner)]; other != kNone) {
    faces_[other].slots[at(corner_facing(other, face))] = present;
  }
}

void ConstrainedTriangulation::constrain(Vertex a, Vertex b, std::uint32_t slot) {
  if (vertices_[a].face == kNone || vertices_[b].face == kNone) {
    fail(vertices_[a].face == kNone ? a : b, "an end of a constraint is missing");
  }
  // Each step passes a vertex, or an edge that was there before.
  for (std::size_t steps = 4 * faces_.size() + 64; a != b; --steps) {
    if (steps == 0) {
      fail(b, "a constraint does not come to its end");
    }
    a = advance(a, b, slot);
  }
}

ConstrainedTriangulation::Vertex ConstrainedTriangulation::advance(Vertex a, Vertex b,
                                                                   std::uint32_t slot) {
  const std::uint32_t first = vertices_[a].face;
  for (const bool clockwise : {false, true}) {
    std::uint32_t face = first;
    std::optional<int> known;  // the turn to the corner that the face before has too
    do {
      const int i = corner_of(face, a);
      const Face& f = faces_[face];
      const Vertex right = f.corners[at(next(i))], left = f.corners[at(previous(i))];
      if (right == b || left == b) {
        mark(face, right == b ? previous(i) : next(i), slot);
        return b;
      }
      const int r = known && !clockwise ? *known : turn(a, b, right),
                l = known && clockwise ? *known : turn(a, b, left);
      known = clockwise ? r : l;
      if (r == 0 && l > 0) {
        align(a, b, right);
        mark(face, previous(i), slot);
        return right;
      }
      if (l == 0 && r < 0) {
        align(a, b, left);
        mark(face, next(i), slot);
        return left;
      }
      if (r < 0 && l > 0) {
        return cross(face, i, a, b, slot);
      }
      face = f.neighbours[at(clockwise ? previous(i) : next(i))];
    } while (face != kNone && face != first);
  }
  fail(b, "the end of a constraint lies outside");
}

ConstrainedTriangulation::Vertex ConstrainedTriangulation::split_crossed_edge(std::uint32_t face,
                                                                              int corner,
                                                                              std::uint32_t slot) {
  const ImplicitPoint definition = caller_.crossing(faces_[face].slots[at(corner)], slot);
  NewPoint point{definition, evaluate(points_, definition), {}};
  const std::size_t u = at((projection_.axis + 1) % 3), v = at((projection_.axis + 2) % 3);
  if (!std::isfinite(point.box[u].inf() + point.box[u].sup() + point.box[v].inf() +
                     point.box[v].sup())) {
    point.exact = evaluate_exact(points_, definition);
    point.box = enclose(point.exact);
  }
  const auto id = static_cast<PointId>(kNewPoint | new_points_.size());
  const Vertex vertex = add_vertex(point.box[u], point.box[v], id, 0);
  new_points_.push_back(std::move(point));
  split_edge(face, corner, vertex);
  return vertex;
}

// The segment a b leaves `face` through the edge opposite to its corner `corner`, which is a.
// Clears the way up to the first vertex on the segment, or to the first constrained edge across it,
// which is split; and constrains it.
ConstrainedTriangulation::Vertex ConstrainedTriangulation::cross(std::uint32_t face, int corner,
                                                                 Vertex a, Vertex b,
                                                                 std::uint32_t slot) {
  const auto link = [this](std::vector<Link>& chain, std::uint32_t f, int edge, Vertex onward) {
    chain.back().outer = faces_[f].neighbours[at(edge)];
    chain.back().slot = faces_[f].slots[at(edge)];
    chain.push_back({onward, kNone, kNone, false});
  };
  cavity_.assign(1, face);
  left_.assign(1, {a, kNone, kNone, false});
  right_.assign(1, {a, kNone, kNone, false});
  link(left_, face, next(corner), faces_[face].corners[at(previous(corner))]);
  link(right_, face, previous(corner), faces_[face].corners[at(next(corner))]);
  while (true) {
    if (faces_[face].slots[at(corner)] != kNone) {
      const Vertex crossing = split_crossed_edge(face, corner, slot);
      align(a, b, crossing);
      return advance(a, crossing, slot);
    }
    const std::uint32_t onward = faces_[face].neighbours[at(corner)];
    if (onward == kNone || cavity_.size() > faces_.size()) {
      fail(b, "a constraint leaves the faces");
    }
    const int entry = corner_facing(onward, face);
    const Vertex apex = faces_[onward].corners[at(entry)];
    const int side = apex == b ? 0 : turn(a, b, apex);
    cavity_.push_back(onward);
    if (side >= 0) {
      link(left_, onward, previous(entry), apex);
    }
    if (side <= 0) {
      link(right_, onward, next(entry), apex);
    }
    if (side == 0) {
      align(a, b, apex);
      fill_cavity(slot);
      return apex;
    }
    face = onward;
    corner = side > 0 ? next(entry) : previous(entry);
  }
}

// Retriangulates the faces of the cavity such that its two chains' common ends are joined.
void ConstrainedTriangulation::fill_cavity(std::uint32_t slot) {
  in_cavity_.resize(faces_.size(), 0);
  for (const std::uint32_t face : cavity_) {
    in_cavity_[face] = 1;
  }
  dangling_.clear();
  spare_ = cavity_;
  const std::uint32_t left = fill(left_, true), right = fill(right_, false);
  const Vertex a = left_.front().vertex, b = left_.back().vertex;
  const int corner = 3 - corner_of(left, a) - corner_of(left, b);
  connect(left, corner, right, slot);
  if (!spare_.empty()) {
    fail(a, "a constraint leaves faces over");
  }
  for (const std::uint32_t face : cavity_) {
    in_cavity_[face] = 0;
  }
}

// Triangulates between a chain and the segment joining its ends, from which all of it is visible,
// by cutting off convex corners in order; returns the face at that segment.
std::uint32_t ConstrainedTriangulation::fill(const std::vector<Link>& chain, bool is_left) {
  stack_.clear();
  for (const Link& w : chain) {
    while (stack_.size() >= 2) {
      Link& u = stack_[stack_.size() - 2];
      const Link v = stack_.back();
      const int bend = turn(u.vertex, v.vertex, w.vertex);
      if (is_left ? bend >= 0 : bend <= 0) {
        break;
      }
      if (spare_.empty()) {
        fail(v.vertex, "a constraint lacks faces");
      }
      const std::uint32_t face = spare_.back();
      spare_.pop_back();
      if (is_left) {
        set_face(face, u.vertex, w.vertex, v.vertex);
        attach(face, 1, u);
        attach(face, 0, v);
      } else {
        set_face(face, u.vertex, v.vertex, w.vertex);
        attach(face, 2, u);
        attach(face, 0, v);
      }
      u.outer = face;
      u.slot = kNone;
      u.is_fresh = true;
      stack_.pop_back();
    }
    stack_.push_back(w);
  }
  if (stack_.size() != 2) {
    fail(chain.front().vertex, "what a constraint crosses cannot be filled");
  }
  return stack_.front().outer;
}

void ConstrainedTriangulation::attach(std::uint32_t face, int corner, const Link& link) {
  if (link.is_fresh || link.outer == kNone || !in_cavity_[link.outer]) {
    connect(face, corner, link.outer, link.slot);
    return;
  }
  // An edge with the cavity on both sides of it, which comes once from each.
  const Vertex from = faces_[face].corners[at(next(corner))],
               to = faces_[face].corners[at(previous(corner))];
  for (const Dangling& other : dangling_) {
    if (other.from == to && other.to == from) {
      connect(face, corner, other.face, link.slot);
      return;
    }
  }
  faces_[face].slots[at(corner)] = link.slot;
  dangling_.push_back({from, to, face});
}

void ConstrainedTriangulation::flip(std::uint32_t face, int corner) {
  const Face f = faces_[face];
  const std::uint32_t other = f.neighbours[at(corner)];
  const Face g = faces_[other];
  const int facing = corner_facing(other, face);
  const Vertex a = f.corners[at(corner)], b = f.corners[at(next(corner))],
               c = g.corners[at(facing)], d = f.corners[at(previous(corner))];
  set_face(face, a, b, c);
  set_face(other, a, c, d);
  // g's corners are c, d, b in order.
  connect(face, 2, f.neighbours[at(previous(corner))], f.slots[at(previous(corner))]);
  connect(face, 0, g.neighbours[at(next(facing))], g.slots[at(next(facing))]);
  connect(other, 0, g.neighbours[at(previous(facing))], g.slots[at(previous(facing))]);
  connect(other, 1, f.neighbours[at(next(corner))], f.slots[at(next(corner))]);
  connect(face, 1, other, kNone);
}

void ConstrainedTriangulation::push_edges(std::size_t begin, std::size_t end) {
  for (; begin < end; ++begin) {
    for (int i = 0; i < 3; ++i) {
      edges_.emplace_back(static_cast<std::uint32_t>(begin), i);
    }
  }
}

// Each flip lowers the paraboloid lifted over the places, so the loop ends.
template <class Place>
void ConstrainedTriangulation::flip_towards_delaunay(const Place& place, bool also_at_frame) {
  const auto is_fixed = [&](Vertex v) { return !also_at_frame && point(v) >= kFrame; };
  while (!edges_.empty()) {
    const auto [face, i] = edges_.back();
    edges_.pop_back();
    const Face& f = faces_[face];
    const std::uint32_t other = f.neighbours[at(i)];
    if (other == kNone || f.slots[at(i)] != kNone) {
      continue;
    }
    const Vertex a = f.corners[at(i)], b = f.corners[at(next(i))], d = f.corners[at(previous(i))];
    const Vertex c = faces_[other].corners[at(corner_facing(other, face))];
    if (is_fixed(a) || is_fixed(b) || is_fixed(c) || is_fixed(d) ||
        !predicates::certainly_in_circle(place(a), place(b), place(d), place(c)) ||
        certain_turn(a, b, c) <= 0 || certain_turn(a, c, d) <= 0) {
      continue;
    }
    flip(face, i);
    push_edges(face, face + 1);
    push_edges(other, other + 1);
  }
}

void ConstrainedTriangulation::improve(const Triangle& support) {
  const PlaneFrame plane(points_.approximation(support[0]), points_.approximation(support[1]),
                         points_.approximation(support[2]));
  planar_.clear();
  for (Vertex v = 0; v < vertices_.size(); ++v) {
    planar_.push_back(plane.at(approximation(v)));
  }
  push_edges(0, faces_.size());
  flip_towards_delaunay([this](Vertex v) { return planar_[v]; }, false);
  is_improved_ = true;
}

}  // namespace dupin::arrangement
