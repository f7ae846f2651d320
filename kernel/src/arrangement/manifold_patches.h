#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "arrangement/faces/subdivision.h"
#include "arrangement/input.h"
#include "arrangement/points/implicit_predicates.h"
#include "support/blocks.h"
#include "support/disjoint_sets.h"

namespace dupin::arrangement {

/// Stage 6: maximal parts of the surfaces with nothing of the arrangement between them.
///
/// Members are numbered: first the points (a point that is not special stands for the triangles
/// around it), then the regions, then the triangles whose corners are all special.
class ManifoldPatches {
 public:
  struct Side {  ///< of an edge whose ends are both special
    EdgeKey edge;
    HalfPlane half_plane;  ///< its owner is a member
  };

  /// Needs UpwardRounding.
  ManifoldPatches(const ArrangementInput& input, const BooleanRule& rule,
                  const Subdivision& subdivision);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(changes_.size()); }
  [[nodiscard]] std::uint32_t of_region(std::uint32_t region) const {
    return number_[first_region_ + region];
  }
  /// Of a triangle that is neither touched nor merged.
  [[nodiscard]] std::uint32_t of_triangle(std::uint32_t triangle) const {
    return number_[member_of_triangle(triangle)];
  }
  [[nodiscard]] std::uint32_t of_member(std::uint32_t member) const { return number_[member]; }
  /// How the counts of the groups grow from the front of a patch to its back.
  [[nodiscard]] const std::vector<int>& change(std::uint32_t patch) const {
    return all_changes_[changes_[patch]];
  }
  /// Edges where patches meet, in ascending order: runs of sides.
  [[nodiscard]] const std::vector<support::IndexRange>& seams() const { return seams_; }
  [[nodiscard]] std::span<const Side> sides(const support::IndexRange& seam) const {
    return std::span(sides_).subspan(seam.begin, seam.end - seam.begin);
  }
  /// To make room, once nobody asks for them any more.
  void forget_seams() {
    support::release(seams_);
    support::release(sides_);
  }

 private:
  [[nodiscard]] std::uint32_t member_of_triangle(std::uint32_t triangle) const;
  /// kNone if all corners are special.
  [[nodiscard]] PointId first_not_special(std::uint32_t triangle) const;
  [[nodiscard]] std::uint32_t change_of(const BooleanRule& rule, std::uint32_t member) const;
  [[nodiscard]] std::uint32_t change_number(std::vector<int> change);
  void find_changes_of_regions(const BooleanRule& rule);
  void join_corners();
  void find_loose(const BooleanRule& rule);
  template <class Found>
  void find_sides(const Triangle& corners, unsigned edges, std::uint32_t support,
                  std::uint32_t member, const Found& found) const;
  template <class Found>
  void find_sides_of_outline(std::size_t outline, const Found& found) const;
  [[nodiscard]] support::BulkVector<Side> sorted_sides() const;
  void join_sides(const BooleanRule& rule);
  void number_patches(const BooleanRule& rule);

  const ArrangementInput& input_;
  const Subdivision& subdivision_;
  std::uint32_t first_region_, first_loose_;
  support::DisjointSets classes_;
  // Untouched triangles with two special corners, and those with three, ascending.
  std::vector<std::uint32_t> bordering_, loose_;
  std::vector<std::uint32_t> member_changes_;  // of regions and loose triangles
  support::BulkVector<Side> sides_;            // by edge
  std::vector<support::IndexRange> seams_;
  std::map<std::vector<int>, std::uint32_t> change_numbers_;
  std::vector<std::vector<int>> all_changes_;
  support::BulkVector<std::uint32_t> number_;  // of the patch of each member that has one
  std::vector<std::uint32_t> changes_;         // of each patch, into all_changes_
};

}  // namespace dupin::arrangement
