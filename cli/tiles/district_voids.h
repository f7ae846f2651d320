#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/check.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/rounding.h"

namespace dupin::cli {

/// A shell around a void of one district, in which others may lie as a whole: boxes about one are
/// connected, and touch none about another.
struct DistrictVoid {
  Eigen::AlignedBox3d box;
  std::vector<Vec3> places{};           ///< those of other districts in the box
  std::vector<std::uint8_t> is_within;  ///< of each of these, whether it lies in the void
};

/// A place of each district that lies in its boxes, to ask in what voids it is. None of a district
/// without boxes.
class DistrictPlaces {
 public:
  explicit DistrictPlaces(std::span<const Boxes> boxes);

  /// Those of other districts in the box, in a fixed order.
  [[nodiscard]] std::vector<Vec3> in(const Eigen::AlignedBox3d& box, std::size_t but_of) const;
  [[nodiscard]] const std::vector<Vec3>& by_district() const { return by_district_; }

 private:
  std::vector<Vec3> by_district_;
  std::vector<std::uint32_t> along_x_;  // districts that have one, ascending
};

/// The voids of a district, of whose rounding the report is; decided exactly.
[[nodiscard]] std::vector<DistrictVoid> voids_of(const Rounded& rounded, const Report& report,
                                                 std::size_t district,
                                                 const DistrictPlaces& places);

/// Whether other districts still are where these voids, which were kept, were asked for them.
[[nodiscard]] bool are_known(std::span<const DistrictVoid> voids, std::size_t district,
                             const DistrictPlaces& places);

/// How much deeper each district's shells lie, once the voids of all are there.
class DistrictDepths {
 public:
  void add(std::span<const DistrictVoid> voids);
  /// The number of shells of other districts around this place of one.
  [[nodiscard]] int at(const Vec3& place) const;

 private:
  std::map<std::array<double, 3>, int> voids_;  // around places
};

}  // namespace dupin::cli
