#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "dupin/kernel/mesh.h"
#include "remeshing/features.h"

namespace dupin::remeshing {

struct SizeLimits {
  double smallest = 0, largest = 0, distance = 0;
};

/// How long edges should be at a place: as long as keeps them within the distance of the surface,
/// and its turns small, and no longer than sharp edges are apart.
class SizeField {
 public:
  /// Refers to the arguments.
  SizeField(const TriMesh& mesh, const Features& features, const SizeLimits& limits);

  /// In a region.
  [[nodiscard]] double in_region(const Vec3& point, std::uint32_t region) const;
  /// On a curve, at a length along it.
  [[nodiscard]] double on_curve(const Vec3& point, std::uint32_t curve, double length) const;
  /// At a corner, where regions and the ends of curves meet.
  [[nodiscard]] double at_corner(const Vec3& point, std::uint32_t corner,
                                 std::span<const std::uint32_t> regions) const;

 private:
  /// An edge of the mesh within a region, where the surface bends.
  struct Bend {
    Vec3 from, to;
    double angle;
    std::uint32_t region;
  };
  struct CurveEdge {
    std::uint32_t curve, edge;
  };
  [[nodiscard]] boxes::Box around(const Vec3& a, const Vec3& b, double margin) const;
  [[nodiscard]] double by_bends(const Vec3& point, std::span<const std::uint32_t> regions) const;
  [[nodiscard]] double by_turns(const Curve& curve, double length) const;
  /// The edge length for a curvature, where the surface given turns by `angle` at once.
  [[nodiscard]] double length_for(double curvature, double angle) const;

  const Features& features_;
  SizeLimits limits_;
  boxes::BoxQuantizer frame_;
  std::vector<Bend> bends_;
  std::vector<std::uint8_t> is_bent_;  // per region, whether it has any
  std::vector<CurveEdge> curve_edges_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> curves_at_;  // corner and curve, ascending
  std::optional<boxes::BoxTree> bend_tree_, curve_tree_;

  /// What is known of a place on curves: how far along them another one is.
  template <class Along>
  [[nodiscard]] double by_gaps(const Vec3& point, std::span<const std::uint32_t> regions,
                               double most, const Along& along) const;
};

}  // namespace dupin::remeshing
