#include "dupin/blends/ringed_blend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "assembly/parts/kept_clear.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

// Speeds that are tried, in chords between the ends, where none are given.
constexpr std::array<double, 9> kFactors{1, 0.8, 1.25, 0.6, 1.6, 0.45, 2, 0.3, 2.5};

// The speed up to which the radius' Bezier coefficient next to an end that the blend leaves
// narrowing is at least half of that end's radius, so that no thin neck appears.
double neck_limit(double radius, double narrowing) {
  return narrowing > 0 ? 1.5 * radius / narrowing : std::numeric_limits<double>::infinity();
}

// An end of the blend, its ring in the direction of travel.
struct BlendEnd {
  Ring port;          ///< the ring with its normal in the direction of travel
  MovingRing motion;  ///< at unit speed
  bool is_canal = true;
};

class RingedBlend {
 public:
  RingedBlend(const PartContext& context, const RingedBlendBetween& blend)
      : context_(context), blend_(blend) {}

  [[nodiscard]] RationalRingedTube made() const {
    const BlendEnd from = end(blend_.from, false), to = end(blend_.to, true);
    const double chord = (to.port.center - from.port.center).norm();
    if (!(chord > 0)) {
      throw Error(Errc::invalid_argument, "the blend's ends have the same centre; move them apart");
    }
    return {flipped(from.port), to.port, surface(from, to, chord)};
  }

 private:
  [[nodiscard]] BlendEnd end(const RingedBlendEnd& given, bool arriving) const {
    if (const auto* port = std::get_if<PortReference>(&given)) {
      const Ring& ring = context_.ring(*port);
      if (ring.ellipse) {
        fail(context_, arriving ? "to" : "from",
             "'" + to_string(*port) + "' is an ellipse; a ringed blend joins circles");
      }
      const MovingRing motion = context_.motion(*port);
      return {arriving ? flipped(ring) : ring, arriving ? reversed(motion) : motion,
              is_canal(motion, ring)};
    }
    const auto& free = std::get<FreeEnd>(given);
    const std::string key = arriving ? "to" : "from";
    if (!free.direction.allFinite() || !(free.direction.norm() > 0)) {
      fail(context_, key + "/direction", "the direction must be finite and not zero");
    }
    const TravelRing ring{free.center, free.direction.normalized(), free.radius};
    BlendEnd result{{ring.center, ring.normal, ring.radius}, {}, true};
    result.motion = std::visit([&](const auto& contact) { return motion(ring, contact, result); },
                               free.contact);
    return result;
  }

  // That of along_canal: nothing but the slope.
  static bool is_canal(const MovingRing& motion, const Ring& ring) {
    return motion.center_rate == ring.normal && motion.normal_rate.isZero(0);
  }

  static MovingRing motion(const TravelRing& ring, const CanalContact& canal, BlendEnd& end) {
    end.port.slope = canal.slope;
    return along_canal(ring, canal.slope, 1);
  }
  static MovingRing motion(const TravelRing& ring, const SphereContact& sphere, BlendEnd& end) {
    MovingRing result = along_sphere(ring, sphere.center, 1);
    end.port.slope = result.radius_rate;
    return result;
  }
  static MovingRing motion(const TravelRing& ring, const ObliqueConeContact& cone, BlendEnd& end) {
    end.is_canal = false;
    return along_oblique_cone(ring, cone.apex, 1);
  }
  static MovingRing motion(const TravelRing& ring, const ObliqueCylinderContact& cylinder,
                           BlendEnd& end) {
    end.is_canal = false;
    return along_oblique_cylinder(ring, cylinder.ruling, 1);
  }
  static MovingRing motion(const TravelRing& ring, const PlateContact& plate, BlendEnd& end) {
    end.is_canal = false;
    return along_plate(ring, plate.widening ? 1 : -1);
  }

  [[nodiscard]] RationalRingedSurface trial(const BlendEnd& from, const BlendEnd& to, double k,
                                            double l) const {
    if (!blend_.low_degree) {
      return ringed_blend(at_speed(from.motion, k), at_speed(to.motion, l));
    }
    const auto canal = [](const BlendEnd& end, double speed) {
      return CanalEnd{{end.port.center, end.port.normal, end.port.radius}, end.port.slope, speed};
    };
    return canal_ringed_blend(canal(from, k), canal(to, l));
  }

