#include "part_geometry.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "cyclide_part.h"
#include "decimal.h"
#include "dupin/blends/cyclide_blend.h"
#include "dupin/kernel/error.h"

namespace dupin::detail {
namespace {

// Numbers of a document stay within these bounds, so that the sixth powers in the regularity proofs
// neither overflow nor vanish.
constexpr double kLargest = 1e12, kSmallest = 1e-12;

// A vector whose part across another one is, relatively, no larger than this has none but what
// rounding made of it: a few units of 2^-53, and what the coordinates' own last digits leave.
constexpr double kNoDirection = 0x1p-40;

// +0 for -0, so that equal vectors are equal bitwise.
Vec3 plain(const Vec3& v) { return v.array() + 0.0; }

Vec3 opposite(const Vec3& v) { return Vec3::Zero() - v; }

class Geometry {
 public:
  explicit Geometry(const PartContext& context) : context_(context) {}

  RingedSurface operator()(const PipeBetween& pipe) const {
    positive(pipe.radius, "radius");
    return line(start_between(pipe.from, pipe.to, pipe.radius), pipe.to, pipe.radius);
  }

  RingedSurface operator()(const PipeAlong& pipe) const {
    const Ring start = origin(pipe.from, "radius");
    positive(pipe.length, "length");
    return line(start, start.center + pipe.length * opposite(start.normal), start.radius);
  }

  RingedSurface operator()(const PipeTo& pipe) const {
    const Ring start = origin(pipe.from, "radius");
    finite(pipe.to, "to");
    const Vec3 travel = opposite(start.normal), chord = pipe.to - start.center;
    const double length = chord.dot(travel), aside = (chord - length * travel).norm();
    if (!(length > 0)) {
      fail("to", "the point must lie ahead of '" + to_string(pipe.from) + "', not " +
                     decimal(-length) + " behind it");
    }
    within_tolerance(aside, "to", "the point is " + decimal(aside) + " off the pipe's axis");
    return line(start, start.center + length * travel, start.radius);
  }

  RingedSurface operator()(const ConeBetween& cone) const {
    positive(cone.start_radius, "radii/0");
    positive(cone.end_radius, "radii/1");
    return coned(
        line(start_between(cone.from, cone.to, cone.start_radius), cone.to, cone.end_radius));
  }

  RingedSurface operator()(const ConeAlong& cone) const {
    const Ring start = origin(cone.from, "radii/0");
    positive(cone.length, "length");
    const bool own_start = std::holds_alternative<Place>(cone.from);
    positive(cone.end_radius, own_start ? "radii/1" : "end_radius");
    const auto surface =
        line(start, start.center + cone.length * opposite(start.normal), cone.end_radius);
    return own_start ? coned(surface) : surface;
  }

  RingedSurface operator()(const ElbowTurning& elbow) const {
    const Ring start = origin(elbow.from, "radius");
    positive(elbow.bend_radius, "bend_radius");
    if (!(elbow.angle > 0 && elbow.angle < 2 * std::numbers::pi)) {
      fail("angle", "an elbow's angle must lie between 0 and 360 degrees, not at " +
                        decimal(elbow.angle / std::numbers::pi * 180));
    }
    finite(elbow.toward, "toward");
    const Vec3 travel = opposite(start.normal);
    const Vec3 across = elbow.toward - elbow.toward.dot(travel) * travel;
    if (!(across.norm() > kNoDirection * elbow.toward.norm())) {
      fail("toward", "the direction must have a part across the direction of travel");
    }
    const Vec3 inward = across.normalized();
    const auto [cosine, sine] = cosine_and_sine(elbow.angle);
    const Vec3 end = start.center + elbow.bend_radius * (1 - cosine) * inward +
                     elbow.bend_radius * sine * travel;
    return arc(start, {end, plain(cosine * travel + sine * inward), start.radius}, inward,
               elbow.bend_radius, elbow.angle);
  }

  RingedSurface operator()(const ElbowTo& elbow) const {
    return elbow_to(origin(elbow.from, "radius"), elbow.to);
  }

  // Both legs subtend half the angle a from the bend's centre: leg = bend radius tan(a / 2), and
  // tan(a / 2) = sin a / (1 + cos a). The direction at the end comes from the corner alone, so that
  // roundings of a long line's coordinates do not add up.
  RingedSurface operator()(const ElbowCorner& elbow) const {
    finite(elbow.corner, "corner");
    finite(elbow.to, "to");
    const Ring start = origin(elbow.from, "radius");
    const Vec3 travel = opposite(start.normal), to_corner = elbow.corner - start.center;
    const double first = to_corner.dot(travel), second = (elbow.to - elbow.corner).norm();
    const double aside = (to_corner - first * travel).norm();
    within_tolerance(aside, "corner", "the corner is " + decimal(aside) + " off the axis");
    within_tolerance(
        std::abs(first - second), "corner",
        "the legs from the corner are " + decimal(first) + " and " + decimal(second) + " long");
    if (!(second >= kSmallest)) {
      fail("to", "the point must differ from the one at 'corner'");
    }
    const Vec3 leaving = (elbow.to - elbow.corner).normalized();
    const double cosine = travel.dot(leaving);
    const Vec3 across = leaving - cosine * travel;
    const double sine = across.norm();
    if (!(sine > kNoDirection)) {
      fail("to", "the corner is none: both legs lie on one line");
    }
    const Ring end{plain(start.center + second * (travel + leaving)), plain(leaving), start.radius};
    return arc(start, end, across / sine, second * (1 + cosine) / sine, std::atan2(sine, cosine));
  }

