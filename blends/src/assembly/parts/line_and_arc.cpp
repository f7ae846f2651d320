#include "assembly/parts/line_and_arc.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/elliptic_tube.h"

namespace dupin::assembly {
namespace {

RadiusLaw linear(double start, double end) {
  return start == end ? RadiusLaw(ConstantRadius{end}) : LinearRadius{start, end};
}

}  // namespace

Vec3 plain(const Vec3& v) { return v.array() + 0.0; }

Vec3 opposite(const Vec3& v) { return Vec3::Zero() - v; }

std::pair<double, double> cosine_and_sine(double angle) {
  constexpr double kQuarter = std::numbers::pi / 2;
  for (int turns = 1; turns <= 3; ++turns) {
    if (angle == turns * kQuarter) {
      return {turns == 2 ? -1 : 0, turns == 2 ? 0 : 2 - turns};
    }
  }
  return {std::cos(angle), std::sin(angle)};
}

PartSurface line(Ring start, const Vec3& to, const EndSection& section, bool own_start) {
  const double length = (to - start.center).norm();
  Ring end{plain(to), opposite(start.normal), section.radius,
           (section.radius - start.radius) / length, section.ellipse};
  const bool elliptic = start.ellipse || end.ellipse;
  if (end.ellipse) {
    end.ellipse->across_slope = (across(end) - across(start)) / length;
  }
  if (own_start) {
    start.slope = 0 - end.slope;
    if (start.ellipse) {
      start.ellipse->across_slope = (across(start) - across(end)) / length;
    }
  }
  const LineSpine spine{start.center, end.center};
  if (elliptic) {
    return elliptic_tube(start, end, spine, linear(start.radius, end.radius),
                         linear(across(start), across(end)));
  }
  return RingedSurface{start, end, spine, linear(start.radius, end.radius)};
}

PartSurface arc(const Ring& start, Ring end, const Vec3& inward, double bend_radius, double angle) {
  const Vec3 axis = opposite(start.normal).cross(inward).normalized();
  const ArcSpine spine{start.center + bend_radius * inward, axis, start.center, angle};
  if (!start.ellipse) {
    return RingedSurface{start, end, spine, ConstantRadius{start.radius}};
  }
  const Vec3& first = start.ellipse->axis;
  const Vec3 turned = first.dot(axis) * axis + first.dot(inward) * axis.cross(end.normal);
  end.ellipse = Ellipse{plain(turned.normalized()), start.ellipse->across};
  return elliptic_tube(start, end, spine, ConstantRadius{start.radius},
                       ConstantRadius{start.ellipse->across});
}

PartSurface cylinder(const Ring& start, const Vec3& to) {
  return line(start, to, {start.radius, start.ellipse}, false);
}

}  // namespace dupin::assembly