  [[nodiscard]] std::optional<Error> fault(const BlendEnd& from, const BlendEnd& to,
                                           const std::vector<avoidance::NamedObstacle>& obstacles,
                                           const RationalRingedSurface& surface) const {
    return blend_.avoid ? nearness(Chain(RationalRingedTube{flipped(from.port), to.port, surface}),
                                   obstacles, blend_.avoid->clearance)
                        : std::nullopt;
  }

  // The speeds nearest to the chord that work.
  [[nodiscard]] RationalRingedSurface surface(const BlendEnd& from, const BlendEnd& to,
                                              double chord) const {
    if (blend_.low_degree && !(from.is_canal && to.is_canal)) {
      fail(context_, "bidegree",
           "[5, 2] needs cylinders, cones or spheres at both ends; take [9, 2]");
    }
    const double most_k = neck_limit(from.port.radius, -from.motion.radius_rate);
    const double most_l = neck_limit(to.port.radius, to.motion.radius_rate);
    struct Pair {
      double k, l, cost;
    };
    std::vector<Pair> pairs;
    for (const double a : kFactors) {
      for (const double b : kFactors) {
        pairs.push_back({blend_.k.value_or(std::min(a * chord, most_k)),
                         blend_.l.value_or(std::min(b * chord, most_l)),
                         std::abs(std::log(a)) + std::abs(std::log(b))});
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.cost < b.cost; });
    std::vector<avoidance::NamedObstacle> obstacles;
    if (blend_.avoid) {
      obstacles = obstacles_of(context_, *blend_.avoid, {from.port.center, to.port.center});
    }
    if (blend_.k && blend_.l) {
      RationalRingedSurface only = trial(from, to, *blend_.k, *blend_.l);
      if (const auto near = fault(from, to, obstacles, only)) {
        throw *near;
      }
      return only;
    }
    std::optional<Error> too_near;
    for (const auto& [k, l, cost] : pairs) {
      try {
        RationalRingedSurface tried = trial(from, to, k, l);
        const auto near = fault(from, to, obstacles, tried);
        if (!near) {
          return tried;
        }
        too_near = too_near ? too_near : near;
      } catch (const Error& error) {
        if (error.code() != Errc::irregular_surface) {
          throw;
        }
      }
    }
    if (too_near) {
      throw Error(Errc::infeasible_blend,
                  "of all end speeds that were tried, the first with which it does not fold gives "
                  "a blend that is too near to what it avoids: " +
                      too_near->message() + "; ask for less clearance, or lead a spline round it");
    }
    throw Error(Errc::infeasible_blend,
                "no end speeds between 0.3 and 2.5 times the distance of the ends, " +
                    decimal(chord, kMessageDigits) +
                    ", give discs that do not overlap; move the ends apart, turn them towards each "
                    "other, or put a ring between");
  }

  const PartContext& context_;
  const RingedBlendBetween& blend_;
};

}  // namespace

template <>
struct PartRules<"ringed_blend"> {
  static constexpr bool kIsTangent = true;

  static References references(const RingedBlendBetween& blend) {
    References result;
    if (const auto* port = std::get_if<PortReference>(&blend.from)) {
      result.push_back({*port, "from", End::start});
    }
    if (const auto* port = std::get_if<PortReference>(&blend.to)) {
      result.push_back({*port, "to", End::end});
    }
    return result;
  }

  static std::vector<Need> needs(const RingedBlendBetween& blend) { return needs_of(blend.avoid); }

  static PartNotes notes(const RingedBlendBetween& blend, const PartSurface& surface) {
    return clearance_note(blend.avoid, surface);
  }

  static PartSurface geometry(const PartContext& context, const RingedBlendBetween& blend) {
    check_speeds(context, blend.k, blend.l);
    return RingedBlend(context, blend).made();
  }
};
template const PartKind& part_kind<"ringed_blend">();

}  // namespace dupin::assembly
