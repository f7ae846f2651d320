#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>

#include "dupin/blends/part_surface.h"

namespace dupin::canal {

/// What rounding leaves of a touch, of a radius.
constexpr double kTouching = 1e-9;

struct Range {
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void include(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// How a loop lies on one of its pipes.
struct Course {
  Range height;        ///< along the axis, from the start
  double step = 0;     ///< the most by which it changes from one point to the next
  bool winds = false;  ///< about the axis

  /// Of all places between the points, too, of a loop that turns no more sharply there.
  [[nodiscard]] Course widened() const {
    return {{height.least - step, height.most + step}, step, winds};
  }
};

enum class Place { within, beside, across };

/// The tube of a straight pipe or cone of circular sections; null for what is none.
[[nodiscard]] const RingedSurface* straight_tube(const PartSurface& surface);

/// A straight pipe or cone of circular sections, between its ends, which a fillet's loops lie on.
/// `tube` and `name` have to outlive it.
class StraightPipe {
 public:
  /// `outward`: by how much its radii are more than what a document says.
  StraightPipe(const RingedSurface& tube, const std::string& name, double outward);

  [[nodiscard]] const Ring& ring() const { return tube_.end; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] const Ring& end(End end) const {
    return end == End::start ? tube_.start : tube_.end;
  }
  /// What the document says for one of its radii.
  [[nodiscard]] double said(double radius) const { return radius - outward_; }

  /// Of points that a loop has on it, once around.
  [[nodiscard]] Course course(std::span<const Vec3> points) const;
  /// Beyond a buried end there is no face: a loop is on this side of it, but for one point where
  /// the pipes touch, or on the other.
  [[nodiscard]] Place place(const Course& course, const std::array<bool, 2>& buried) const;

  /// Whether all of it is, so that it is `beside`.
  [[nodiscard]] bool is_beyond_buried_end(const Course& course,
                                          const std::array<bool, 2>& buried) const {
    return (buried[0] && course.height.most < 0) || (buried[1] && course.height.least > length_);
  }

  /// How far a disc reaches out of it, negative inside; and a point.
  [[nodiscard]] double reach_out(const Ring& disc) const;
  [[nodiscard]] double outside(const Vec3& point) const;
  /// Whether a disc lies inside; it may touch, as the end of a branch as thick as the pipe does.
  [[nodiscard]] bool buries(const Ring& disc) const;

 private:
  [[nodiscard]] double height(const Vec3& point) const;
  [[nodiscard]] Vec3 arm(const Vec3& point) const;

  const RingedSurface& tube_;
  const std::string& name_;
  double outward_;
  Vec3 axis_;
  double length_;
};

/// Whether a disc lies inside a straight pipe or cone, which it may touch; of what is none it is
/// not asked.
[[nodiscard]] bool is_within_run(const PartSurface& run, const Ring& disc);

}  // namespace dupin::canal
