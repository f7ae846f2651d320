#include "tessellation/trimmed_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"
#include "dupin/kernel/triangulate_region.h"
#include "numbers/point_order.h"
#include "tessellation/swept_mesh.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin::tessellation {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// The face unrolled, seen from outside: x counts segments around from the end's first corner, y is
// the height.
class Chart {
 public:
  Chart(const TrimmedFace& face, const RingSampling& sampling)
      : origin_(face.start.center),
        axis_(face.end.normal),
        first_(first_direction(face.end, sampling)),
        second_(axis_.cross(first_)),
        height_((face.end.center - face.start.center).dot(axis_)),
        segments_(sampling.segments) {}

  [[nodiscard]] double around() const { return segments_; }

  [[nodiscard]] Vec2 place(const Vec3& point) const {
    const Vec3 arm = point - origin_;
    return {std::atan2(arm.dot(second_), arm.dot(first_)) / kTurn * segments_,
            kFlatness * height(point)};
  }

  [[nodiscard]] double height(const Vec3& point) const {
    return (point - origin_).dot(axis_) / height_;
  }

 private:
  // So flat that corners next to each other by angle are joined.
  static constexpr double kFlatness = 0.5;
  Vec3 origin_, axis_, first_, second_;
  double height_, segments_;
};

// A closed polygon on the face.
struct Curve {
  std::vector<std::uint32_t> corners;
  std::vector<Vec2> places;  // of the corners, x going on beyond a turn
  int turns = 0;             // about the axis, not negative
};

Curve unrolled(std::vector<std::uint32_t> corners, const std::vector<Vec2>& place, double around) {
  Curve curve{std::move(corners), {}};
  for (const std::uint32_t corner : curve.corners) {
    Vec2 next = place[corner];
    if (!curve.places.empty()) {
      next.x() -= around * std::round((next.x() - curve.places.back().x()) / around);
    }
    curve.places.push_back(next);
  }
  const double gap = curve.places.front().x() - curve.places.back().x();
  curve.turns = -int(std::lround((gap - std::remainder(gap, around)) / around));
  if (curve.turns < 0) {
    std::reverse(curve.corners.begin() + 1, curve.corners.end());
    return unrolled(std::move(curve.corners), place, around);
  }
  return curve;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Nothing here needs to be exact: what is wrong is refused when it is triangulated.
bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto differ = [](double x, double y) { return !(x * y > 0); };
  return differ(cross(b - a, c - a), cross(b - a, d - a)) &&
         differ(cross(d - c, a - c), cross(d - c, b - c));
}

// What lies between two curves about the axis, less holes: cut open along a straight line between
// corners of both.
class Strip {
 public:
  Strip(const Curve& lower, const Curve& upper, double around)
      : lower_(lower), upper_(upper), around_(around) {}

  [[nodiscard]] bool contains(const Curve& hole) const {
    const Vec2& place = hole.places.front();
    return is_below(lower_, place) && !is_below(upper_, place);
  }

  void add(const Curve& hole) { holes_.push_back(&hole); }

