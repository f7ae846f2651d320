#include "dupin/blends/cyclic_blend.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "dupin/blends/regularity.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "numbers/quadrature.h"
#include "ringed/blend_crossing.h"
#include "ringed/blend_search.h"
#include "ringed/blend_shape.h"

namespace dupin {
namespace {

using ringed::BlendFault;

// How tightly chosen speeds are certified; the search aims this much above the asked margin.
constexpr double kCertificateWidth = 1e-8;

int spine_degree(const Ring& from, const Ring& to, const CyclicBlendOptions& options) {
  const bool cone =
      from.slope != 0 || to.slope != 0 || across_slope(from) != 0 || across_slope(to) != 0;
  return 3 + (cone ? 2 : 0) + (options.continuity == Continuity::g2 ? 2 : 0);
}

// Of the circles about elliptic ends.
ringed::EndRadii radii_about(const Ring& from, const Ring& to) {
  return {largest_radius(from), std::max(from.slope, across_slope(from)), largest_radius(to),
          std::max(to.slope, across_slope(to))};
}

// As far as the spine is straight at an end, the radius is that of the cone there.
BezierRadius cone_ended(const ringed::EndRadii& radii, double k, double l, int degree) {
  BezierRadius result;
  for (int i = 0; 2 * i < degree; ++i) {
    result.coefficients.push_back(radii.start + i * k * radii.start_slope / degree);
  }
  for (int i = degree / 2; i >= 0; --i) {
    result.coefficients.push_back(radii.end + i * l * radii.end_slope / degree);
  }
  return result;
}

RadiusLaw cylinder_ended(const ringed::EndRadii& radii, const CyclicBlendOptions& options) {
  if (options.radius_law == BlendLaw::r2) {
    return CyclideRadius{radii.start, radii.end};
  }
  return CubicRadius{radii.start, radii.end};
}

RingedSurface assembled(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                        double k, double l) {
  const HermiteSpine spine{from.center, to.center, k * from.normal, -l * to.normal};
  const int degree = spine_degree(from, to, options);
  const ringed::EndRadii radii = radii_about(from, to);
  if (degree > 3) {
    return {flipped(from), flipped(to), degree == 5 ? quintic_spine(spine) : septic_spine(spine),
            cone_ended(radii, k, l, degree)};
  }
  return {flipped(from), flipped(to), spine, cylinder_ended(radii, options)};
}

ringed::BlendSearch search(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                           const ringed::SpeedRange& range = ringed::kNearSpeeds) {
  const auto family = [=](double k, double l) { return assembled(from, to, options, k, l); };
  return {family, (to.center - from.center).norm(), options.k, options.l, range};
}

void require_positive(const std::optional<double>& speed, const std::string& name) {
  if (speed && !(std::isfinite(*speed) && *speed > 0)) {
    throw Error(Errc::invalid_argument, "the blend's " + name + " must be a positive number, not " +
                                            decimal(*speed, kMessageDigits));
  }
}

void validate(const Ring& from, const Ring& to, const CyclicBlendOptions& options) {
  validate(from);
  validate(to);
  require_positive(options.k, "k");
  require_positive(options.l, "l");
  if (!(options.margin >= 0 && options.margin < 1)) {
    throw Error(Errc::invalid_argument,
                "the blend's margin must be at least 0 and less than 1, not " +
                    decimal(options.margin, kMessageDigits));
  }
  if (options.radius_law == BlendLaw::r2 && spine_degree(from, to, options) > 3) {
    throw Error(Errc::invalid_argument,
                "the radius law R2 goes with tangent continuity between cylinders only; take R1");
  }
  if (from.center == to.center) {
    throw Error(Errc::invalid_argument, "the blend's ends have the same centre; move them apart");
  }
}

bool is_valid(const RingedSurface& surface, double margin) {
  return smallest_radius(surface.radius) > 0 &&
         prove_margin(surface, margin).verdict == Verdict::proved;
}

// A lower bound of the margin; minus infinity where the radius vanishes.
BlendChoice certified(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                      const ringed::Trial& found) {
  const RingedSurface surface = assembled(from, to, options, found.k, found.l);
  const double margin = smallest_radius(surface.radius) > 0
                            ? regularity(surface, {kCertificateWidth}).lower
                            : -std::numeric_limits<double>::infinity();
  return {found.k, found.l, found.energy, margin, found.length};
}

// Coaxial ends: every speed gives a straight spine, so the one of constant speed is taken. Normals
// and centres that are coaxial but for rounding (some 10 ulp each) leave an energy below this.
std::optional<BlendChoice> straight_choice(const Ring& from, const Ring& to,
                                           const CyclicBlendOptions& options) {
  const double distance = (to.center - from.center).norm();
  const Spine spine = assembled(from, to, options, distance, distance).spine;
  const double bend = 64 * std::numeric_limits<double>::epsilon();
  if (options.k || options.l || !(bending_energy(spine) * distance <= bend * bend)) {
    return std::nullopt;
  }
  return certified(from, to, options, {distance, distance, bending_energy(spine), length(spine)});
}

// What `find` finds for a margin, certified to have it.
template <class Find>
std::optional<BlendChoice> certified_choice(const Ring& from, const Ring& to,
                                            const CyclicBlendOptions& options, const Find& find) {
  double aim = options.margin + 2 * kCertificateWidth;
  // The certificate has the last word; where it sees a lower margin than the samples did, the
  // search aims higher.
  for (int attempt = 0; attempt < 3; ++attempt) {
    const auto found = find(aim);
    if (!found) {
      return std::nullopt;
    }
    const BlendChoice choice = certified(from, to, options, *found);
    if (choice.margin >= options.margin) {
      return choice;
    }
    if (!std::isfinite(choice.margin)) {
      return std::nullopt;  // its spine stops, or its radius vanishes: no aim is high enough
    }
    aim += options.margin - choice.margin + kCertificateWidth;
  }
  return std::nullopt;
}

std::optional<BlendChoice> feasible_choice(const Ring& from, const Ring& to,
                                           const CyclicBlendOptions& options) {
  const auto straight = straight_choice(from, to, options);
  if (straight && straight->margin >= options.margin) {
    return straight;
  }
  const ringed::BlendSearch blends = search(from, to, options);
  return certified_choice(from, to, options, [&](double aim) { return blends.least_energy(aim); });
}

// Speeds for a remedy, and what is wrong with them beside the margin, if anything.
struct Proposal {
  BlendChoice choice;
  std::optional<std::string> fault;
};

Proposal proposal(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                  const BlendChoice& choice, const BlendFault& fault_of) {
  return {choice, fault_of(assembled(from, to, options, choice.k, choice.l))};
}

// For a remedy: as near as can be to the speeds wanted, or to ever larger ones, loops not excluded.
// Where all that were found have a fault, one that is not of the blend alone.
std::optional<Proposal> further_choice(const Ring& from, const Ring& to,
                                       const CyclicBlendOptions& options, double k, double l,
                                       const BlendFault& fault_of) {
  const ringed::BlendSearch blends = search(from, to, options, ringed::kAllSpeeds);
  std::optional<Proposal> best;
  for (double factor = 1; factor <= 16; factor *= 1.5) {
    const auto found = certified_choice(
        from, to, options, [&](double aim) { return blends.nearest(aim, factor * k, factor * l); });
    if (!found) {
      break;
    }
    Proposal next = proposal(from, to, options, *found, fault_of);
    if (!next.fault) {
      return next;
    }
    if (!best && *next.fault != ringed::kCrossesItself) {
      best = std::move(next);
    }
  }
  return best;
}

// None if all spines stop.
std::optional<BlendChoice> widest_choice(const Ring& from, const Ring& to,
                                         const CyclicBlendOptions& options,
                                         const ringed::BlendSearch& blends) {
  if (const auto widest = blends.largest_margin()) {
    const BlendChoice choice = certified(from, to, options, *widest);
    if (std::isfinite(choice.margin)) {
      return choice;
    }
  }
  return std::nullopt;
}

// In as few digits as still have the margin: the nearest choice lies on the edge of what is
// possible, and so may the widest.
std::string speeds_text(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                        const BlendChoice& choice, double margin) {
  std::string k, l;
  for (int digits = 4; digits <= 17; ++digits) {
    k = decimal(choice.k, digits);
    l = decimal(choice.l, digits);
    if (is_valid(assembled(from, to, options, std::stod(k), std::stod(l)), margin)) {
      break;
    }
  }
  return "k = " + k + ", l = " + l;
}

std::string widest_text(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                        const BlendChoice& widest) {
  constexpr double kFourDigits = 0x1p-13;
  return speeds_text(from, to, options, widest,
                     widest.margin - kFourDigits * std::abs(widest.margin));
}

std::string near_text() {
  const auto& [shortest, longest, longest_spine] = ringed::kNearSpeeds;
  return decimal(shortest, 4) + " to " + decimal(longest, 4) +
         " times the distance of the ends, with a spine of at most " + decimal(longest_spine, 4) +
         " times it";
}

// Where none of the near speeds is enough.
std::string further_text(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                         const std::optional<Proposal>& further) {
  if (!further) {
    return "nor were any found that do, and do not cross themselves, of up to " +
           decimal(ringed::kAllSpeeds.longest, 4) +
           " times the distance, with a spine of any length";
  }
  const std::string speeds = speeds_text(from, to, options, further->choice, options.margin),
                    spine =
                        ", with a spine that is " + decimal(further->choice.length, 4) + " long";
  return further->fault ? speeds + " has enough for the blend alone" + spine + ", but the blend " +
                              *further->fault
                        : speeds + " has enough" + spine +
                              "; whether the blend with it meets other parts was not looked at";
}

[[noreturn]] void refuse_infeasible(const Ring& from, const Ring& to,
                                    const CyclicBlendOptions& options, const BlendFault& fault_of) {
  const auto widest = widest_choice(from, to, options, search(from, to, options));
  const double distance = (to.center - from.center).norm();
  CyclicBlendOptions any = options;
  any.k = any.l = std::nullopt;
  const auto further = further_choice(from, to, any, options.k.value_or(distance),
                                      options.l.value_or(distance), fault_of);
  const auto given = [](const char* name, const std::optional<double>& speed) {
    return speed ? " with " + (name + decimal(*speed, kMessageDigits)) : "";
  };
  throw Error(Errc::infeasible_blend,
              "no end speeds" + given("k = ", options.k) + given("l = ", options.l) + " of " +
                  near_text() + ", were found that give this blend a margin min(1 - kappa R) of " +
                  decimal(options.margin, kMessageDigits) +
                  (widest ? "; the largest of these is " + decimal(widest->margin, 4) + " with " +
                                widest_text(from, to, options, *widest)
                          : "") +
                  "; " + further_text(from, to, options, further) +
                  "; move the ends apart, reduce the radii, or ask for less margin");
}

std::string remedy(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                   const BlendAdvice& advice, const BlendFault& fault_of) {
  CyclicBlendOptions any = options;
  any.k = any.l = std::nullopt;
  const auto further = [&] {
    return "; " + further_text(from, to, options,
                               further_choice(from, to, any, *options.k, *options.l, fault_of));
  };
  std::string widest;
  if (advice.widest) {
    widest = "the largest margin, " + decimal(advice.widest->margin, 4) + ", has " +
             widest_text(from, to, options, *advice.widest);
  }
  if (!advice.nearest) {
    return "no end speeds that work were found of " + near_text() +
           (widest.empty() ? "" : "; of these, " + widest) + further();
  }
  const Proposal nearest = proposal(from, to, any, *advice.nearest, fault_of);
  return widest + "; nearest to those given, " +
         speeds_text(from, to, options, nearest.choice, options.margin) + " has enough, of end " +
         "speeds of " + near_text() +
         (nearest.fault ? ", but the blend with it " + *nearest.fault + further() : "");
}

// Sampled where the margin is missed, for the message: what is proven is the interval.
double missing_length(const RingedSurface& surface, const std::vector<ParameterInterval>& where,
                      double margin) {
  constexpr int kSamples = 256;
  double largest = 0;
  for (const auto& [from, to] : where) {
    for (int i = 0; i <= kSamples; ++i) {
      const double t = from + (to - from) * i / kSamples;
      const double kappa = curvature(evaluate(surface.spine, t));
      largest = std::max(largest, evaluate(surface.radius, t).value - (1 - margin) / kappa);
    }
  }
  return largest;
}

[[noreturn]] void refuse(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                         const RingedSurface& surface, const BlendFault& fault_of) {
  const Regularity found = regularity(surface);
  const BlendAdvice advice = blend_advice(from, to, options);
  const std::string help = "; " + remedy(from, to, options, advice, fault_of);
  const std::string speeds =
      "k = " + decimal(*options.k, kMessageDigits) + ", l = " + decimal(*options.l, kMessageDigits);
  if (!(smallest_radius(surface.radius) > 0)) {
    throw Error(Errc::irregular_surface,
                "with " + speeds +
                    " the blend's radius cannot follow the cones at its ends and stay positive" +
                    help);
  }
  if (!found.stops.empty()) {
    throw Error(Errc::irregular_surface, "with " + speeds + " the blend's spine stops there" + help,
                {}, "t = " + decimal(found.stops.front().from, 4));
  }
  const auto& bad = advice.violations;
  throw Error(Errc::irregular_surface,
              "with " + speeds + " the blend " + (found.upper <= 0 ? "folds" : "nearly folds") +
                  " there: its margin min(1 - kappa R) is " + decimal(found.lower, 4) + ", " +
                  decimal(advice.missing_margin, 4) + " short of " +
                  decimal(options.margin, kMessageDigits) + ", its radius " +
                  decimal(advice.missing_length, 4) + " too large for the bend" + help,
              {}, "t in [" + decimal(bad.front().from, 4) + ", " + decimal(bad.back().to, 4) + "]");
}

BlendFault fault_of_crossing(const CyclicBlendOptions& options, const BlendFault& also) {
  return [margin = options.margin, also](const RingedSurface& blend) {
    std::optional<std::string> fault = ringed::crossing(blend, margin);
    return fault || !also ? fault : also(blend);
  };
}

}  // namespace

namespace ringed {

RadiusLaw blend_radius(const EndRadii& radii, const Spine& spine,
                       const CyclicBlendOptions& options) {
  const auto* bezier = std::get_if<BezierSpine>(&spine);
  if (bezier == nullptr) {
    return cylinder_ended(radii, options);
  }
  return cone_ended(radii, evaluate(spine, 0).first.norm(), evaluate(spine, 1).first.norm(),
                    int(bezier->points.size()) - 1);
}

RingedSurface surrounding_blend(const Ring& from, const Ring& to, const CyclicBlendOptions& options,
                                const BlendFault& also) {
  validate(from, to, options);
  if (!options.k || !options.l) {
    const auto choice = feasible_choice(from, to, options);
    if (!choice) {
      refuse_infeasible(from, to, options, fault_of_crossing(options, also));
    }
    return assembled(from, to, options, choice->k, choice->l);
  }
  RingedSurface surface = assembled(from, to, options, *options.k, *options.l);
  if (!is_valid(surface, options.margin)) {
    refuse(from, to, options, surface, fault_of_crossing(options, also));
  }
  return surface;
}

}  // namespace ringed

RingedSurface cyclic_blend(const Ring& from, const Ring& to, const CyclicBlendOptions& options) {
  if (from.ellipse || to.ellipse) {
    throw Error(Errc::invalid_argument, "a ringed surface has circular ends, not elliptic ones");
  }
  return ringed::surrounding_blend(from, to, options);
}

BlendChoice choose_velocities(const Ring& from, const Ring& to, const CyclicBlendOptions& options) {
  validate(from, to, options);
  if (const auto choice = feasible_choice(from, to, options)) {
    return *choice;
  }
  refuse_infeasible(from, to, options, fault_of_crossing(options, {}));
}

BlendChoice widest_velocities(const Ring& from, const Ring& to, const CyclicBlendOptions& options) {
  validate(from, to, options);
  if (const auto widest = widest_choice(from, to, options, search(from, to, options))) {
    return *widest;
  }
  refuse_infeasible(from, to, options, fault_of_crossing(options, {}));
}

BlendAdvice blend_advice(const Ring& from, const Ring& to, const CyclicBlendOptions& options) {
  validate(from, to, options);
  if (!options.k || !options.l) {
    throw Error(Errc::invalid_argument, "advice on a blend needs both its end speeds");
  }
  const RingedSurface surface = assembled(from, to, options, *options.k, *options.l);
  BlendAdvice advice;
  if (smallest_radius(surface.radius) > 0) {
    const Regularity found = regularity(surface);
    advice.violations = found.stops.empty() ? violations(surface, options.margin) : found.stops;
    advice.missing_margin = std::max(0.0, options.margin - found.lower);
    if (found.stops.empty()) {
      advice.missing_length = missing_length(surface, advice.violations, options.margin);
    }
  }
  CyclicBlendOptions any = options;
  any.k = any.l = std::nullopt;
  const ringed::BlendSearch blends = search(from, to, any);
  advice.nearest = certified_choice(
      from, to, any, [&](double aim) { return blends.nearest(aim, *options.k, *options.l); });
  advice.widest = widest_choice(from, to, any, blends);
  return advice;
}

double bending_energy(const Spine& spine) {
  return numbers::integral([&](double t) {
    const SpinePoint point = evaluate(spine, t);
    const double kappa = curvature(point);
    return kappa * kappa * point.first.norm();
  });
}

}  // namespace dupin
