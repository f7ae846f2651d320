#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/vec.h"

/// Whether closed curves of edges, seen along an axis, bound a region: the contour test of [VM94],
/// made exact, for height_field_patches.h.
///
/// Lemma. Directed edges of which as many begin as end at each point, that meet in common ends
/// only, and that begin and end in turn around each point, are simple closed curves without
/// crossings. Along such a curve the winding number of all of them is constant on either side, one
/// higher on the left. So they wind about every place once or not at all if, next to the lowest
/// point of each curve, the others wind about it not at all where the curve turns left, once where
/// it turns right. The margin keeps the order of edges around points and windings as they are.
namespace dupin::checking {

/// From a point to another one.
struct DirectedEdge {
  std::uint32_t from, to;
};

/// What keeps directed edges, seen along `axis`, from bounding a region that lies to the left of
/// each if `turn` is +1, to the right if -1: the places of edges that cross others, or about whose
/// ends there is no such region, ascending; none if there is one for certain, wherever each
/// coordinate of each point moves by at most `margin`. At every point, as many edges begin as end.
/// O(n log n) where few boxes of edges overlap.
[[nodiscard]] std::vector<std::uint32_t> region_conflicts(std::span<const Vec3> points,
                                                          std::span<const DirectedEdge> edges,
                                                          int axis, int turn, double margin = 0);

}  // namespace dupin::checking
