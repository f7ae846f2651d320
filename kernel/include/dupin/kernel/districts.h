#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/solid.h"

/// A large model falls into districts: things that have nothing to do with each other, because
/// boxes about all of each do not touch. What is made of one does not depend on the others, so that
/// one can be made after the other, in little memory, with the same result.
namespace dupin {

/// For each box the number of its district: boxes that touch are in one. Districts are numbered in
/// the order of their first boxes. Empty boxes touch nothing, infinite ones all. O(n log n) and the
/// pairs that touch.
[[nodiscard]] std::vector<std::uint32_t> districts_of(std::span<const Eigen::AlignedBox3d> boxes);

/// Whether each triangle lies in the interior of one of the boxes, by exact comparisons. O(n) where
/// triangles in the same box follow one another.
[[nodiscard]] bool lies_in(const Solid& solid, const Boxes& boxes);
/// The same of the mesh where the solid is, whatever origin was subtracted.
[[nodiscard]] bool lies_in(const Rounded& rounded, const Boxes& boxes);

/// The union of solids, each in boxes of its own which touch none of another's; in its sources, the
/// operands are numbered like them. O(n). Throws Error{invalid_argument} where one does not lie in
/// its boxes, or boxes of two touch.
[[nodiscard]] Solid joined(std::span<const Solid> solids, std::span<const Boxes> boxes);

/// The same of rounded solids, in their order, the report that of all. Throws
/// Error{invalid_argument} also where origins or coordinates differ.
[[nodiscard]] Rounded joined(std::span<const Rounded> all, std::span<const Boxes> boxes);

/// What is said of all, those of the district coming behind the others: coordinates and origin are
/// the district's.
void add(const RoundingReport& district, RoundingReport& all);
/// The same of a check, without its findings.
void add(const Report& district, Report& all);

/// A box about all boxes.
[[nodiscard]] Eigen::AlignedBox3d bounds_of(std::span<const Boxes> boxes);

}  // namespace dupin
