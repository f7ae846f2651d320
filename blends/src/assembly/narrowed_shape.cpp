#include "assembly/narrowed_shape.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include "assembly/fillet_part.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

using Fits = std::function<bool(double)>;

// The largest number of the digits of messages that fits, between one that does and one that need
// not.
double largest_told(double fitting, double too_large, const Fits& fits) {
  const double unit = std::pow(10, std::floor(std::log10(fitting)) + 1 - kMessageDigits);
  double most = fitting;
  while (too_large - most > unit / 4) {
    const double middle = most + (too_large - most) / 2;
    (fits(middle) ? most : too_large) = middle;
  }
  for (double whole = std::floor(too_large / unit); whole * unit > fitting; --whole) {
    const double told = rounded(whole * unit, kMessageDigits);
    if (fits(told)) {
      return told;
    }
  }
  return fitting;
}

}  // namespace

double less_wall(double radius, double wall) {
  if (!(radius > wall)) {
    throw Error(Errc::infeasible_blend, "a wall of " + decimal(wall, kMessageDigits) +
                                            " leaves no bore where the radius is only " +
                                            decimal(radius, kMessageDigits));
  }
  return radius - wall;
}

Ring narrowed(Ring ring, double wall) {
  ring.radius = less_wall(ring.radius, wall);
  if (ring.ellipse) {
    ring.ellipse->across = less_wall(ring.ellipse->across, wall);
  }
  return ring;
}

Ring parallel(Ring ring, double wall) {
  const double stretch = std::hypot(1, ring.slope);
  ring.center += wall * ring.slope / stretch * ring.normal;
  ring.radius = less_wall(ring.radius, wall / stretch);
  return ring;
}

namespace {

struct NarrowedLaw {
  double wall;
  RadiusLaw operator()(const ConstantRadius& law) const {
    return ConstantRadius{less_wall(law.radius, wall)};
  }
  // The cyclide law's values are less by the wall, or more: x - wall is above the root for the
  // lessened radii wherever x is that for the radii.
  template <class Law>
  RadiusLaw operator()(const Law& law) const {
    return Law{less_wall(law.start, wall), less_wall(law.end, wall)};
  }
  RadiusLaw operator()(BezierRadius law) const {
    for (double& coefficient : law.coefficients) {
      coefficient = less_wall(coefficient, wall);
    }
    return law;
  }
};

RadiusLaw narrowed_law(const RadiusLaw& law, double wall) {
  return std::visit(NarrowedLaw{wall}, law);
}

struct NarrowedPiece {
  double wall;

  Piece operator()(const RingedSurface& tube) const {
    return RingedSurface{narrowed(tube.start, wall), narrowed(tube.end, wall), tube.spine,
                         narrowed_law(tube.radius, wall)};
  }
  Piece operator()(EllipticTube tube) const {
    tube.start = narrowed(tube.start, wall);
    tube.end = narrowed(tube.end, wall);
    tube.first = narrowed_law(tube.first, wall);
    tube.second = narrowed_law(tube.second, wall);
    return tube;
  }
  Piece operator()(RationalRingedTube tube) const {
    tube.start = narrowed(tube.start, wall);
    tube.end = narrowed(tube.end, wall);
    for (double& radius : tube.surface.radius) {
      radius = less_wall(radius, wall);
    }
    return tube;
  }
  Piece operator()(const CyclidePiece& /*piece*/) const {
    throw Error(Errc::infeasible_blend,
                "a bore through cyclide pieces and others in one part is not built");
  }
};

struct NarrowedSurface {
  double wall;

  PartSurface operator()(const Sphere& sphere) const {
    return Sphere{sphere.center, less_wall(sphere.radius, wall)};
  }
  PartSurface operator()(const Chain& chain) const {
    if (!chain.pieces.empty() && cyclide_pieces(chain).size() == chain.pieces.size()) {
      if (wall > 0) {
        return inner_skin(hollow(chain, wall));
      }
      Chain skin = chain;
      skin.wall = wall;
      return inner_skin(skin);
    }
    Chain result = chain;
    for (Piece& piece : result.pieces) {
      piece = std::visit(NarrowedPiece{wall}, piece);
    }
    return result;
  }
};

}  // namespace

PartSurface narrowed(const PartSurface& surface, double wall) {
  return std::visit(NarrowedSurface{wall}, surface);
}

// An arm may narrow on its way to the hub.
Junction narrowed(Junction junction, double wall) {
  junction.hub.radius = less_wall(junction.hub.radius, wall);
  for (JunctionArm& arm : junction.arms) {
    CyclideChain pieces;
    if (arm.straight) {
      pieces.pieces.push_back(*arm.straight);
    }
    pieces.pieces.push_back(arm.collar);
    for (const PeArc& piece : pieces.pieces) {
      (void)less_wall(least_radius(piece), wall);
    }
    pieces = offset(pieces, -wall);
    arm.end = parallel(arm.end, wall);
    if (arm.straight) {
      arm.straight = pieces.pieces.front();
    }
    arm.collar = pieces.pieces.back();
  }
  if (const std::string fault = unsoundness(junction); !fault.empty()) {
    throw Error(
        Errc::infeasible_blend,
        (wall > 0 ? "its bore is no junction: " : "its insulation is no junction: ") + fault);
  }
  return junction;
}

std::array<PartSurface, 2> narrowed(const std::array<const PartSurface*, 2>& pipes,
                                    const std::array<double, 2>& walls) {
  return {narrowed(*pipes[0], walls[0]), narrowed(*pipes[1], walls[1])};
}

void refuse_insulation(double thickness, const Error& folds, InsulationAdvice advice,
                       const std::function<void(double)>& made) {
  const Fits fits = [&](double tried) {
    try {
      made(tried);
      return true;
    } catch (const Error&) {
      return false;
    }
  };
  const std::string refusal =
      "its insulation of " + decimal(thickness, kMessageDigits) + " is too thick for its bends";
  const auto some = largest_radius_below(thickness, fits);
  if (!some) {
    throw Error(folds.code(), refusal + ": " + folds.message());
  }
  if (advice == InsulationAdvice::some) {
    throw Error(folds.code(), refusal + "; " + decimal(*some) + " would do");
  }
  constexpr double kFurther = 1.01;  // than what is found first
  const double most = largest_told(*some, std::min(kFurther * *some, thickness), fits);
  throw Error(folds.code(), refusal + "; it may be at most " + decimal(most));
}

}  // namespace dupin::assembly
