#pragma once

#include <array>
#include <optional>

#include "dupin/blends/canal_fillet.h"
#include "numbers/interval.h"

namespace dupin::canal {

/// A ball of constant radius on two cylinders. Its centre runs where two parallel cylinders cross,
/// and their normals tell how it turns, without derivatives: a curve on a cylinder of radius d
/// whose tangent is at the angle a with the axis bends by sin^2 a / d along the normal.
class BallOnCylinders {
 public:
  /// None of other motions, nor where stored numbers are off all such cylinders by so much that it
  /// would show.
  [[nodiscard]] static std::optional<BallOnCylinders> of(const CanalFillet& fillet);

  /// Holds `least_regularity` at every parameter of the stretch, of the stored numbers.
  [[nodiscard]] numbers::Interval least_regularity(const ParameterInterval& at) const;

  [[nodiscard]] const numbers::Interval& radius() const { return radius_; }

 private:
  using Interval = numbers::Interval;
  /// The centre is origin + axes u(t), with u(t) exactly on both cylinders: the first one's axis is
  /// along (1, 0, 0), the second one's along (cosine, sine, 0), cosine^2 + sine^2 = 1.
  struct Frame {
    numbers::IntervalVec origin;
    std::array<numbers::IntervalVec, 3> axes;
    Interval cosine, sine;
  };
  struct Cylinder {
    Interval radius;
    Interval height;  ///< of the axis, along the third coordinate
  };
  /// A cylinder's normal: its coordinates orthogonal to both axes, and orthogonal to its own axis
  /// alone.
  struct Normal {
    Interval up, aside;
  };

  explicit BallOnCylinders(const RollingThrough& motion);
  explicit BallOnCylinders(const RollingPartly& motion);

  template <class Motion>
  [[nodiscard]] static Frame frame_of(const Motion& motion);

  [[nodiscard]] std::array<Normal, 2> normals(const Interval& cosine, const Interval& sine) const;
  [[nodiscard]] Interval reach_along_axes() const;
  [[nodiscard]] Interval error_of_frame() const;
  [[nodiscard]] Interval error_of_normal(std::size_t i, const Ring& stored) const;

  Frame frame_;
  std::array<Cylinder, 2> cylinders_;
  Interval radius_;
  /// An upper bound of the curvature of u(t).
  Interval curvature_;
  /// By how much frame and normals are off, and what the regularity is off by for that where both
  /// normals are equal.
  double error_ = 0, slack_ = 0;
  // Of the normals, as functions of the parameter.
  bool passes_ = true;             // the second one through the first: else neither
  double side_ = 1;                // if it does
  std::array<Interval, 2> scale_;  // of the heights of both normals,
  Interval shift_;                 // and, if it does, what the first one's is less by
};

}  // namespace dupin::canal
