#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "dupin/blends/regularity.h"
#include "dupin/blends/sphere.h"
#include "interval.h"

namespace dupin::detail {

/// Encloses the discs of a stretch of a part. A ball counts as a disc of any normal.
struct DiscHull {
  std::vector<IntervalVec> centers;   ///< their convex hull contains all centres
  std::vector<IntervalVec> tangents;  ///< the cone they span contains all normals
  Vec3 axis = Vec3::Zero();           ///< roughly the mean normal
  double cosine = 0;  ///< below those of all angles between axis and normals; 0: any normal
  Interval radius;    ///< of all radii

  [[nodiscard]] Vec3 middle() const;
  /// A length that falls as the stretch does.
  [[nodiscard]] double extent() const;
};

/// Encloses the largest value of x.w over the discs' points from above.
[[nodiscard]] double support(const DiscHull& hull, const Vec3& w);

/// Roughly the point of the hull furthest in this direction.
[[nodiscard]] Vec3 support_point(const DiscHull& hull, const Vec3& direction);

/// The discs of a part with those of straight pipes or cones that go on from its ends, in outward
/// rounded arithmetic. Parameters are in [from(), to()], whole numbers being the seams; stretches
/// must not contain a seam inside.
class DiscSweep {
 public:
  explicit DiscSweep(const Sphere& sphere);
  DiscSweep(const RingedSurface& surface, const std::array<double, 2>& extension);

  [[nodiscard]] double from() const { return extension_[0] > 0 ? -1 : 0; }
  [[nodiscard]] double to() const { return extension_[1] > 0 ? 2 : 1; }
  [[nodiscard]] DiscHull over(const ParameterInterval& t) const;

  /// Whether the discs at any two parameters in t, seams allowed, are disjoint because the spine
  /// turns by at most a right angle, given that 1 - kappa R > margin >= 0 on [0, 1].
  [[nodiscard]] bool turns_little(const ParameterInterval& t, double margin) const;

 private:
  struct Part {
    std::vector<IntervalVec> centers, tangents;
  };

  [[nodiscard]] Part curve(const ParameterInterval& t) const;
  [[nodiscard]] Part extended(const ParameterInterval& t) const;
  [[nodiscard]] Interval radius(const ParameterInterval& t) const;
  [[nodiscard]] double turning(const ParameterInterval& t) const;

  std::optional<Sphere> sphere_;
  RingedSurface surface_;
  std::array<double, 2> extension_ = {};
};

}  // namespace dupin::detail