  Sphere operator()(const SphereAt& sphere) const {
    finite(sphere.center, "center");
    positive(sphere.radius, "radius");
    return {sphere.center, sphere.radius};
  }

  RingedSurface operator()(const CyclicBlendBetween& blend) const {
    if (blend.options.k) {
      positive(*blend.options.k, "k");
    }
    if (blend.options.l) {
      positive(*blend.options.l, "l");
    }
    return cyclic_blend(context_.ring(blend.from), context_.ring(blend.to), blend.options);
  }

  PartSurface operator()(const CyclideBlendBetween& blend) const {
    const Ring &from = context_.ring(blend.from), &to = context_.ring(blend.to);
    try {
      return cyclide_blend(from, to);
    } catch (const Error& error) {
      if (error.code() != Errc::infeasible_blend) {
        throw;
      }
      return cyclic_blend(from, to);
    }
  }

  CyclideTube operator()(const CyclideChainThrough& chain) const {
    return cyclide_chain(context_, chain);
  }

  Sphere operator()(const CapAt&) const { return {}; }  // caps are resolved as names of ends

 private:
  [[noreturn]] void fail(std::string_view key, const std::string& message) const {
    const auto& [assembly, index, ring] = context_;
    throw Error(Errc::invalid_argument, message, assembly.parts.at(index).name,
                document_place(assembly, index, key));
  }

  void positive(double value, std::string_view key) const {
    if (!(value >= kSmallest && value <= kLargest)) {
      fail(key, "must be a positive number between 1e-12 and 1e12, not " + decimal(value));
    }
  }

  void finite(const Vec3& v, std::string_view key) const {
    if (!(v.cwiseAbs().maxCoeff() <= kLargest) || v.hasNaN()) {
      fail(key, "coordinates must be finite numbers of at most 1e12");
    }
  }

  void within_tolerance(double deviation, std::string_view key, const std::string& what) const {
    const double tolerance = context_.assembly.tolerance;
    if (!(deviation <= tolerance)) {
      fail(key, what + ", more than the tolerance of " + decimal(tolerance) + " allows");
    }
  }

  Ring start_between(const Vec3& from, const Vec3& to, double radius) const {
    finite(from, "from");
    finite(to, "to");
    if (!((to - from).norm() >= kSmallest)) {
      fail("to", "the point must differ from the one at 'from'");
    }
    return {from, opposite((to - from).normalized()), radius};
  }

  Ring origin(const PartStart& from, std::string_view radius_key) const {
    if (const auto* port = std::get_if<PortReference>(&from)) {
      return flipped(context_.ring(*port));
    }
    const auto& place = std::get<Place>(from);
    finite(place.point, "from");
    finite(place.direction, "direction");
    positive(place.radius, radius_key);
    if (!(place.direction.norm() >= kSmallest)) {
      fail("direction", "the direction must not be zero");
    }
    return {place.point, opposite(place.direction.normalized()), place.radius};
  }

  static RingedSurface line(const Ring& start, const Vec3& to, double end_radius) {
    const double slope = (end_radius - start.radius) / (to - start.center).norm();
    const Ring end{plain(to), opposite(start.normal), end_radius, slope};
    const RadiusLaw law = end_radius == start.radius ? RadiusLaw(ConstantRadius{end_radius})
                                                     : LinearRadius{start.radius, end_radius};
    return {start, end, LineSpine{start.center, end.center}, law};
  }

  // A cone whose start ring is its own knows its half angle at both ends.
  static RingedSurface coned(RingedSurface cone) {
    cone.start.slope = 0 - cone.end.slope;
    return cone;
  }

  static RingedSurface arc(const Ring& start, const Ring& end, const Vec3& inward,
                           double bend_radius, double angle) {
    const Vec3 axis = opposite(start.normal).cross(inward).normalized();
    return {start, end, ArcSpine{start.center + bend_radius * inward, axis, start.center, angle},
            ConstantRadius{start.radius}};
  }

  // With e = to - start.center = p travel + q inward, the chord turns by half the angle:
  // tan(angle / 2) = q / p, bend radius = (p^2 + q^2) / (2 q).
  RingedSurface elbow_to(const Ring& start, const Vec3& to) const {
    finite(to, "to");
    const Vec3 travel = opposite(start.normal), chord = to - start.center;
    const double p = chord.dot(travel);
    const Vec3 across = chord - p * travel;
    const double q = across.norm();
    if (!(q > kNoDirection * chord.norm())) {
      fail("to", "the point lies on the axis; a pipe leads there");
    }
    const Vec3 inward = across / q;
    const double squared = p * p + q * q;
    const double cosine = (p * p - q * q) / squared, sine = 2 * p * q / squared;
    const Ring end{to, plain(cosine * travel + sine * inward), start.radius};
    return arc(start, end, inward, squared / (2 * q), 2 * std::atan2(q, p));
  }

  // Exact for quarter turns, which documents mean exactly.
  static std::pair<double, double> cosine_and_sine(double angle) {
    constexpr double kQuarter = std::numbers::pi / 2;
    for (int turns = 1; turns <= 3; ++turns) {
      if (angle == turns * kQuarter) {
        return {turns == 2 ? -1 : 0, turns == 2 ? 0 : 2 - turns};
      }
    }
    return {std::cos(angle), std::sin(angle)};
  }

  const PartContext& context_;
};

}  // namespace

PartSurface geometry(const PartContext& context) {
  return std::visit([&](const auto& shape) -> PartSurface { return Geometry(context)(shape); },
                    context.assembly.parts.at(context.index).shape);
}

}  // namespace dupin::detail
