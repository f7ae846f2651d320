#include "surfaces/exact_rows.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace dupin::surfaces {
namespace {

// The Bernstein coefficients of the same polynomial with one more of them.
template <class T>
std::vector<T> elevated(const std::vector<T>& c) {
  const std::size_t n = c.size();
  std::vector<T> result{c.front()};
  for (std::size_t i = 1; i < n; ++i) {
    const double share = double(i) / double(n);
    result.push_back(share * c[i - 1] + (1 - share) * c[i]);
  }
  result.push_back(c.back());
  return result;
}

// None for R2, which is no polynomial.
std::vector<double> bernstein(const RadiusLaw& law) {
  struct Coefficients {
    std::vector<double> operator()(const ConstantRadius& r) const { return {r.radius}; }
    std::vector<double> operator()(const LinearRadius& r) const { return {r.start, r.end}; }
    std::vector<double> operator()(const CubicRadius& r) const {
      return {r.start, r.start, r.end, r.end};
    }
    std::vector<double> operator()(const CyclideRadius&) const { return {}; }
    std::vector<double> operator()(const BezierRadius& r) const { return r.coefficients; }
  };
  return std::visit(Coefficients(), law);
}

// The control points of a straight spine; none for others.
std::vector<Vec3> straight(const Spine& spine) {
  std::vector<Vec3> points;
  if (const auto* line = std::get_if<LineSpine>(&spine)) {
    points = {line->from, line->to};
  } else if (const auto* cubic = std::get_if<HermiteSpine>(&spine)) {
    points = {cubic->from, cubic->from + cubic->start_velocity / 3,
              cubic->to - cubic->end_velocity / 3, cubic->to};
  } else if (const auto* bezier = std::get_if<BezierSpine>(&spine);
             bezier != nullptr && bezier->weights.empty()) {
    points = bezier->points;
  }
  for (const Vec3& point : points) {
    const Vec3 chord = points.back() - points.front();
    if (!chord.cross(point - points.front()).isZero(0)) {
      return {};
    }
  }
  return points;
}

// A section of a part where it begins: its semi-axes as vectors.
struct Section {
  Vec3 first, second;  ///< unit
};

std::vector<NurbsRow> straight_rows(std::vector<Vec3> spine, std::vector<double> first,
                                    std::vector<double> second, const Section& section) {
  const std::size_t size = std::max({spine.size(), first.size(), second.size()});
  while (spine.size() < size) {
    spine = elevated(spine);
  }
  for (auto* law : {&first, &second}) {
    while (law->size() < size) {
      *law = elevated(*law);
    }
  }
  std::vector<NurbsRow> rows;
  for (std::size_t i = 0; i < size; ++i) {
    rows.push_back({spine[i], first[i] * section.first, second[i] * section.second, 1});
  }
  return rows;
}

// The circle through a row turned about the arc's axis, in pieces of about a right angle or less:
// the middle row of a piece is w = cos(half) times the axis' foot and the rest turned by half.
std::vector<NurbsRow> turned_rows(const ArcSpine& arc, const NurbsRow& start) {
  constexpr double kLargest = 1.6;  // a little more, so that quarter turns are one piece
  const int pieces = int(std::ceil(arc.angle / kLargest));
  const double half = arc.angle / pieces / 2;
  std::vector<NurbsRow> rows;
  for (int i = 0; i <= 2 * pieces; ++i) {
    const Eigen::AngleAxisd turn(half * i, arc.axis);
    const double weight = i % 2 == 0 ? 1 : std::cos(half);
    const auto turned = [&](const Vec3& v) {
      const Vec3 along = v.dot(arc.axis) * arc.axis;
      return Vec3(weight * along + turn * Vec3(v - along));
    };
    rows.push_back({weight * arc.center + turned(start.center - arc.center), turned(start.a),
                    turned(start.b), weight});
  }
  return rows;
}

Section section_of(const Spine& spine, const Vec3& axis) {
  const Vec3 tangent = evaluate(spine, 0).first.normalized();
  const Vec3 first = (axis - axis.dot(tangent) * tangent).normalized();
  return {first, tangent.cross(first)};
}

}  // namespace

ExactRows exact_rows(const Spine& spine, const RadiusLaw& first, const RadiusLaw& second,
                     const Vec3& axis) {
  const auto a = bernstein(first), b = bernstein(second);
  if (a.empty() || b.empty()) {
    return {};
  }
  const Section section = section_of(spine, axis);
  if (const auto* arc = std::get_if<ArcSpine>(&spine)) {
    if (a.size() > 1 || b.size() > 1) {
      return {};
    }
    return {turned_rows(*arc, {arc->start, a[0] * section.first, b[0] * section.second, 1}), 2};
  }
  const auto points = straight(spine);
  if (points.empty()) {
    return {};
  }
  auto rows = straight_rows(points, a, b, section);
  const int degree = int(rows.size()) - 1;
  return {std::move(rows), degree};
}

}  // namespace dupin::surfaces
