#include "assembly/part_geometry.h"

#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "assembly/cyclide_part.h"
#include "assembly/line_and_arc.h"
#include "dupin/blends/cyclide_blend.h"
#include "dupin/blends/two_cone_spine.h"
#include "dupin/kernel/error.h"
#include "numbers/decimal.h"

namespace dupin::assembly {
namespace {

// Numbers of a document stay within these bounds, so that the sixth powers in the regularity proofs
// neither overflow nor vanish.
constexpr double kLargest = 1e12, kSmallest = 1e-12;

// A vector whose part across another one is, relatively, no larger than this has none but what
// rounding made of it: a few units of 2^-53, and what the coordinates' own last digits leave.
constexpr double kNoDirection = 0x1p-40;

class Geometry {
 public:
  explicit Geometry(const PartContext& context) : context_(context) {}

  PartSurface operator()(const PipeBetween& pipe) const {
    return cylinder(start_between(pipe.from, pipe.to, pipe.radius, pipe.axes, kSection), pipe.to);
  }

  PartSurface operator()(const PipeAlong& pipe) const {
    const Ring start = origin(pipe.from, kSection);
    positive(pipe.length, "length");
    return cylinder(start, start.center + pipe.length * opposite(start.normal));
  }

  PartSurface operator()(const PipeTo& pipe) const {
    const Ring start = origin(pipe.from, kSection);
    finite(pipe.to, "to");
    const Vec3 travel = opposite(start.normal), chord = pipe.to - start.center;
    const double length = chord.dot(travel), aside = (chord - length * travel).norm();
    if (!(length > 0)) {
      fail("to", "the point must lie ahead of '" + to_string(pipe.from) + "', not " +
                     numbers::decimal(-length) + " behind it");
    }
    within_tolerance(aside, "to",
                     "the point is " + numbers::decimal(aside) + " off the pipe's axis");
    return cylinder(start, start.center + length * travel);
  }

  PartSurface operator()(const ConeBetween& cone) const {
    const Ring start =
        start_between(cone.from, cone.to, cone.start_radius, cone.start_axes, kConeSection);
    const EndSection end = end_section(start, cone.end_radius, cone.end_across, {}, true);
    return line(start, cone.to, end, true);
  }

  PartSurface operator()(const ConeAlong& cone) const {
    const Ring start = origin(cone.from, kConeSection);
    positive(cone.length, "length");
    const bool own_start = std::holds_alternative<Place>(cone.from);
    const EndSection end =
        end_section(start, cone.end_radius, cone.end_across, cone.axis, own_start);
    return line(start, start.center + cone.length * opposite(start.normal), end, own_start);
  }

  PartSurface operator()(const ObliqueBetween& part) const {
    finite(part.from, "from");
    finite(part.to, "to");
    finite(part.normal, "normal");
    positive(part.start_radius, "radii/0");
    positive(part.end_radius, "radii/1");
    return oblique_tube(part.from, part.to, part.normal, part.start_radius, part.end_radius);
  }

