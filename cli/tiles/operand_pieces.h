#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "dupin/kernel/districts.h"
#include "tiles/cut_mesh.h"
#include "tiles/united_districts.h"

namespace dupin::cli {

/// An operand, or what is between two planes across an axis of it.
struct OperandStretch {
  std::size_t operand = 0;
  int axis = 0;
  std::optional<PlaneCut> from{}, to{};

  [[nodiscard]] bool is_cut() const { return from || to; }
};

/// Operands in districts, and of large ones in pieces, which are joined again where operands were
/// cut.
struct OperandPieces {
  std::vector<std::vector<OperandStretch>> stretches;  ///< per district, in its order
  std::vector<Boxes> boxes;                            ///< likewise
  /// Likewise, of the operands: as if these had them everywhere along their axes.
  std::vector<double> triangles;
  std::vector<Seam> seams;
};

/// What is known of operands, and how far they are to be divided.
struct OperandDivision {
  std::span<const Eigen::AlignedBox3d> boxes;  ///< about all corners
  std::span<const std::size_t> triangles;
  double most = 0;                     ///< triangles that are expected of a piece; 0: all are whole
  const std::set<std::size_t>& uncut;  ///< operands that are not cut
};

/// So many operands hang together at least in what is divided.
constexpr std::size_t kLeastOperands = 32;

/// Districts of which more triangles are expected than a piece may have are cut, each operand
/// across the axis along which it is longest, where no other one is near, at planes that are the
/// same for all. What cannot be divided so far stays larger. O(n log n) and as `for_each_touching`.
[[nodiscard]] OperandPieces operand_pieces(const OperandDistricts& districts,
                                           const OperandDivision& division);

}  // namespace dupin::cli
