#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "arrangement/flat_facets.h"
#include "arrangement/flat_sheets.h"
#include "arrangement/input.h"
#include "arrangement/triangle_intersection.h"
#include "support/bulk_vector.h"

namespace dupin::arrangement {

/// The points at the ends of intersections.
struct IntersectionPoints {
  FlatFacets facets;
  FlatSheets sheets;
  /// Two per intersection; kNone where it has no such end, or has it at a joint of facets or where
  /// edges inside of sheets cross.
  support::BulkVector<PointId> ends;
  std::vector<PointId> corners;  ///< of triangles, met by others; ascending
  PointId first_new_point = 0;
};

/// Finds the corners at ends of intersections, and adds all other ends to the input, but for joints
/// inside of two facets, and of sheets: one point for each pair of edges, or of an edge and a
/// plane, that meet there, in order of first appearance. Of crossed sheets there are no points
/// among the intersections (pair_intersections.h). Needs UpwardRounding.
[[nodiscard]] IntersectionPoints create_intersection_points(
    ArrangementInput& input, std::span<const TriangleIntersection> intersections,
    std::span<const TrianglePair> crossed_sheets = {});

}  // namespace dupin::arrangement
