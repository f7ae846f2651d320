#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "arrangement/constraints.h"
#include "arrangement/faces/constrained_triangulation.h"
#include "arrangement/faces/face_outlines.h"
#include "arrangement/faces/subdivision.h"
#include "arrangement/input.h"

namespace dupin::arrangement {

/// Results of some faces one after another, with covers and regions of their own numbering and new
/// points numbered from ConstrainedTriangulation::kNewPoint.
struct FaceSubdivision {
  Subdivision local;
  std::vector<ConstrainedTriangulation::NewPoint> new_points;
};

/// Divides one face after another by the points and segments on it, and finds what covers its
/// regions; as outlines where that does. Needs UpwardRounding.
class FaceTriangulator {
 public:
  FaceTriangulator(const ArrangementInput& input, const BooleanRule& rule,
                   const Constraints& constraints);
  FaceTriangulator(const FaceTriangulator&) = delete;
  FaceTriangulator& operator=(const FaceTriangulator&) = delete;

  /// `members`: the triangles of the face, which overlap in one plane, or one that stands for a
  /// facet.
  void append(std::span<const std::uint32_t> members, FaceSubdivision& result);

 private:
  struct Slot {
    std::uint32_t partner;  ///< a triangle whose plane holds the line, or kNone
    /// Members of which it is an edge; for those of a sheet, its first one.
    std::vector<std::uint32_t> bounding;
  };
  struct MemberIncidences {
    FlatFacets::Corners corners;
    std::array<std::span<const Constraints::OnEdge>, 4> on_edges;  // of as many sides
    std::span<const Constraints::Inside> insides;
    std::span<const Constraints::Segment> segments;
  };
  using Members = std::vector<std::uint32_t>;
  using Lines = ConstrainedTriangulation::Lines;

  [[nodiscard]] ImplicitPoint crossing(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::uint32_t both(std::uint32_t present, std::uint32_t added);
  [[nodiscard]] std::uint32_t last_slot() const {
    return static_cast<std::uint32_t>(slots_.size() - 1);
  }
  void collect_points();
  [[nodiscard]] std::size_t index_of(PointId id) const;
  [[nodiscard]] ConstrainedTriangulation::Vertex vertex(PointId id) const {
    return vertices_[index_of(id)];
  }
  void collect_lines();
  [[nodiscard]] Lines line_in_plane_of(std::uint32_t partner, Lines& next);
  void insert(PointId id);
  void find_sheets();
  [[nodiscard]] std::uint32_t member_of(std::uint32_t triangle) const;
  [[nodiscard]] const TrianglePair* inner_side(std::size_t member, std::size_t side) const;
  void start_from_facet();
  void start_from_frame();
  void insert_remaining();
  void constrain_edges(std::size_t member);
  void constrain_segments();
  void find_regions();
  [[nodiscard]] std::size_t region_count() const { return first_in_region_.size() - 1; }
  [[nodiscard]] std::vector<Members> find_covers() const;
  [[nodiscard]] std::vector<SignedTriangle> signed_cover(
      std::span<const std::uint32_t> members) const;
  template <class Emit>
  void emit_single(FaceSubdivision& result, Emit&& emit) const;
  void emit_regions(std::size_t covers, FaceSubdivision& result) const;
  void emit_overlapping(FaceSubdivision& result) const;
  void emit_sub_triangles(std::uint32_t region, bool reversed, FaceSubdivision& result) const;

  const ArrangementInput& input_;
  const BooleanRule& rule_;
  const Constraints& constraints_;
  FaceOutlines outlines_;
  ConstrainedTriangulation triangulation_;
  // Of the present face:
  std::span<const std::uint32_t> members_;
  std::vector<MemberIncidences> incidences_of_;  // of each member
  std::vector<std::uint32_t> sheet_of_;          // of each member the first one of its sheet
  Projection projection_;
  std::vector<Slot> slots_;
  std::vector<PointId> ids_;
  std::vector<ConstrainedTriangulation::Vertex> vertices_;
  std::vector<Lines> lines_;  // that each point lies on
  std::vector<std::pair<Triangle, Lines>> planes_;
  std::vector<std::uint32_t> region_of_;        // per face of the triangulation
  std::vector<std::uint32_t> in_order_;         // its faces by region
  std::vector<std::uint32_t> first_in_region_;  // and one past the last
};

}  // namespace dupin::arrangement
