#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "shading/section_family.h"

namespace dupin::shading {

/// What a surface is next to a place: how far it is, nearly, and its unit normal there, to either
/// side.
struct Foot {
  double distance = 0;
  Vec3 normal = Vec3::UnitZ();
};

/// A family with the planes of some of its sections, between which points find theirs.
class SweptPatch {
 public:
  explicit SweptPatch(SectionFamily family);

  /// The foot of a place: in the plane of the section through it, and again for the place moved
  /// onto the surface, until it is the nearest point. Beyond the ends, that of the end section. Of
  /// several, the nearest; none where the surface has no normal. O(1).
  [[nodiscard]] std::optional<Foot> foot(const Vec3& place) const;

  /// Holds the patch.
  [[nodiscard]] const Eigen::AlignedBox3d& box() const { return box_; }

 private:
  static constexpr int kCells = 48;

  struct Found {
    double t = 0;
    bool beyond = false;  // an end
  };

  [[nodiscard]] double ahead(const Vec3& place, double t) const;
  [[nodiscard]] double parameter(const Vec3& place, int cell, double before, double after) const;
  [[nodiscard]] std::optional<Foot> foot_in(const Vec3& place, const Found& found, Vec3& on) const;
  [[nodiscard]] std::optional<Foot> nearest_in_section(const Vec3& place, Vec3& on) const;

  SectionFamily family_;
  std::vector<Vec3> normals_;      // of the planes
  std::vector<double> distances_;  // of them from the origin
  Eigen::AlignedBox3d box_;
};

}  // namespace dupin::shading
