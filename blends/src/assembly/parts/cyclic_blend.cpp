#include "dupin/blends/cyclic_blend.h"

#include <string>
#include <vector>

#include "assembly/parts/kept_clear.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "avoidance/route.h"
#include "dupin/kernel/error.h"
#include "ringed/blend_shape.h"
#include "ringed/elliptic_blend.h"

namespace dupin::assembly {
namespace {

// A spline in place of the blend. What is wrong with its points is no news to who gave none.
Chain way_round(const Ring& from, const Ring& to,
                const std::vector<avoidance::NamedObstacle>& obstacles, double clearance,
                const Error& fault) {
  try {
    return Chain(avoidance::route(from, {}, to, obstacles, clearance).pipe);
  } catch (const Error& error) {
    const bool folds = error.code() == Errc::irregular_surface;
    if (!folds && error.code() != Errc::invalid_argument) {
      throw;
    }
    throw Error(
        fault.code(),
        fault.message() + "; a spline was to go round in its place, but " +
            (folds ? "the one from end to end, which that begins with, folds, and no straight "
                     "pipes and elbows were found either"
                   : "there is none: " + error.message()) +
            "; what may help is less clearance, what is in the way elsewhere, ends moved "
            "or turned, or a spline with points of its own in \"through\"");
  }
}

// Of end speeds that would be proposed.
ringed::BlendFault too_near(const std::vector<avoidance::NamedObstacle>& obstacles,
                            double clearance) {
  return [&obstacles, clearance](const RingedSurface& blend) -> std::optional<std::string> {
    const auto fault = nearness(Chain(blend), obstacles, clearance);
    return fault ? std::optional("is too near to what it avoids: " + fault->message())
                 : std::nullopt;
  };
}

}  // namespace

template <>
struct PartRules<"cyclic_blend"> {
  static constexpr bool kIsTangent = true;

  static References references(const CyclicBlendBetween& blend) {
    return between_ports(blend.from, blend.to);
  }

  static std::vector<Need> needs(const CyclicBlendBetween& blend) { return needs_of(blend.avoid); }

  static PartSurface geometry(const PartContext& context, const CyclicBlendBetween& blend) {
    check_speeds(context, blend.options.k, blend.options.l);
    const Ring &from = right_end(context, blend.from, "from"),
               &to = right_end(context, blend.to, "to");
    const auto between = [&](const ringed::BlendFault& also) {
      return from.ellipse || to.ellipse
                 ? Chain(ringed::elliptic_blend_without(from, to, blend.options, also))
                 : Chain(ringed::surrounding_blend(from, to, blend.options, also));
    };
    if (!blend.avoid) {
      return between({});
    }
    const double clearance = blend.avoid->clearance;
    const auto obstacles = obstacles_of(context, *blend.avoid, {from.center, to.center});
    Chain chain = between(too_near(obstacles, clearance));
    if (const auto fault = nearness(chain, obstacles, clearance)) {
      if (from.ellipse || to.ellipse) {
        throw *fault;
      }
      return way_round(from, to, obstacles, clearance, *fault);
    }
    return chain;
  }

  static PartNotes notes(const CyclicBlendBetween& blend, const PartSurface& surface) {
    return clearance_note(blend.avoid, surface);
  }
};
template const PartKind& part_kind<"cyclic_blend">();

}  // namespace dupin::assembly
