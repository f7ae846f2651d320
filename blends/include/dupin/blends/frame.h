#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "dupin/blends/spine.h"

namespace dupin {

/// A right-handed orthonormal frame of a spine: tangent x first = second.
struct Frame {
  Vec3 first, second, tangent;
};

struct FrameOptions {
  std::size_t knots = 256;  ///< steps of the double reflection; the end angle's error falls as
                            ///< their fourth power
};

/// A rotation-minimising frame along a spine, at any t in [0, 1]: it turns only as much as the
/// tangent forces it to.
///
/// Spines that lie in a plane (decided exactly) get the closed form, which does not drift; others
/// double reflection (Wang, Juettler, Zheng, Liu 2008) from the nearest knot before t, so that
/// `at` is continuous, exact at knots, O(1) and deterministic.
class FrameField {
 public:
  /// Starts with `first` along the part of `start_axis` that is orthogonal to the spine. Throws
  /// Error{invalid_argument} if there is none, Error{irregular_surface} if the spine stops at a
  /// knot.
  FrameField(const Spine& spine, const Vec3& start_axis, const FrameOptions& options = {});

  [[nodiscard]] Frame at(double t) const;

  /// The unit normal of the plane the spine lies in; none for a spatial spine.
  [[nodiscard]] const std::optional<Vec3>& plane_normal() const { return plane_normal_; }

 private:
  struct Knot {
    Vec3 position;
    Frame frame;
  };

  [[nodiscard]] Knot stepped(const Knot& from, double t) const;

  Spine spine_;
  std::optional<Vec3> plane_normal_;
  double along_normal_ = 0, in_plane_ = 0;  // planar: first = along n + in n x T
  std::vector<Knot> knots_;                 // spatial
};

}  // namespace dupin
