#include "arrangement/points/implicit_points.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <type_traits>

#include "exact/line_plane_meeting.h"
#include "exact/number_enclosure.h"
#include "exact/vector_algebra.h"
#include "support/blocks.h"
#include "support/operation_limits.h"

namespace dupin::arrangement {
namespace {

using exact::cross;
using exact::difference;
using exact::direction;
using exact::dot;

using Number = CGAL::Mpzf;
using Direction = std::array<Number, 3>;

struct Plane {  // normal . x + offset w = 0, a positive multiple of the plane through three points
  Direction normal;
  Number offset;
};

mesh::ExactPoint homogeneous(const Vec3& p) {
  return {Number(p[0]), Number(p[1]), Number(p[2]), Number(1)};
}

Direction direction(const Vec3& from, const Vec3& to) {
  return {Number(to[0]) - Number(from[0]), Number(to[1]) - Number(from[1]),
          Number(to[2]) - Number(from[2])};
}

bool are_doubles(const PointTable& points, std::span<const PointId> ids) {
  return std::all_of(ids.begin(), ids.end(), [&](PointId id) { return points.is_double(id); });
}

Plane plane_through(const PointTable& points, const PointId* of) {
  if (are_doubles(points, {of, 3})) {
    const Vec3& a = points.coordinates(of[0]);
    Direction normal =
        cross(direction(a, points.coordinates(of[1])), direction(a, points.coordinates(of[2])));
    Number offset = -dot(normal, {Number(a[0]), Number(a[1]), Number(a[2])});
    return {std::move(normal), std::move(offset)};
  }
  std::array<mesh::ExactPoint, 3> scratch;
  const mesh::ExactPoint& a = points.exact(of[0], scratch[0]);
  const Direction normal = cross(direction(a, points.exact(of[1], scratch[1])),
                                 direction(a, points.exact(of[2], scratch[2])));
  return {{normal[0] * a[3], normal[1] * a[3], normal[2] * a[3]}, -dot(normal, {a[0], a[1], a[2]})};
}

Number height(const Plane& plane, const mesh::ExactPoint& p) {
  return dot(plane.normal, {p[0], p[1], p[2]}) + plane.offset * p[3];
}

mesh::ExactPoint with_positive_weight(mesh::ExactPoint point) {
  if (point[3].sign() < 0) {
    for (Number& x : point) {
      x = -x;
    }
  }
  return point;
}

// The point of the line p q whose signed distances from something are as alpha to beta.
mesh::ExactPoint divide(const mesh::ExactPoint& p, const mesh::ExactPoint& q, const Number& alpha,
                        const Number& beta) {
  return with_positive_weight({p[0] * beta - q[0] * alpha, p[1] * beta - q[1] * alpha,
                               p[2] * beta - q[2] * alpha, p[3] * beta - q[3] * alpha});
}

mesh::ExactPoint meet_line_plane(const PointTable& points, const ImplicitPoint& d) {
  if (are_doubles(points, {d.of.data(), 5})) {
    const auto at = [&](std::size_t i) -> const Vec3& { return points.coordinates(d.of[i]); };
    return exact::line_plane_meeting(at(0), at(1), at(2), at(3), at(4));
  }
  mesh::ExactPoint p_scratch, q_scratch;
  const mesh::ExactPoint& p = points.exact(d.of[0], p_scratch);
  const mesh::ExactPoint& q = points.exact(d.of[1], q_scratch);
  const Plane plane = plane_through(points, &d.of[2]);
  return divide(p, q, height(plane, p), height(plane, q));
}

mesh::ExactPoint meet_lines(const PointTable& points, const ImplicitPoint& d) {
  std::array<mesh::ExactPoint, 4> scratch;
  const mesh::ExactPoint& p = points.exact(d.of[0], scratch[0]);
  const mesh::ExactPoint& q = points.exact(d.of[1], scratch[1]);
  const mesh::ExactPoint& r = points.exact(d.of[2], scratch[2]);
  const mesh::ExactPoint& s = points.exact(d.of[3], scratch[3]);
  const std::size_t u = (d.axis + 1u) % 3, v = (d.axis + 2u) % 3;
  const Direction line = cross(Direction{r[u], r[v], r[3]}, Direction{s[u], s[v], s[3]});
  return divide(p, q, dot(line, {p[u], p[v], p[3]}), dot(line, {q[u], q[v], q[3]}));
}

mesh::ExactPoint meet_planes(const PointTable& points, const ImplicitPoint& d) {
  const Plane a = plane_through(points, &d.of[0]), b = plane_through(points, &d.of[3]),
              c = plane_through(points, &d.of[6]);
  const Direction bc = cross(b.normal, c.normal), ca = cross(c.normal, a.normal),
                  ab = cross(a.normal, b.normal);
  mesh::ExactPoint point;
  for (std::size_t k = 0; k < 3; ++k) {
    point[k] = -(a.offset * bc[k] + b.offset * ca[k] + c.offset * ab[k]);
  }
  point[3] = dot(a.normal, bc);
  return with_positive_weight(std::move(point));
}

// Enclosures of a point in numbers of a kind, intervals of doubles or balls.
template <class N>
class Enclosure {
 public:
  using Point = std::array<N, 3>;
  explicit Enclosure(const PointTable& points) : points_(points) {}

