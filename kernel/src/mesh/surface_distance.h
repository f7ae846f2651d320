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

namespace dupin::mesh {

/// The place of a segment that is nearest to a point, but for rounding.
[[nodiscard]] Vec3 nearest_on_segment(const Vec3& point, const Vec3& a, const Vec3& b);

/// The place of a triangle that is nearest to a point; rounding may make it another one, which is
/// further off.
[[nodiscard]] Vec3 nearest_on_triangle(const Vec3& point, const Vec3& a, const Vec3& b,
                                       const Vec3& c);

/// The triangles of a mesh, each in a region, which distances are measured to. Refers to what it is
/// made of.
class ReferenceSurface {
 public:
  ReferenceSurface(std::span<const Vec3> points, std::span<const Triangle> triangles,
                   std::span<const std::uint32_t> regions);

  struct Place {
    Vec3 point = Vec3::Zero();
    std::uint32_t face = 0;
    double distance = std::numeric_limits<double>::infinity();
  };

  /// The place of a region nearest to a point; none if there is none within `reach`.
  [[nodiscard]] std::optional<Place> nearest(const Vec3& point, std::uint32_t region,
                                             double reach) const;

  /// Calls visit(triangle, its place nearest to the point, the distance) for all triangles within
  /// a distance.
  template <class Visit>
  void visit_near(const Vec3& point, double distance, Visit&& visit) const {
    visit_near(
        point, distance, [](std::uint32_t) { return true; }, visit);
  }
  /// The same for those of them for which is_wanted(triangle).
  template <class IsWanted, class Visit>
  void visit_near(const Vec3& point, double distance, IsWanted&& is_wanted, Visit&& visit) const {
    tree_.visit(frame_.around(frame_.map(point, point, point), distance), [&](std::uint32_t f) {
      if (!is_wanted(f)) {
        return;
      }
      const Vec3 here = nearest_on(f, point);
      if (const double far = (here - point).norm(); far <= distance) {
        visit(f, here, far);
      }
    });
  }
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t face) const {
    const auto& [a, b, c] = triangles_[face];
    return {points_[a], points_[b], points_[c]};
  }
  [[nodiscard]] std::uint32_t region(std::uint32_t face) const { return regions_[face]; }

  /// A look, not a proof: whether the middles of a triangle and of its edges are near a region.
  [[nodiscard]] bool looks_near(const std::array<Vec3, 3>& triangle, std::uint32_t region,
                                double distance) const;

  /// A bound of the distance of any point of a triangle from a region, if it can be proved to be at
  /// most `distance`. The triangle is cut into parts that are near one triangle of the region each:
  /// the distance from it is a convex function, whose largest value over a part is taken in a
  /// corner. Rounding, of cuts and of distances, is not in the bound. The time is about that of
  /// looking at each triangle that is near some times, and is bounded.
  [[nodiscard]] std::optional<double> bound(const std::array<Vec3, 3>& triangle,
                                            std::uint32_t region, double distance) const;

 private:
  [[nodiscard]] Vec3 nearest_on(std::uint32_t face, const Vec3& point) const;

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  std::span<const std::uint32_t> regions_;
  boxes::BoxQuantizer frame_;
  boxes::BoxTree tree_;
};

}  // namespace dupin::mesh
