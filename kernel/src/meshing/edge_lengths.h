#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/mesh.h"
#include "mesh/surface_distance.h"
#include "meshing/features.h"

namespace dupin::meshing {

/// How long edges along curves may be for a mesh to stay within a distance. Refers to what it is
/// made of.
class EdgeLengths {
 public:
  EdgeLengths(const mesh::ReferenceSurface& surface, const Features& features, double distance,
              double largest);

  /// Of those about a point, positive: no triangle and no edge of that length, there, lies further
  /// from regions and curves than the distance, if these turn evenly. An arc of length s that turns
  /// by an angle a has a chord at most s a / 8 away; a triangle whose circumradius is s, and whose
  /// edges are longer, s a / 2. Steps that are shorter than that turn it by less. Of curves, nor
  /// longer than half the way to regions that are not at the curve: a ball about the point would
  /// keep their triangles from getting small.
  [[nodiscard]] double at(const Vec3& point) const;

  /// Of those along a curve, at one of its points, as above, but for the meshes of its regions
  /// alone.
  [[nodiscard]] double along(const Vec3& point, std::uint32_t curve) const;

  /// From a point of a curve to curves that have a region in common with it, but for some,
  /// ascending; at most `reach`.
  [[nodiscard]] double gap_beside(const Vec3& point, std::uint32_t curve,
                                  const std::vector<std::uint32_t>& without, double reach) const;

  /// From the point so far along a curve to curves that have a region in common with it, and to
  /// where it comes back to itself; at most `reach`.
  [[nodiscard]] double gap(const Vec3& point, std::uint32_t curve, double along,
                           double reach) const;

  /// Which curves keep each other's edges short: all, in a mesh that is filled, or those that have
  /// a region in common.
  enum class Between : std::uint8_t { all, regions };

  /// Throws Error{limit_exceeded} naming the place if curves come so near each other that edges
  /// along them would be more than `most`.
  void require_room(std::size_t most, Between between) const;

 private:
  [[nodiscard]] double length_at(const Vec3& point, double most,
                                 const std::array<std::uint32_t, 2>* regions,
                                 std::uint32_t curve) const;
  /// From a point to the edges for which counts(edge, its distance); at most `reach`.
  template <class Counts>
  [[nodiscard]] double nearest_edge(const Vec3& point, double reach, const Counts& counts) const;
  [[nodiscard]] bool share_a_region(std::uint32_t curve, std::uint32_t other) const;
  [[nodiscard]] double gap_to_others(const Vec3& point, std::uint32_t curve, double reach,
                                     Between between) const;
  [[nodiscard]] double room_about(const Vec3& point) const;

  const mesh::ReferenceSurface& surface_;
  const Features& features_;
  double distance_, largest_;
  std::vector<std::uint8_t> is_flat_;  // per region
  // The edges of all curves, as triangles with two equal corners.
  std::vector<Vec3> points_;
  std::vector<Triangle> edges_;
  std::vector<std::uint32_t> curves_;            // per edge
  std::vector<double> starts_;                   // per edge, how far along its curve
  std::vector<double> curve_lengths_;            // of loops; infinite of others
  std::vector<std::set<std::uint32_t>> beside_;  // per curve, regions at it and at its ends
  mesh::ReferenceSurface curve_edges_;
};

/// The error of curves that come so near each other that a mesh gets too many points.
[[nodiscard]] Error too_near(const Vec3& place, double gap);

/// The error of edges along a curve that are so short that a mesh gets too many points.
[[nodiscard]] Error too_short(const Vec3& place, double length);

/// The error of a mesh that gets more points than it may have.
[[nodiscard]] Error too_many(std::size_t most);

}  // namespace dupin::meshing
