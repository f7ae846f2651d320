#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/ring.h"
#include "dupin/kernel/vec.h"

namespace dupin::tessellation {

/// The face of a right cylinder or cone unrolled, seen from outside: x counts segments around from
/// the end's first corner, and y is the length along the rulings, in segments at that place and
/// this many times compressed. But for that, angles are those on the face.
class UnrolledFace {
 public:
  static constexpr double kCompression = 3;

  /// Two circles on one axis, their normals pointing out.
  UnrolledFace(const Ring& start, const Ring& end, const RingSampling& sampling);

  [[nodiscard]] double around() const { return segments_; }  ///< x of a turn
  [[nodiscard]] Vec2 place(const Vec3& point) const;         ///< x in half a turn either way
  [[nodiscard]] Vec3 point(const Vec2& place) const;
  /// By the distance of the rings: 0 at the start, 1 at the end.
  [[nodiscard]] double height(const Vec3& point) const;
  [[nodiscard]] double level(double y) const;  ///< that of a y
  [[nodiscard]] Ring ring(double y) const;     ///< of the face, looking to the end

 private:
  Vec3 origin_, axis_, first_, second_;
  double height_, segments_, radius_, slope_;
};

/// A closed polygon on the face: its corners as indices, which are the caller's.
struct UnrolledCurve {
  std::vector<std::uint32_t> corners;
  std::vector<Vec2> places;  ///< of the corners, x going on beyond a turn
  int turns = 0;             ///< about the axis, not negative
  double low = 0, high = 0;  ///< least and greatest y
  bool is_ring = false;      ///< a circle about the axis, divided equally
};

[[nodiscard]] UnrolledCurve unrolled(std::vector<std::uint32_t> corners,
                                     const std::vector<Vec2>& place, double around);

/// Of one that does not go about the axis: positive where it goes counter-clockwise.
[[nodiscard]] double twice_area(const UnrolledCurve& curve);

/// Of one that goes about the axis once: the integral of y over its turn.
[[nodiscard]] double area_below(const UnrolledCurve& curve, double around);

}  // namespace dupin::tessellation