  [[nodiscard]] Point of(const ImplicitPoint& definition) const {
    switch (definition.kind) {
      case ImplicitPoint::Kind::line_plane:
        return line_plane(definition);
      case ImplicitPoint::Kind::two_lines:
        return lines(definition);
      case ImplicitPoint::Kind::three_planes:
        return planes(definition);
      case ImplicitPoint::Kind::given:
        break;
    }
    assert(false && "a given point has no definition");
    return {};
  }

 private:
  [[nodiscard]] Point at(PointId id) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return points_.interval(id);
    } else {
      return points_.ball(id);
    }
  }
  [[nodiscard]] Point normal_of(const PointId* of, const Point& first) const {
    return cross(difference(at(of[1]), first), difference(at(of[2]), first));
  }
  [[nodiscard]] static Point along(const Point& p, const Point& direction, const N& t) {
    return {p[0] + t * direction[0], p[1] + t * direction[1], p[2] + t * direction[2]};
  }

  [[nodiscard]] Point line_plane(const ImplicitPoint& d) const {
    const Point p = at(d.of[0]);
    const Point direction = difference(at(d.of[1]), p);
    const Point origin = at(d.of[2]);
    const Point normal = normal_of(&d.of[2], origin);
    return along(p, direction, dot(normal, difference(origin, p)) / dot(normal, direction));
  }
  [[nodiscard]] Point lines(const ImplicitPoint& d) const {
    const std::size_t u = (d.axis + 1u) % 3, v = (d.axis + 2u) % 3;
    const Point p = at(d.of[0]), r = at(d.of[2]);
    const Point pq = difference(at(d.of[1]), p), rs = difference(at(d.of[3]), r);
    const Point pr = difference(r, p);
    return along(p, pq, (pr[u] * rs[v] - pr[v] * rs[u]) / (pq[u] * rs[v] - pq[v] * rs[u]));
  }
  [[nodiscard]] Point planes(const ImplicitPoint& d) const {
    const Point origin = at(d.of[0]), b = at(d.of[3]), c = at(d.of[6]);
    const Point na = normal_of(&d.of[0], origin);
    const Point nb = normal_of(&d.of[3], b), nc = normal_of(&d.of[6], c);
    const N hb = dot(nb, difference(b, origin)), hc = dot(nc, difference(c, origin));
    const Point ca = cross(nc, na), ab = cross(na, nb);
    const N determinant = dot(nc, ab);
    Point point;
    for (std::size_t k = 0; k < 3; ++k) {
      point[k] = origin[k] + (hb * ca[k] + hc * ab[k]) / determinant;
    }
    return point;
  }

  const PointTable& points_;
};

Interval enclose_quotient(const Number& x, const Number& w, const Interval& weight) {
  const Interval quotient = Interval(exact::enclosure(x)) / weight;
  // Three roundings, unless a number lies beyond what doubles hold.
  const double width = quotient.sup() - quotient.inf();
  if (std::isfinite(width) && width <= 8 * 0x1p-52 * std::abs(quotient.inf())) {
    return quotient;
  }
  const double nearest = mesh::nearest_double(x, w);
  return {std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL)};
}

}  // namespace

mesh::ExactPoint evaluate_exact(const PointTable& points, const ImplicitPoint& definition) {
  switch (definition.kind) {
    case ImplicitPoint::Kind::line_plane:
      return meet_line_plane(points, definition);
    case ImplicitPoint::Kind::two_lines:
      return meet_lines(points, definition);
    case ImplicitPoint::Kind::three_planes:
      return meet_planes(points, definition);
    case ImplicitPoint::Kind::given:
      break;
  }
  assert(false && "a given point has no definition");
  return {};
}

IntervalPoint evaluate(const PointTable& points, const ImplicitPoint& definition) {
  return Enclosure<Interval>(points).of(definition);
}

exact::BallPoint evaluate_ball(const PointTable& points, const ImplicitPoint& definition) {
  return Enclosure<exact::Ball>(points).of(definition);
}

