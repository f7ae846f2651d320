#include "verification/admitted.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"

namespace dupin::verification {
namespace {

constexpr double kLargestAngle = 64;    // some turns
constexpr double kUnitSlack = 0x1p-30;  // far above rounding

using Limits = CertificateLimits;

class Reader {
 public:
  explicit Reader(const std::string& part) : part_(part) {}

  void operator()(const Sphere& s) const {
    point(s.center);
    positive(s.radius, "radius");
  }

  void operator()(const Chain& s) const {
    require(is_bound(s.wall), "wall");
    if (s.joints == Joints::spherical) {
      return;  // nothing is said of its pieces
    }
    for (const Piece& piece : s.pieces) {
      // Nothing would be claimed of the inner skins of other pieces.
      require(s.wall == 0 || std::holds_alternative<CyclidePiece>(piece), "wall");
      std::visit(*this, piece);
    }
  }

  void operator()(const RingedSurface& s) const {
    ring(s.start);
    ring(s.end);
    std::visit(*this, s.spine);
    std::visit(*this, s.radius);
  }

  void operator()(const EllipticTube& s) const {
    (*this)(RingedSurface{s.start, s.end, s.spine, s.first});
    std::visit(*this, s.second);
  }

  void operator()(const CyclidePiece& s) const {
    ring(s.start);
    ring(s.end);
    for (const PeVector& sphere : {s.first, s.tangent, s.last}) {
      point(sphere.m);
      number(sphere.r);
    }
    positive(s.chord, "chord");
  }

  void operator()(const RationalRingedTube& s) const {
    ring(s.start);
    ring(s.end);
    for (const Vec3& center : s.surface.center) {
      point(center);
    }
    for (const double radius : s.surface.radius) {
      number(radius);
    }
    require(s.surface.rotation.size() >= 2, "rotation");
    require(s.surface.rotation.size() <= Limits::coefficients, "degree");
    for (const auto& control : s.surface.rotation) {
      std::for_each(control.begin(), control.end(), [this](double x) { number(x); });
    }
  }

  void operator()(const LineSpine& s) const {
    point(s.from);
    point(s.to);
  }

  void operator()(const ArcSpine& s) const {
    point(s.center);
    point(s.start);
    direction(s.axis);
    const Vec3 spoke = s.start - s.center;
    require(
        std::abs(s.axis.dot(spoke)) <= kUnitSlack * spoke.stableNorm() && spoke.stableNorm() > 0,
        "axis");
    require(s.angle > 0 && s.angle <= kLargestAngle, "angle");
  }

  void operator()(const HermiteSpine& s) const {
    for (const Vec3& v : {s.from, s.to, s.start_velocity, s.end_velocity}) {
      point(v);
    }
  }

  void operator()(const BezierSpine& s) const {
    require(s.points.size() >= 2 && s.points.size() <= Limits::coefficients, "degree");
    std::for_each(s.points.begin(), s.points.end(), [this](const Vec3& p) { point(p); });
    require(s.weights.empty() || s.weights.size() == s.points.size(), "weights");
    for (const double weight : s.weights) {
      require(weight >= 1 / Limits::weight && weight <= Limits::weight, "weights");
    }
  }

  void operator()(const ConstantRadius& r) const { positive(r.radius, "radius"); }
  void operator()(const LinearRadius& r) const { ends(r.start, r.end); }
  void operator()(const CubicRadius& r) const { ends(r.start, r.end); }
  void operator()(const CyclideRadius& r) const { ends(r.start, r.end); }
  void operator()(const BezierRadius& r) const {
    require(!r.coefficients.empty() && r.coefficients.size() <= Limits::coefficients, "degree");
    std::for_each(r.coefficients.begin(), r.coefficients.end(), [this](double x) { number(x); });
  }

 private:
  void require(bool holds, const std::string& what) const {
    if (!holds) {
      throw Error(Errc::invalid_argument,
                  "the claim '" + what + "' does not follow: the shape's numbers are out of range",
                  part_, "certificate");
    }
  }
  void number(double x) const { require(std::abs(x) <= Limits::number, "largest number"); }
  void positive(double x, const std::string& what) const {
    number(x);
    require(x > 0, what);
  }
  void point(const Vec3& p) const { require(is_point(p), "largest number"); }
  void direction(const Vec3& v) const {
    point(v);
    require(std::abs(v.stableNorm() - 1) <= kUnitSlack, "length of a direction");
  }
  void ends(double start, double end) const {
    positive(start, "radius");
    positive(end, "radius");
  }
  void ring(const Ring& r) const {
    point(r.center);
    direction(r.normal);
    positive(r.radius, "radius");
    number(r.slope);
    if (r.ellipse) {
      direction(r.ellipse->axis);
      require(std::abs(r.ellipse->axis.dot(r.normal)) <= kUnitSlack, "axis");
      positive(r.ellipse->across, "radius");
      number(r.ellipse->across_slope);
    }
  }

  const std::string& part_;
};

}  // namespace

AdmittedPart::AdmittedPart(const CertifiedPart& part) : part_(&part) {
  std::visit(Reader(part.name), part.shape);
}

bool is_parameter(double t, double length) {
  const double units = std::ldexp(t, 64);
  return t >= 0 && t <= length && units == std::floor(units);
}

bool is_stretch(const ParameterInterval& t, double length) {
  return is_parameter(t.from, length) && is_parameter(t.to, length) && t.from <= t.to;
}

bool is_point(const Vec3& point) {
  return std::all_of(point.begin(), point.end(),
                     [](double x) { return std::abs(x) <= Limits::number; });
}

bool is_bound(double number) { return number >= 0 && number <= Limits::number; }

bool is_name(const std::string& text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

}  // namespace dupin::verification
