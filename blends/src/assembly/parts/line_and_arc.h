#pragma once

#include <optional>
#include <utility>

#include "dupin/blends/part_surface.h"
#include "dupin/kernel/ring.h"

namespace dupin::assembly {

/// +0 for -0, so that equal vectors are equal bitwise.
[[nodiscard]] Vec3 plain(const Vec3& v);

/// The same of -v.
[[nodiscard]] Vec3 opposite(const Vec3& v);

/// Exact for quarter turns, which documents mean exactly.
[[nodiscard]] std::pair<double, double> cosine_and_sine(double angle);

/// The section in which a cone ends: an ellipse if it has two semi-axes.
struct EndSection {
  double radius = 1;
  std::optional<Ellipse> ellipse;
};

/// The cone from a ring that looks against the direction of travel to `to` on its axis. One whose
/// start ring is its own knows its half angle at both ends.
[[nodiscard]] PartSurface line(Ring start, const Vec3& to, const EndSection& section,
                               bool own_start);

/// The cylinder of the ring's section.
[[nodiscard]] PartSurface cylinder(const Ring& start, const Vec3& to);

/// The bend that leaves `start` tangentially, turning towards the unit vector `inward`. An
/// ellipse's axis has a part along the bend's axis, which stays, and one inward, which turns.
[[nodiscard]] PartSurface arc(const Ring& start, Ring end, const Vec3& inward, double bend_radius,
                              double angle);

}  // namespace dupin::assembly