IntervalPoint enclose(const mesh::ExactPoint& point) {
  const Interval weight(exact::enclosure(point[3]));
  return {enclose_quotient(point[0], point[3], weight),
          enclose_quotient(point[1], point[3], weight),
          enclose_quotient(point[2], point[3], weight)};
}

PointId PointTable::add(const Vec3& point) {
  assert(implicit_.empty());
  doubles_.push_back(point);
  return double_count() - 1;
}

// Not twice as much: these are most of the memory there is.
void PointTable::make_room(std::size_t count) {
  const std::size_t size = implicit_.size() + count;
  if (size > implicit_.capacity()) {
    support::reserve_bulk(implicit_, size + size / 8 + 1);
  }
}

PointId PointTable::append(Implicit point) {
  make_room(1);
  implicit_.push_back(std::move(point));
  return size() - 1;
}

PointId PointTable::add(const mesh::ExactPoint& point) {
  return append({{}, enclose(point), Lazy<mesh::ExactPoint>(point), {}});
}

PointId PointTable::add(const ImplicitPoint& definition) {
  support::refuse_too_many(size(), 0);
  return append({definition, evaluate(*this, definition), {}, {}});
}

void PointTable::add_undefined(std::size_t count) {
  support::refuse_too_many(size() + count, 0);
  make_room(count);
  implicit_.resize(implicit_.size() + count);
}

void PointTable::define(PointId id, const ImplicitPoint& definition) {
  Implicit& point = implicit_[id - doubles_.size()];
  point.definition = definition;
  point.box = evaluate(*this, definition);
}

PointId PointTable::add(DefinedPoint point) {
  support::refuse_too_many(size(), 0);
  using Exact = Lazy<mesh::ExactPoint>;
  return append(
      {point.definition, point.box, point.exact[3].sign() == 0 ? Exact() : Exact(point.exact), {}});
}

Vec3 PointTable::approximation(PointId id) const {
  if (is_double(id)) {
    return doubles_[id];
  }
  const IntervalPoint& box = implicit_[id - doubles_.size()].box;
  return {(box[0].inf() + box[0].sup()) / 2, (box[1].inf() + box[1].sup()) / 2,
          (box[2].inf() + box[2].sup()) / 2};
}

const mesh::ExactPoint& PointTable::exact(PointId id, mesh::ExactPoint& scratch) const {
  if (is_double(id)) {
    scratch = homogeneous(doubles_[id]);
    return scratch;
  }
  const Implicit& point = implicit_[id - doubles_.size()];
  return point.exact.get([&] { return evaluate_exact(*this, point.definition); });
}

mesh::ExactPoint PointTable::exact_value(PointId id) const {
  if (is_double(id)) {
    return homogeneous(doubles_[id]);
  }
  const Implicit& point = implicit_[id - doubles_.size()];
  const mesh::ExactPoint* known = point.exact.known();
  return known != nullptr ? *known : evaluate_exact(*this, point.definition);
}

bool PointTable::is_meeting(PointId id) const {
  const ImplicitPoint& d = definition(id);
  return (d.kind == ImplicitPoint::Kind::line_plane && are_doubles(*this, {d.of.data(), 5})) ||
         (d.kind == ImplicitPoint::Kind::two_lines && are_doubles(*this, {d.of.data(), 4}));
}

mesh::LinePlaneMeeting PointTable::meeting(PointId id) const {
  const ImplicitPoint& d = definition(id);
  const auto of = [&](std::size_t i) -> const Vec3& { return coordinates(d.of[i]); };
  if (d.kind == ImplicitPoint::Kind::line_plane) {
    return {{of(0), of(1), of(2), of(3), of(4)}};
  }
  // The plane through the second line along the axis that both are seen along.
  Vec3 behind = of(2);
  behind[d.axis] = behind[d.axis] == 0 ? 1 : 0;
  return {{of(0), of(1), of(2), of(3), behind}};
}

exact::BallPoint PointTable::ball(PointId id) const {
  if (is_double(id)) {
    const Vec3& point = doubles_[id];
    return {point[0], point[1], point[2]};
  }
  const Implicit& point = implicit_[id - doubles_.size()];
  return point.ball.get([&] {
    return point.definition.kind == ImplicitPoint::Kind::given
               ? mesh::ball_point(*point.exact.known())
               : evaluate_ball(*this, point.definition);
  });
}

void PointTable::forget_balls() {
  support::for_each_block(implicit_.size(), [this](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      implicit_[i].ball = {};
    }
  });
}

void PointTable::tighten(PointId id) {
  mesh::ExactPoint scratch;
  implicit_[id - doubles_.size()].box = enclose(exact(id, scratch));
}

}  // namespace dupin::arrangement
