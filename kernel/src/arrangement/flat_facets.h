#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arrangement/broad_phase.h"
#include "arrangement/input.h"
#include "arrangement/triangle_intersection.h"

namespace dupin::arrangement {

/// Triangles and quadrilaterals that are divided as one: two triangles of an operand on both sides
/// of an edge that is longer than all others of both, in one plane and under one label, make a
/// strictly convex facet. Nothing has to be cut where others cross the edge between them: the plane
/// goes on there. Of pipes and boxes that is every other edge, so that half of all points, and of
/// what follows from them, need not be. Which triangles are one depends on nothing but these two.
///
/// Lemma: what two strictly convex facets in different planes have in common is a segment, a point,
/// or nothing, and ends on the sides of either. So where triangles of theirs meet in a segment with
/// an end on an inner edge (a joint), it goes on in the next triangle, unless a side of the other
/// facet, along which it does not run, ends it there; and all these pieces are one segment. In one
/// plane, sides cross inner edges in joints, too.
class FlatFacets {
 public:
  /// Corners counter-clockwise, as seen from the front.
  struct Corners {
    std::array<PointId, 4> ids{};
    std::size_t count = 0;
    [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 < count ? i + 1 : 0; }
    [[nodiscard]] std::size_t before(std::size_t i) const { return (i > 0 ? i : count) - 1; }
    [[nodiscard]] PointId operator[](std::size_t i) const { return ids[i]; }
    [[nodiscard]] std::span<const PointId> all() const { return std::span(ids).first(count); }
  };

  /// Every triangle is a facet.
  FlatFacets() = default;
  /// Of the candidates, two triangles at an edge of no others, those that are one facet. Operands
  /// do not cross themselves.
  FlatFacets(const ArrangementInput& input, const std::vector<TrianglePair>& candidates);

  [[nodiscard]] bool empty() const { return mates_.empty(); }
  /// The triangle that stands for the facet that this one is part of.
  [[nodiscard]] std::uint32_t of(std::uint32_t triangle) const {
    return mates_.empty() ? triangle : std::min(triangle, mates_[triangle].triangle);
  }
  /// The other triangle of the facet, or kNone.
  [[nodiscard]] std::uint32_t mate(std::uint32_t triangle) const {
    return mates_.empty() ? kNone : mates_[triangle].triangle;
  }
  /// Whether an edge of the triangle lies inside of its facet.
  [[nodiscard]] bool is_inner_edge(std::uint32_t triangle, Feature feature) const {
    return !mates_.empty() && mates_[triangle].edge == feature && is_edge(feature);
  }
  /// Whether a place on the triangle lies inside of its facet.
  [[nodiscard]] bool is_inside(std::uint32_t triangle, Feature feature) const {
    return feature == kInside || is_inner_edge(triangle, feature);
  }
  /// Whether what the facets have in common goes on at an end of what their triangles have.
  [[nodiscard]] bool is_joint(const TriangleIntersection& e, std::size_t end) const;
  /// Of the facet that the triangle stands for.
  [[nodiscard]] Corners corners(const ArrangementInput& input, std::uint32_t triangle) const;

 private:
  struct Mate {
    std::uint32_t triangle;
    Feature edge;  // of the triangle whose mate it is, between both; kInside if there is none
  };
  support::BulkVector<Mate> mates_;  // per triangle, or empty if there are none
};

/// Two triangles with a common edge as a quadrilateral, whose corners 1 and 3 are the edge's ends.
[[nodiscard]] FlatFacets::Corners joined(const Triangle& first, const Triangle& second);

/// Whether two triangles with a common edge lie in one plane, are of one operand and under one
/// label, and coincide with no others.
[[nodiscard]] bool lie_in_one_plane(const ArrangementInput& input, const TrianglePair& pair);

}  // namespace dupin::arrangement
