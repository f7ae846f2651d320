#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "arrangement/points/implicit_points.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"

namespace dupin::arrangement {

/// An edge by its ends, the lower one first.
using EdgeKey = std::uint64_t;
[[nodiscard]] constexpr EdgeKey edge_key(PointId a, PointId b) {
  return a < b ? (EdgeKey{a} << 32 | b) : (EdgeKey{b} << 32 | a);
}
[[nodiscard]] constexpr PointId lower_end(EdgeKey edge) { return static_cast<PointId>(edge >> 32); }
[[nodiscard]] constexpr PointId upper_end(EdgeKey edge) { return static_cast<PointId>(edge); }

/// What to compute: operands fall into groups; a point of space is inside the result by how often
/// the operands of each group contain it.
struct BooleanRule {
  std::vector<std::uint32_t> group_of_operand;
  std::uint32_t groups = 0;
  std::function<bool(std::span<const int>)> inside;  ///< one count per group
  /// Sheets that lie upon each other and change no count are told on which side they are; else they
  /// are left out, which is quicker.
  bool keeps_cancelled = false;
};

/// A triangle of the input, seen from its front (+1) or its back (-1).
struct SignedTriangle {
  std::uint32_t triangle = 0;
  int sign = 1;
  friend bool operator==(const SignedTriangle&, const SignedTriangle&) = default;
};

/// Operands to compare, or one that may cross itself, twice.
using OperandPair = std::array<std::uint32_t, 2>;

/// Stage 1: all operands in one index space, coincident points welded, coincident triangles merged.
struct ArrangementInput {
  using Bounds = Eigen::AlignedBox3d;
  struct Duplicate {
    std::uint32_t kept;
    SignedTriangle copy;
  };

  std::span<const mesh::ExactMesh* const> operands;
  PointTable points;
  std::vector<PointId> first_double;          ///< of each operand, and one past the last
  std::vector<PointId> first_implicit;        ///< of each operand, and one past the last
  support::BulkVector<Triangle> triangles;    ///< of all operands, in order
  support::BulkVector<Triangle> supports;     ///< empty if every triangle is its own support
  std::vector<std::uint32_t> first_triangle;  ///< of each operand, and one past the last
  std::vector<Bounds> bounds;                 ///< of each operand
  double extent = 0;                          ///< bounds the magnitude of all coordinates
  std::vector<OperandPair> operand_pairs;     ///< to compare, ascending
  /// Per triangle, or empty: whether it may meet others of its operand but in what they share.
  std::span<const std::uint8_t> crossing;
  /// Per point: more than one fan may meet there, or no triangle has it for a corner.
  std::vector<std::uint8_t> special;
  std::vector<std::uint8_t> merged;   ///< per triangle: cancelled, or a copy of another
  std::vector<Duplicate> duplicates;  ///< of triangles that stay, by triangle

  [[nodiscard]] std::uint32_t operand_of(std::uint32_t triangle) const;
  /// A point of an operand, before any are welded.
  [[nodiscard]] PointId point_of(std::size_t operand, std::uint32_t index) const {
    const std::uint32_t doubles = first_double[operand + 1] - first_double[operand];
    return index < doubles ? first_double[operand] + index
                           : first_implicit[operand] + (index - doubles);
  }
  /// Of a point that an operand brought.
  [[nodiscard]] std::uint32_t operand_of_point(PointId point) const;
  /// Three points that span the plane of the triangle, with its orientation.
  [[nodiscard]] const Triangle& support(std::uint32_t triangle) const {
    return supports.empty() ? triangles[triangle] : supports[triangle];
  }
  /// The triangles that coincide with a kept one, itself first.
  [[nodiscard]] std::vector<SignedTriangle> cover(std::uint32_t triangle) const;
};

/// By how much the count of each group grows from the front of coincident triangles to their back.
[[nodiscard]] inline std::vector<int> winding_change(const ArrangementInput& input,
                                                     const BooleanRule& rule,
                                                     std::span<const SignedTriangle> cover) {
  std::vector<int> change(rule.groups, 0);
  for (const SignedTriangle& t : cover) {
    change[rule.group_of_operand[input.operand_of(t.triangle)]] += t.sign;
  }
  return change;
}

/// Whether some operand is compared with itself.
[[nodiscard]] inline bool may_cross_themselves(const ArrangementInput& input) {
  return std::ranges::any_of(input.operand_pairs,
                             [](const OperandPair& pair) { return pair[0] == pair[1]; });
}

[[nodiscard]] inline bool changes_nothing(std::span<const int> change) {
  return std::all_of(change.begin(), change.end(), [](int c) { return c == 0; });
}

/// Whether nothing has to be known of a face that these triangles cover, which may be none.
[[nodiscard]] inline bool is_cancelled(const ArrangementInput& input, const BooleanRule& rule,
                                       std::span<const SignedTriangle> cover) {
  const bool is_kept = rule.keeps_cancelled && !cover.empty();
  return !is_kept && changes_nothing(winding_change(input, rule, cover));
}

/// `pairs`, ascending; if there are none, those whose bounds meet. Throws Error{limit_exceeded} if
/// the points or triangles are more than indices can count. Needs UpwardRounding.
[[nodiscard]] ArrangementInput load_operands(std::span<const mesh::ExactMesh* const> operands,
                                             const BooleanRule& rule,
                                             std::vector<OperandPair> pairs = {});

}  // namespace dupin::arrangement
