#include "dupin/blends/junction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "junction/hub_search.h"
#include "junction/separation.h"

namespace dupin {
namespace {

using junction::Arithmetic;

[[noreturn]] void fail(const std::string& message) { throw Error(Errc::invalid_argument, message); }

void check(std::span<const Ring> ends, const JunctionOptions& options) {
  if (ends.size() < 2) {
    fail("a junction needs at least two ends, not " + std::to_string(ends.size()));
  }
  for (const Ring& end : ends) {
    validate(end);
    if (end.ellipse) {
      fail("a junction's ends are circles, not ellipses");
    }
  }
  if (options.center && !options.center->allFinite()) {
    fail("a hub's centre needs finite coordinates");
  }
  if (options.radius && !(*options.radius > 0 && std::isfinite(*options.radius))) {
    fail("a hub's radius must be a positive number, not " +
         decimal(*options.radius, kMessageDigits));
  }
  if (!(options.smoothness >= 0 && options.smoothness <= 1)) {
    fail("the smoothness of a junction is between 0 and 1, not " +
         decimal(options.smoothness, kMessageDigits));
  }
  if (!options.cap_angles.empty() && options.cap_angles.size() != ends.size()) {
    fail("a junction needs a cap angle for each of its " + std::to_string(ends.size()) +
         " ends, not " + std::to_string(options.cap_angles.size()));
  }
  for (const double angle : options.cap_angles) {
    if (!(angle > 0 && angle < std::numbers::pi / 2)) {
      fail("a cap's angle must be positive and less than a right one");
    }
  }
}

// Of the cap with this angular radius, by the sphere's.
double cap_height(const JunctionArm& arm) {
  const double half = std::sin(cap_angle(arm) / 2);
  return 2 * half * half;
}

}  // namespace

Ring cap_circle(const JunctionArm& arm) {
  return contact_ring(arm.collar.end(), arm.collar.end_tangent());
}

double cap_angle(const JunctionArm& arm) { return std::atan2(1, arm.collar.end_tangent().r); }

double straight_length(const JunctionArm& arm) { return arm.straight ? arm.straight->chord() : 0; }

Chain tube(const JunctionArm& arm) {
  std::vector<PeArc> pieces;
  if (arm.straight) {
    pieces.push_back(*arm.straight);
  }
  pieces.push_back(arm.collar);
  return cyclide_tube(CyclideChain{std::move(pieces)}, flipped(arm.end), cap_circle(arm));
}

JunctionMargins margins(const Junction& junction) {
  JunctionMargins result{std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < junction.arms.size(); ++i) {
    const PeArc& collar = junction.arms[i].collar;
    const double radii = junction.hub.radius * cap_circle(junction.arms[i]).radius;
    result.power = std::min(result.power, collar.least_power() / radii);
    for (std::size_t k = 0; k < i; ++k) {
      result.cap_gap = std::min(result.cap_gap, junction::cap_gap(collar, junction.arms[k].collar));
    }
  }
  return result;
}

std::string description(const Junction& junction) {
  const auto text = [](double x) { return decimal(x, kMessageDigits); };
  const Vec3& center = junction.hub.center;
  return "hub of radius " + text(junction.hub.radius) + " at (" + text(center.x()) + ", " +
         text(center.y()) + ", " + text(center.z()) + "), caps " +
         decimal(margins(junction).cap_gap * 180 / std::numbers::pi, 3) + " degrees apart";
}

double area(const Junction& junction) {
  const double r = junction.hub.radius;
  double sum = 4 * std::numbers::pi * r * r;
  for (const JunctionArm& arm : junction.arms) {
    sum += area(arm.collar) + (arm.straight ? area(*arm.straight) : 0) -
           2 * std::numbers::pi * r * r * cap_height(arm);
  }
  return sum;
}

double volume(const Junction& junction) {
  const double cube = std::pow(junction.hub.radius, 3);
  double sum = 4 * std::numbers::pi / 3 * cube;
  for (const JunctionArm& arm : junction.arms) {
    const double h = cap_height(arm);
    sum += volume(arm.collar) + (arm.straight ? volume(*arm.straight) : 0) -
           std::numbers::pi / 3 * cube * h * h * (3 - h);
  }
  return sum;
}

std::string unsoundness(const Junction& junction) {
  const auto name = [](std::size_t i) { return "end " + std::to_string(i + 1); };
  for (std::size_t i = 0; i < junction.arms.size(); ++i) {
    const JunctionArm& arm = junction.arms[i];
    if (!junction::goes_forward(arm.collar, Arithmetic::exact)) {
      return "the collar of " + name(i) + " turns by more than half a circle";
    }
    if (arm.straight && !junction::approaches(arm.collar, Arithmetic::exact)) {
      return "the straight piece of " + name(i) + " passes the hub";
    }
    for (std::size_t k = 0; k < i; ++k) {
      const JunctionArm& other = junction.arms[k];
      if (!junction::caps_are_disjoint(other.collar, arm.collar, Arithmetic::exact)) {
        return "the caps of " + name(k) + " and " + name(i) + " overlap";
      }
      if (!junction::arms_are_apart(other, arm, Arithmetic::exact)) {
        return "the arms of " + name(k) + " and " + name(i) +
               " are not proved to be apart by a plane";
      }
    }
  }
  return {};
}

JunctionSearch search_junction(std::span<const Ring> ends, const JunctionOptions& options) {
  check(ends, options);
  const auto approaches = junction::approaches_of(ends);
  return junction::search_hub(
      approaches, options.center.value_or(junction::nearest_to_axes(approaches)), options);
}

}  // namespace dupin
