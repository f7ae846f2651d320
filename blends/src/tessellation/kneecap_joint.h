#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <vector>

#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/ring.h"

namespace dupin::tessellation {

/// How two pieces meet in their common sphere: in one circle; in two that cross, where the kneecap
/// is a lune; in two that do not, with a band of the sphere between them or, the discs overtaking
/// each other, none of it in sight.
enum class JointKind { smooth, lune, band, hidden };

/// Corners are no further apart than so many steps of the grid if snapping may make one of them.
constexpr double kSameCorners = 2 * std::numbers::sqrt3;

struct JointCircles {
  JointKind kind = JointKind::smooth;
  PeVector sphere;
  Ring before, after;  ///< the contact circles, normals in travel direction
  /// Of a lune: where the circles cross. It lies counter-clockwise from the first to the second.
  std::array<Vec3, 2> corners;
  double apart = 0;  ///< of a smooth joint: how far its circles may be apart all the same
  Vec3 hinge;        ///< unit, across both normals; the kneecap is symmetric to the plane across it
};

/// Circles nowhere further apart than `negligible` are the first one's; corners that snapping to
/// `grid` may make one are none.
[[nodiscard]] JointCircles joint(const PeArc& before, const PeArc& after, double negligible,
                                 double grid);

/// From the circle's centre to the middle of its arc at the kneecap.
[[nodiscard]] Vec3 outward(const JointCircles& joint, const Vec3& normal);

/// Where the polygons of a band begin: a half step past its narrowest place, where circles may all
/// but touch and corners would fall together.
[[nodiscard]] Vec3 band_start(const JointCircles& joint, const Vec3& normal, std::size_t segments);

/// A polygon inscribed in a circle, counter-clockwise about its normal.
struct JointPolygon {
  std::vector<Vec3> points;    ///< snapped
  Vec3 first;                  ///< direction of the first point
  std::vector<double> angles;  ///< of the points from there, ascending from 0
  /// The kneecap's edge runs from points.front() over so many segments: to the second corner of a
  /// lune, all round a band, none of a hidden or smooth joint.
  std::uint32_t exposed = 0;
};

/// No step around is larger than those of a regular polygon of segments - 1 points.
[[nodiscard]] JointPolygon joint_polygon(const JointCircles& joint, const Ring& circle,
                                         std::uint32_t segments, double grid);

}  // namespace dupin::tessellation