  void append_triangles(std::vector<Triangle>& triangles) {
    find_cut();
    append(lower_, cut_[0], cut_at_[0].x());
    append(upper_, cut_[1], cut_at_[1].x());
    std::ranges::reverse(polygons_.front().begin() + std::ptrdiff_t(lower_.corners.size()) + 1,
                         polygons_.front().end());
    for (const Curve* hole : holes_) {
      append_hole(*hole);
    }
    for (const Triangle& t : triangulate_region(places_, polygons_)) {
      triangles.push_back({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
    }
  }

 private:
  // How often a ray from the place downwards crosses the curve.
  [[nodiscard]] bool is_below(const Curve& curve, const Vec2& place) const {
    bool below = false;
    for_each_side(curve, place.x(), [&](const Vec2& a, const Vec2& b) {
      if ((a.x() <= place.x()) != (b.x() <= place.x())) {
        const double share = (place.x() - a.x()) / (b.x() - a.x());
        below ^= a.y() + share * (b.y() - a.y()) < place.y();
      }
    });
    return below;
  }

  // Sides moved by whole turns to next to x.
  template <class Visit>
  void for_each_side(const Curve& curve, double x, const Visit& visit) const {
    for (std::size_t i = 0; i < curve.places.size(); ++i) {
      Vec2 a = curve.places[i], b = curve.places[(i + 1) % curve.places.size()];
      a.x() = x + std::remainder(a.x() - x, around_);
      b.x() = a.x() + std::remainder(b.x() - a.x(), around_);
      visit(a, b);
    }
  }

  [[nodiscard]] bool is_crossed(const Vec2& from, const Vec2& to) const {
    bool crossed = false;
    const auto visit = [&](const Vec2& a, const Vec2& b) {
      const auto is_end = [&](const Vec2& p) {
        return (p - from).cwiseAbs().maxCoeff() < kNear || (p - to).cwiseAbs().maxCoeff() < kNear;
      };
      crossed = crossed || (!is_end(a) && !is_end(b) && cross_each_other(from, to, a, b));
    };
    for_each_side(lower_, from.x(), visit);
    for_each_side(upper_, from.x(), visit);
    for (const Curve* hole : holes_) {
      for_each_side(*hole, from.x(), visit);
    }
    return crossed;
  }

  // From a corner below to that above which is nearest around: the steepest that nothing crosses.
  void find_cut() {
    double flattest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < lower_.places.size(); ++i) {
      const Vec2& from = lower_.places[i];
      const auto aside = [&](const Vec2& p) { return std::remainder(p.x() - from.x(), around_); };
      const auto nearest = std::ranges::min_element(
          upper_.places, {}, [&](const Vec2& p) { return std::abs(aside(p)); });
      const double off = aside(*nearest);
      const Vec2 to(from.x() + off, nearest->y());
      if (std::abs(off) < flattest && to.y() > from.y() && !is_crossed(from, to)) {
        flattest = std::abs(off);
        cut_ = {i, std::size_t(nearest - upper_.places.begin())};
        cut_at_ = {from, to};
      }
    }
    if (!(flattest < around_)) {
      throw Error(Errc::self_intersecting, "curves on a tube's face leave no way between them");
    }
  }

  std::uint32_t add_corner(std::uint32_t corner, const Vec2& place) {
    corners_.push_back(corner);
    places_.push_back(place);
    return std::uint32_t(corners_.size() - 1);
  }

  // The curve once around from a corner, both copies of which belong to the outer polygon.
  void append(const Curve& curve, std::size_t first, double x) {
    polygons_.resize(1);
    Vec2 place(x, 0);
    for (std::size_t i = 0; i <= curve.corners.size(); ++i) {
      const std::size_t at = (first + i) % curve.corners.size();
      place.y() = curve.places[at].y();
      if (i == curve.corners.size()) {
        place.x() = x + around_;
      } else {
        place.x() += std::remainder(curve.places[at].x() - place.x(), around_);
      }
      polygons_.front().push_back(add_corner(curve.corners[at], place));
    }
  }

  void append_hole(const Curve& hole) {
    const Vec2& place = hole.places.front();
    const double share = (place.y() - cut_at_[0].y()) / (cut_at_[1].y() - cut_at_[0].y());
    const double cut = cut_at_[0].x() + share * (cut_at_[1].x() - cut_at_[0].x());
    const double shift = around_ * std::ceil((cut - place.x()) / around_);
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

  static constexpr double kNear = 1e-9;  // of a segment
  const Curve &lower_, &upper_;
  double around_;
  std::vector<const Curve*> holes_;
  std::array<std::size_t, 2> cut_{};  // its corners of lower and upper
  std::array<Vec2, 2> cut_at_;
  std::vector<std::uint32_t> corners_;  // what the triangulation's points are
  std::vector<Vec2> places_;
  std::vector<std::vector<std::uint32_t>> polygons_;
  std::map<std::uint32_t, std::uint32_t> in_hole_;
};

class Trimmer {
 public:
  Trimmer(const TrimmedFace& face, const RingSampling& sampling)
      : face_(face), sampling_(sampling), chart_(face, sampling) {}

  Tessellation run() {
    if (face_.keeps_start) {
      append_row(sample(flipped(face_.start), sampling_));
    }
    for (const auto& curve : face_.curves) {
      append_curve(curve);
    }
    if (face_.keeps_end) {
      append_row(sample(face_.end, sampling_));
    }
    for (const Vec3& point : result_.mesh.points) {
      places_.push_back(chart_.place(point));
    }
    triangulate();
    result_.error_bound = error();
    return std::move(result_);
  }

 private:
  using Corners = std::vector<std::uint32_t>;

  void append_row(const std::vector<Vec3>& points) {
    Corners corners(points.size());
    std::iota(corners.begin(), corners.end(), std::uint32_t(result_.mesh.points.size()));
    result_.mesh.points.insert(result_.mesh.points.end(), points.begin(), points.end());
    polygons_.push_back(std::move(corners));
  }

  void append_curve(const std::vector<Vec3>& curve) {
    Corners corners;
    for (const Vec3& point : curve) {
      const double height = chart_.height(point);
      if ((face_.keeps_start && !(height > 0)) || (face_.keeps_end && !(height < 1))) {
        throw Error(Errc::self_intersecting, "a curve leaves the face that it trims");
      }
      const auto [entry, is_new] =
          vertex_at_.try_emplace(point, std::uint32_t(result_.mesh.points.size()));
      if (is_new) {
        result_.mesh.points.push_back(point);
      }
      corners.push_back(entry->second);
    }
    polygons_.push_back(std::move(corners));
  }

  // Curves about the axis, from the start on, bound strips by twos; the others are holes in these.
  void triangulate() {
    std::vector<Curve> around, holes;
    for (Corners& corners : polygons_) {
      Curve curve = unrolled(std::move(corners), places_, chart_.around());
      (curve.turns == 0 ? holes : around).push_back(std::move(curve));
    }
    std::ranges::stable_sort(around, {}, [](const Curve& curve) {
      return std::ranges::min(curve.places, {}, [](const Vec2& p) { return p.y(); }).y();
    });
    if (around.size() % 2 != 0) {
      throw Error(Errc::self_intersecting, "the curves on a tube's face do not bound it");
    }
    std::vector<Strip> strips;
    for (std::size_t i = 0; i < around.size(); i += 2) {
      strips.emplace_back(around[i], around[i + 1], chart_.around());
    }
    for (const Curve& hole : holes) {
      const auto strip =
          std::ranges::find_if(strips, [&](const Strip& s) { return s.contains(hole); });
      if (strip == strips.end()) {
        throw Error(Errc::self_intersecting, "a curve on a tube's face is not between its ends");
      }
      strip->add(hole);
    }
    for (Strip& strip : strips) {
      strip.append_triangles(result_.mesh.triangles);
    }
  }

  // The widest angle that a triangle spans.
  [[nodiscard]] double error() const {
    double widest = 0;
    for (const Triangle& triangle : result_.mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double turn = places_[triangle.at(i)].x() - places_[triangle.at((i + 1) % 3)].x();
        widest = std::max(widest, std::abs(std::remainder(turn, chart_.around())));
      }
    }
    const double radius = std::max(face_.start.radius, face_.end.radius);
    const double half = std::sin(widest / chart_.around() * kTurn / 4);
    return 2 * radius * half * half +
           point_error(face_.start.center.norm() + face_.end.center.norm() + 2 * radius,
                       sampling_.grid);
  }

  const TrimmedFace& face_;
  const RingSampling& sampling_;
  Chart chart_;
  std::map<Vec3, std::uint32_t, numbers::PointOrder> vertex_at_;
  std::vector<Corners> polygons_;
  std::vector<Vec2> places_;
  Tessellation result_;
};

}  // namespace

Tessellation trimmed_face(const TrimmedFace& face, const RingSampling& sampling) {
  return Trimmer(face, sampling).run();
}

}  // namespace dupin::tessellation