  PartSurface operator()(const ElbowTurning& elbow) const {
    const Ring start = origin(elbow.from, kSection);
    positive(elbow.bend_radius, "bend_radius");
    if (!(elbow.angle > 0 && elbow.angle < 2 * std::numbers::pi)) {
      fail("angle", "an elbow's angle must lie between 0 and 360 degrees, not at " +
                        numbers::decimal(elbow.angle / std::numbers::pi * 180));
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

  PartSurface operator()(const ElbowTo& elbow) const {
    return elbow_to(origin(elbow.from, kSection), elbow.to);
  }

  // Both legs subtend half the angle a from the bend's centre: leg = bend radius tan(a / 2), and
  // tan(a / 2) = sin a / (1 + cos a). The direction at the end comes from the corner alone, so that
  // roundings of a long line's coordinates do not add up.
  PartSurface operator()(const ElbowCorner& elbow) const {
    finite(elbow.corner, "corner");
    finite(elbow.to, "to");
    const Ring start = origin(elbow.from, kSection);
    const Vec3 travel = opposite(start.normal), to_corner = elbow.corner - start.center;
    const double first = to_corner.dot(travel), second = (elbow.to - elbow.corner).norm();
    const double aside = (to_corner - first * travel).norm();
    within_tolerance(aside, "corner", "the corner is " + numbers::decimal(aside) + " off the axis");
    within_tolerance(std::abs(first - second), "corner",
                     "the legs from the corner are " + numbers::decimal(first) + " and " +
                         numbers::decimal(second) + " long");
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

  PartSurface operator()(const SplineBetween& spline) const {
    check(spline.through);
    return Chain(
        spline_pipe(right_end(spline.from, "from"), spline.through, right_end(spline.to, "to")));
  }

  PartSurface operator()(const SplineRound& spline) const {
    check(spline.through);
    return Chain(closed_spline_pipe(spline.through), true);
  }

  PartSurface operator()(const CyclicBlendBetween& blend) const {
    check_speeds(blend.options.k, blend.options.l);
    const Ring &from = right_end(blend.from, "from"), &to = right_end(blend.to, "to");
    if (from.ellipse || to.ellipse) {
      return elliptic_blend(from, to, blend.options);
    }
    return cyclic_blend(from, to, blend.options);
  }

  PartSurface operator()(const TwoConeBlendBetween& blend) const {
    const Ring &from = right_end(blend.from, "from"), &to = right_end(blend.to, "to");
    positive(blend.reach[0], "reach/0");
    positive(blend.reach[1], "reach/1");
    for (std::size_t i = 0; i < 3; ++i) {
      positive(blend.m.at(i), "m/" + std::to_string(i));
      positive(blend.w.at(i), "w/" + std::to_string(i));
    }
    for (const auto& [ring, key] : {std::pair(&from, "from"), std::pair(&to, "to")}) {
      if (ring->slope != 0 || across_slope(*ring) != 0) {
        fail(key, "a blend on the spine of two cones goes on from cylinders only, not from a cone");
      }
    }
    const Spine spine = two_cone_spine({from.center, from.center + blend.reach[0] * from.normal,
                                        to.center + blend.reach[1] * to.normal, to.center},
                                       blend.m, blend.w);
    const Ring start = flipped(from), end = flipped(to);
    if (from.ellipse || to.ellipse) {
      return elliptic_tube(start, end, spine, CubicRadius{from.radius, to.radius},
                           CubicRadius{across(from), across(to)});
    }
    return RingedSurface{start, end, spine, CubicRadius{from.radius, to.radius}};
  }

  PartSurface operator()(const RingedBlendBetween& blend) const {
    check_speeds(blend.k, blend.l);
    return ringed_blend_part(context_, blend);
  }

  PartSurface operator()(const CyclideBlendBetween& blend) const {
    const Ring &from = right_end(blend.from, "from"), &to = right_end(blend.to, "to");
    CyclideSearch search = search_cyclide_blend(from, to);
    if (search.tube) {
      return *search.tube;
    }
    try {
      return cyclic_blend(from, to);
    } catch (const Error& error) {
      if (error.code() != Errc::infeasible_blend) {
        throw;
      }
      std::string reasons;
      for (const std::string& reason : search.rejected) {
        reasons += reason + "; ";
      }
      throw Error(error.code(),
                  "no blend joins these ends. " + reasons + "ringed: " + error.message());
    }
  }

  PartSurface operator()(const CyclideChainThrough& chain) const {
    return cyclide_chain(context_, chain);
  }

  Sphere operator()(const CapAt&) const { return {}; }  // caps are resolved as names of ends

 private:
  [[noreturn]] void fail(std::string_view key, const std::string& message) const {
    const auto& [assembly, index, ring, motion] = context_;
    throw Error(Errc::invalid_argument, message, assembly.parts.at(index).name,
                document_place(assembly, index, key));
  }

  void positive(double value, std::string_view key) const {
    if (!(value >= kSmallest && value <= kLargest)) {
      fail(key, "must be a positive number between 1e-12 and 1e12, not " + numbers::decimal(value));
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
      fail(key, what + ", more than the tolerance of " + numbers::decimal(tolerance) + " allows");
    }
  }

  // The ring of a port whose part ends in a right cylinder or cone, or another canal surface of its
  // slope q: d' across n is -q rho n' [BL15]. Rounding leaves some ulp of the unit speed.
  const Ring& right_end(const PortReference& port, std::string_view key) const {
    const Ring& ring = context_.ring(port);
    const MovingRing motion = context_.motion(port);
    const double advance = motion.center_rate.dot(motion.normal);
    const Vec3 aside = motion.center_rate - advance * motion.normal +
                       ring.slope * ring.radius * motion.normal_rate;
    if (!(aside.norm() <= kNoDirection)) {
      fail(key, "'" + to_string(port) +
                    "' ends an oblique cylinder or cone; only a ringed_blend goes on from there");
    }
    return ring;
  }

  void check(const std::vector<Waypoint>& through) const {
    for (std::size_t i = 0; i < through.size(); ++i) {
      const std::string key = "through/" + std::to_string(i);
      finite(through[i].point, key + "/point");
      positive(through[i].radius, key + "/radius");
    }
  }

  void check_speeds(const std::optional<double>& k, const std::optional<double>& l) const {
    if (k) {
      positive(*k, "k");
    }
    if (l) {
      positive(*l, "l");
    }
  }

  // The keys under which a document has a section's numbers.
  struct SectionKeys {
    std::string_view radius, first, across;
  };
  static constexpr SectionKeys kSection{"radius", "semi_axes/0", "semi_axes/1"};
  static constexpr SectionKeys kConeSection{"radii/0", "semi_axes/0/0", "semi_axes/0/1"};

  // The axis of an ellipse in the planes across `normal`, from a direction that need not be so.
  Vec3 axis_across(const Vec3& normal, const Vec3& direction) const {
    finite(direction, "axis");
    const Vec3 across = direction - direction.dot(normal) * normal;
    if (!(across.norm() > kNoDirection * direction.norm())) {
      fail("axis", "the axis must have a part across the direction of travel");
    }
    return plain(across.normalized());
  }

  Ring start_ring(const Vec3& center, const Vec3& travel, double radius,
                  const std::optional<SectionAxes>& axes, const SectionKeys& keys) const {
    positive(radius, axes ? keys.first : keys.radius);
    Ring ring{center, opposite(travel.normalized()), radius};
    if (axes) {
      positive(axes->across, keys.across);
      ring.ellipse = Ellipse{axis_across(ring.normal, axes->axis), axes->across};
    }
    return ring;
  }

  Ring start_between(const Vec3& from, const Vec3& to, double radius,
                     const std::optional<SectionAxes>& axes, const SectionKeys& keys) const {
    finite(from, "from");
    finite(to, "to");
    if (!((to - from).norm() >= kSmallest)) {
      fail("to", "the point must differ from the one at 'from'");
    }
    return start_ring(from, to - from, radius, axes, keys);
  }

  Ring origin(const PartStart& from, const SectionKeys& keys) const {
    if (const auto* port = std::get_if<PortReference>(&from)) {
      return flipped(context_.ring(*port));
    }
    const auto& place = std::get<Place>(from);
    finite(place.point, "from");
    finite(place.direction, "direction");
    if (!(place.direction.norm() >= kSmallest)) {
      fail("direction", "the direction must not be zero");
    }
    return start_ring(place.point, place.direction, place.radius, place.axes, keys);
  }

  EndSection end_section(const Ring& start, double radius, const std::optional<double>& across,
                         const std::optional<Vec3>& axis, bool own_start) const {
    positive(radius, across ? (own_start ? "semi_axes/1/0" : "end_semi_axes/0")
                            : (own_start ? "radii/1" : "end_radius"));
    if (!across) {
      return {radius, std::nullopt};
    }
    positive(*across, own_start ? "semi_axes/1/1" : "end_semi_axes/1");
    if (start.ellipse && axis) {
      fail("axis", "the cone begins in an ellipse, whose axis it keeps");
    }
    if (!start.ellipse && !axis) {
      fail("end_semi_axes",
           "the cone begins in a circle; say by an 'axis' which way the ellipse "
           "that it ends in lies");
    }
    return {radius, Ellipse{start.ellipse ? start.ellipse->axis : axis_across(start.normal, *axis),
                            *across}};
  }

  // With e = to - start.center = p travel + q inward, the chord turns by half the angle:
  // tan(angle / 2) = q / p, bend radius = (p^2 + q^2) / (2 q).
  PartSurface elbow_to(const Ring& start, const Vec3& to) const {
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

  const PartContext& context_;
};

}  // namespace

PartSurface geometry(const PartContext& context) {
  return std::visit([&](const auto& shape) -> PartSurface { return Geometry(context)(shape); },
                    context.assembly.parts.at(context.index).shape);
}

}  // namespace dupin::assembly
