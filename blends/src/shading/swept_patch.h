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

  /// Nearly that of a place nearly on the surface: the distance is off by the square of that, and
  /// of the way between two of the stored sections.
  [[nodiscard]] std::optional<Foot> rough_foot(const Vec3& place) const;

  /// Holds the patch.
  [[nodiscard]] const Eigen::AlignedBox3d& box() const { return box_; }

 private:
  static constexpr int kCells = 48;

  // A point of a section in the direction of a place.
  struct Point {
    Vec3 position, normal;
    double distance = 0;  // of the place, nearly
    double radius = 1;
  };

  [[nodiscard]] double ahead(const Vec3& place, double t) const;
  [[nodiscard]] double parameter(const Vec3& place, int cell, double before, double after,
                                 bool roughly) const;
  [[nodiscard]] std::optional<Point> towards(const Vec3& place, double t, bool is_beyond) const;
  [[nodiscard]] std::optional<Point> nearest(const Vec3& place, bool roughly) const;

  SectionFamily family_;
  std::vector<Vec3> normals_;      // of the planes
  std::vector<double> distances_;  // of them from the origin
  Eigen::AlignedBox3d box_;
};

}  // namespace dupin::shading
