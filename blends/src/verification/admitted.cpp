#include "verification/admitted.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"
#include "dupin/kernel/printable.h"
#include "verification/piece.h"

namespace dupin::verification {
namespace {

constexpr double kLargestAngle = 64;    // some turns
constexpr double kUnitSlack = 0x1p-30;  // far above rounding

using Limits = CertificateLimits;

struct SpineReader {
  const Requirements& needs;

  void operator()(const LineSpine& s) const {
    needs.point(s.from);
    needs.point(s.to);
  }

  void operator()(const ArcSpine& s) const {
    needs.point(s.center);
    needs.point(s.start);
    needs.direction(s.axis);
    const Vec3 spoke = s.start - s.center;
    needs.require(
        std::abs(s.axis.dot(spoke)) <= kUnitSlack * spoke.stableNorm() && spoke.stableNorm() > 0,
        "axis");
    needs.require(s.angle > 0 && s.angle <= kLargestAngle, "angle");
  }

  void operator()(const HermiteSpine& s) const {
    for (const Vec3& v : {s.from, s.to, s.start_velocity, s.end_velocity}) {
      needs.point(v);
    }
  }

  void operator()(const BezierSpine& s) const {
    needs.require(s.points.size() >= 2 && s.points.size() <= Limits::kCoefficients, "degree");
    std::for_each(s.points.begin(), s.points.end(), [this](const Vec3& p) { needs.point(p); });
    needs.require(s.weights.empty() || s.weights.size() == s.points.size(), "weights");
    for (const double weight : s.weights) {
      needs.require(weight >= 1 / Limits::kWeight && weight <= Limits::kWeight, "weights");
    }
  }
};

struct RadiusReader {
  const Requirements& needs;

  void ends(double start, double end) const {
    needs.positive(start, "radius");
    needs.positive(end, "radius");
  }
  void operator()(const ConstantRadius& r) const { needs.positive(r.radius, "radius"); }
  void operator()(const LinearRadius& r) const { ends(r.start, r.end); }
  void operator()(const CubicRadius& r) const { ends(r.start, r.end); }
  void operator()(const CyclideRadius& r) const { ends(r.start, r.end); }
  void operator()(const BezierRadius& r) const {
    needs.coefficients(r.coefficients.size());
    std::for_each(r.coefficients.begin(), r.coefficients.end(),
                  [this](double x) { needs.number(x); });
  }
};

struct MotionReader {
  const Requirements& needs;

  void numbers(std::initializer_list<double> all) const {
    std::for_each(all.begin(), all.end(), [this](double x) { needs.number(x); });
  }
  void points(std::initializer_list<Vec3> all) const {
    std::for_each(all.begin(), all.end(), [this](const Vec3& p) { needs.point(p); });
  }
  void spheres(std::initializer_list<PeVector> all) const {
    std::for_each(all.begin(), all.end(), [this](const PeVector& s) {
      needs.point(s.m);
      needs.number(s.r);
    });
  }
  void operator()(const RollingThrough& m) const {
    points({m.origin, m.along, m.across, m.up});
    numbers({m.cosine, m.sine, m.distance, m.height, m.below, m.above, m.side, m.radius});
  }
  void operator()(const RollingPartly& m) const {
    points({m.origin, m.along, m.across, m.up});
    numbers({m.cosine, m.sine, m.distance, m.overlap, m.first, m.second, m.radius});
  }
  void operator()(const RollingOnCones& m) const {
    needs.ring(m.first);
    needs.ring(m.second);
    points({m.zero, m.quarter});
    numbers({m.side, m.radius});
  }
  void operator()(const RollingPartlyOnCones& m) const {
    needs.ring(m.first);
    needs.ring(m.second);
    points({m.zero, m.quarter});
    numbers({m.width, m.radius});
    std::for_each(m.rest.begin(), m.rest.end(), [this](double x) { needs.number(x); });
  }
  void operator()(const RationalCrossing& m) const {
    spheres({m.origin, m.along, m.across, m.e3, m.e4});
    numbers({m.cosine, m.sine, m.distance, m.side});
    numbers({m.size[0], m.size[1], m.size[2], m.size[3]});
  }
  void operator()(const RationalParallel& m) const {
    spheres({m.origin, m.ey, m.ez, m.nu1, m.nu2});
    numbers({m.half_distance, m.product, m.far_squared, m.near_squared});
  }
};

struct PartReader {
  const Requirements& needs;

  // Both pieces of a joint touch its ball, along circles that the wall does not reach.
  void knees(const Chain& s) const {
    const CyclidePiece* before = nullptr;
    for (const dupin::Piece& piece : s.pieces) {
      const auto* cyclide = std::get_if<CyclidePiece>(&piece);
      needs.require(cyclide != nullptr && !s.closed, "kneecaps");
      needs.require(
          before == nullptr || (before->last == cyclide->first && cyclide->first.r > s.wall),
          "kneecaps");
      before = cyclide;
    }
  }

  void operator()(const Sphere& s) const {
    needs.point(s.center);
    needs.positive(s.radius, "radius");
  }
  void operator()(const Chain& s) const {
    needs.require(is_bound(s.wall), "wall");
    if (s.joints == Joints::spherical) {
      knees(s);
    }
    for (const dupin::Piece& piece : s.pieces) {
      // Nothing would be claimed of the inner skins of other pieces.
      needs.require(s.wall == 0 || std::holds_alternative<CyclidePiece>(piece), "wall");
      admit(piece, needs);
    }
  }
};

}  // namespace

void Requirements::require(bool holds, const std::string& what) const {
  if (!holds) {
    throw Error(Errc::invalid_argument,
                "the claim '" + what + "' does not follow: the shape's numbers are out of range",
                part_, "certificate");
  }
}

void Requirements::number(double x) const {
  require(std::abs(x) <= Limits::kNumber, "largest number");
}

void Requirements::positive(double x, const std::string& what) const {
  number(x);
  require(x > 0, what);
}

void Requirements::point(const Vec3& p) const { require(is_point(p), "largest number"); }

void Requirements::direction(const Vec3& v) const {
  point(v);
  require(std::abs(v.stableNorm() - 1) <= kUnitSlack, "length of a direction");
}

void Requirements::ring(const Ring& r) const {
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

void Requirements::spine(const Spine& s) const { std::visit(SpineReader{*this}, s); }

void Requirements::radius(const RadiusLaw& r) const { std::visit(RadiusReader{*this}, r); }

void Requirements::coefficients(std::size_t count) const {
  require(count > 0 && count <= Limits::kCoefficients, "degree");
}

AdmittedPart::AdmittedPart(const CertifiedPart& part) : part_(&part) {
  std::visit(PartReader{Requirements(part.name)}, part.shape);
}

void admit(const CertifiedFillet& fillet) {
  const Requirements needs(fillet.name);
  for (const CanalFillet& loop : fillet.loops) {
    std::visit(MotionReader{needs}, loop.motion);
  }
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
                     [](double x) { return std::abs(x) <= Limits::kNumber; });
}

bool is_bound(double number) { return number >= 0 && number <= Limits::kNumber; }

bool is_name(const std::string& text) { return !has_controls(text); }

}  // namespace dupin::verification
