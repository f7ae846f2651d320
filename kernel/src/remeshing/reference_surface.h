#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "dupin/kernel/mesh.h"

namespace dupin::remeshing {

/// The triangles of a mesh, each in a region, which distances are measured to.
class ReferenceSurface {
 public:
  /// Refers to the arguments.
  ReferenceSurface(std::span<const Vec3> points, std::span<const Triangle> triangles,
                   std::span<const std::uint32_t> regions);

  struct Place {
    Vec3 point = Vec3::Zero();
    std::uint32_t face = 0;
    double distance = std::numeric_limits<double>::infinity();
  };

  /// The place of a region nearest to a point, of those whose triangles do not face away from
  /// `normal`; none if there is none within `reach`. `guess`: where it may be expected.
  [[nodiscard]] std::optional<Place> nearest(const Vec3& point, std::uint32_t region,
                                             const Vec3& normal, double guess, double reach) const;
  /// Whether some triangle of the region is within a distance.
  [[nodiscard]] bool is_within(const Vec3& point, std::uint32_t region, double distance) const;

  /// A bound of the distance of any point of a triangle from a region, if it can be proved to be at
  /// most `distance`. The triangle is cut into what lies above one triangle of the region each,
  /// whose distance is a convex function: its largest value over a part is taken in a corner.
  /// Rounding of cuts is not in the bound. Costs as many parts as there are triangles near, and a
  /// fixed number at most.
  [[nodiscard]] std::optional<double> bound(const std::array<Vec3, 3>& triangle,
                                            std::uint32_t region, double distance) const;

 private:
  [[nodiscard]] Vec3 nearest_on(std::uint32_t face, const Vec3& point) const;
  [[nodiscard]] boxes::Box around(const std::array<Vec3, 3>& triangle, double margin) const;

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  std::span<const std::uint32_t> regions_;
  boxes::BoxQuantizer frame_;
  boxes::BoxTree tree_;
};

}  // namespace dupin::remeshing
