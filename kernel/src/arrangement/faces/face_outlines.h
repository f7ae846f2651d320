#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "arrangement/constraints.h"
#include "arrangement/faces/constrained_triangulation.h"
#include "arrangement/faces/subdivision.h"
#include "arrangement/input.h"

namespace dupin::arrangement {

/// The regions of one facet (flat_facets.h) after another as polygons, without triangulating them:
/// half of what a union cuts out it throws away. For facets of the common kind: the segments on one
/// meet each other in common ends only, each point inside ends at least two, and all hangs together
/// with the facet's sides, so that regions are simple polygons without holes. Needs UpwardRounding.
class FaceOutlines {
 public:
  FaceOutlines(const ArrangementInput& input, const Constraints& constraints);

  /// Finds those of the facet that a triangle stands for; false if it is of another kind.
  [[nodiscard]] bool find(std::uint32_t triangle, const Projection& projection);
  /// Appends them with regions, all of which have the last `covers` of the subdivision's covers.
  void append(std::size_t covers, Subdivision& subdivision) const;

 private:
  using Vertex = ConstrainedTriangulation::Vertex;
  // Of the facet's sides come first, each as the vertex it leaves, then both of each segment.
  using HalfEdge = std::uint32_t;
  using Segment = std::array<Vertex, 2>;
  struct SegmentBox {
    std::array<double, 2> low, high;
    std::uint32_t segment;
  };

  void collect_outer_points();
  [[nodiscard]] bool collect_segments();
  [[nodiscard]] std::uint32_t& slot_of(PointId id);
  [[nodiscard]] bool segments_keep_apart();
  [[nodiscard]] std::size_t thinner_axis() const;
  [[nodiscard]] bool keep_apart(const Segment& s, const Segment& t) const;
  [[nodiscard]] bool sort_around_points();
  [[nodiscard]] bool sort_around(Vertex v);
  [[nodiscard]] bool sort_strictly(Vertex v, std::size_t begin, std::size_t end);
  [[nodiscard]] bool certainly_go_opposite_ways(Vertex v, Vertex first, Vertex second) const;
  [[nodiscard]] bool go_opposite_ways(Vertex v, Vertex first, Vertex second) const;
  void link_half_edges();
  [[nodiscard]] bool trace();
  [[nodiscard]] Vertex origin(HalfEdge h) const {
    return h < outer_ ? h : segments_[(h - outer_) / 2][(h - outer_) % 2];
  }
  [[nodiscard]] Vertex target(HalfEdge h) const {  // of a segment's
    return segments_[(h - outer_) / 2][1 - (h - outer_) % 2];
  }
  [[nodiscard]] PointId point_to_the_left(HalfEdge h) const;
  [[nodiscard]] PointId point_beside_partner(HalfEdge h) const;

  const ArrangementInput& input_;
  const Constraints& constraints_;
  ConstrainedTriangulation plane_;  // of points only: it tells turns
  // Of the present facet:
  std::uint32_t triangle_ = 0;
  FlatFacets::Corners facet_;
  Projection projection_;
  std::vector<PointId> ids_;          // of vertices; those on the facet's sides come first
  std::vector<std::uint8_t> sides_;   // on which they lie
  std::uint32_t outer_ = 0;           // how many of them lie on any
  std::array<Vertex, 4> corners_{};   // of the facet
  std::vector<std::uint32_t> slots_;  // a hash table of ids_
  std::vector<Segment> segments_;
  std::vector<SegmentBox> boxes_;
  std::vector<std::uint32_t> first_;  // into out_, by vertex
  std::vector<HalfEdge> out_;         // of segments, out of each vertex, counter-clockwise
  std::vector<HalfEdge> onward_;      // after each
  std::vector<HalfEdge> traced_;      // one outline after the other
  std::vector<std::uint32_t> first_traced_, outline_of_, seen_;
};

/// Triangulates outlines.
class OutlineTriangulator {
 public:
  explicit OutlineTriangulator(const ArrangementInput& input);

  /// Appends the triangles of one, oriented as its region's support.
  void append(const Subdivision& subdivision, const Subdivision::Outline& outline,
              std::vector<Subdivision::SubTriangle>& triangles);

 private:
  using Vertex = ConstrainedTriangulation::Vertex;
  struct Corner {  // of what is not yet cut off
    Vertex previous, next;
    bool is_convex;
  };

  void cut_ears();
  [[nodiscard]] bool is_ear(Vertex v) const;
  [[nodiscard]] Vertex next_ear(Vertex first);
  [[nodiscard]] int turn(Vertex a, Vertex b, Vertex c) const {
    return exactly_ ? triangulation_.turn(a, b, c) : triangulation_.certain_turn(a, b, c);
  }

  const ArrangementInput& input_;
  ConstrainedTriangulation triangulation_;
  std::vector<Corner> corners_;
  std::vector<std::array<Vertex, 3>> ears_;
  bool exactly_ = false;  // once no ear is certain
};

}  // namespace dupin::arrangement
