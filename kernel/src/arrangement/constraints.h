#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "arrangement/flat_facets.h"
#include "arrangement/flat_sheets.h"
#include "arrangement/input.h"
#include "arrangement/points/coincident_point_index.h"
#include "arrangement/triangle_intersection.h"
#include "support/bulk_vector.h"

namespace dupin::arrangement {

/// What the arrangement adds to each facet (flat_facets.h), by the triangle that stands for it, and
/// to each side. All facets at a side see the same points on it.
struct Constraints {
  struct OnEdge {
    EdgeKey edge;
    PointId point;
  };
  struct Inside {
    std::uint32_t triangle;
    PointId point;
  };
  /// With n the normal of whichever of the two has the lower number, and m the other one's, it runs
  /// from end to end along n x m.
  struct Segment {
    std::uint32_t triangle;
    PointId from, to;
    std::uint32_t partner;  ///< the segment lies in the plane of this triangle too
  };

  support::BulkVector<OnEdge> on_edges;  ///< by edge, then from its lower to its upper end
  std::vector<Inside> insides;           ///< by triangle
  std::vector<Segment> segments;         ///< by triangle
  /// Facets to retriangulate together: connected by coplanar overlap. Members ascend.
  std::vector<std::vector<std::uint32_t>> overlapping;
  std::vector<std::uint32_t> alone;   ///< facets to retriangulate by themselves, ascending
  std::vector<std::uint8_t> touched;  ///< per triangle: part of a face
  FlatFacets facets;
  FlatSheets sheets;
  /// Of all points that may coincide with new ones.
  std::optional<CoincidentPointIndex> coincident_points;

  /// What to retriangulate: first what overlaps, then triangles alone.
  [[nodiscard]] std::size_t face_count() const { return overlapping.size() + alone.size(); }
  [[nodiscard]] std::span<const std::uint32_t> face(std::size_t i) const {
    return i < overlapping.size() ? std::span(overlapping[i])
                                  : std::span(alone).subspan(i - overlapping.size(), 1);
  }
  [[nodiscard]] std::span<const OnEdge> on_edge(EdgeKey edge) const;
  [[nodiscard]] std::span<const Inside> inside(std::uint32_t triangle) const;
  [[nodiscard]] std::span<const Segment> segments_of(std::uint32_t triangle) const;
};

/// Stage 4: makes the points of the intersections, coincident ones once, and hands them to the
/// edges and triangles they lie on. Adds points to the input and marks special ones. Needs
/// UpwardRounding.
[[nodiscard]] Constraints collect_constraints(ArrangementInput& input,
                                              std::span<const TriangleIntersection> intersections,
                                              std::span<const TrianglePair> crossed_sheets = {});

}  // namespace dupin::arrangement
