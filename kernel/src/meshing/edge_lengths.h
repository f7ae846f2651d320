#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "dupin/kernel/mesh.h"
#include "meshing/features.h"
#include "meshing/surface_distance.h"

namespace dupin::meshing {

/// How long edges along curves may be for a mesh to stay within a distance. Refers to what it is
/// made of.
class EdgeLengths {
 public:
  EdgeLengths(const ReferenceSurface& surface, const Features& features, double distance,
              double largest);

  /// Of those about a point, positive: no triangle and no edge of that length, there, lies further
  /// from regions and curves than the distance, if these turn evenly. An arc of length s that turns
  /// by an angle a has a chord at most s a / 8 away; a triangle whose circumradius is s, and whose
  /// edges are longer, s a / 2. Of curves, nor longer than half the way to regions that are not at
  /// the curve: a ball about the point would keep their triangles from getting small.
  [[nodiscard]] double at(const Vec3& point) const;

  /// Throws Error{limit_exceeded} naming the place if curves come so near each other that edges
  /// along them would be more than `most`.
  void require_room(std::size_t most) const;

 private:
  [[nodiscard]] double gap_to_others(const Vec3& point, std::uint32_t curve, double reach) const;
  [[nodiscard]] double room_about(const Vec3& point) const;

  const ReferenceSurface& surface_;
  const Features& features_;
  double distance_, largest_;
  // The edges of all curves, as triangles with two equal corners.
  std::vector<Vec3> points_;
  std::vector<Triangle> edges_;
  std::vector<std::uint32_t> curves_;            // per edge
  std::vector<std::set<std::uint32_t>> beside_;  // per curve, regions at it and at its ends
  ReferenceSurface curve_edges_;
};

}  // namespace dupin::meshing
