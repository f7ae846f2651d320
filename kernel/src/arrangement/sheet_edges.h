#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "arrangement/broad_phase.h"
#include "arrangement/input.h"
#include "arrangement/triangle_intersection.h"

namespace dupin::arrangement {

/// Edges inside of flat sheets (flat_sheets.h) that are known to be so before it is known what
/// meets them: between triangles that lie in the planes of others, with an end around which there
/// is one fan, so that no third triangle has the edge. Where two of them cross there will be no
/// point, and none is made to be left out: in sheets that overlap, nearly all points are such.
class SheetEdges {
 public:
  /// Of the triangles of pairs that lie in one plane; none if operands may cross themselves.
  SheetEdges(const ArrangementInput& input, std::span<const TrianglePair> in_plane);

  /// Notes that edges of two triangles of a pair cross, if both are inside of sheets; else false.
  /// May be called on any thread.
  bool cross(std::uint32_t first, std::size_t first_edge, std::uint32_t second,
             std::size_t second_edge);
  /// The two triangles at each edge that crosses another; ascending.
  [[nodiscard]] std::vector<TrianglePair> crossed() const;

 private:
  using OfTriangle = std::array<std::uint32_t, 3>;  // numbers of its edges, or kNone
  struct Inner {
    TrianglePair sides;
    std::uint8_t is_crossed;
  };
  [[nodiscard]] std::uint32_t number(std::uint32_t triangle, std::size_t edge) const {
    return edges_[place_[triangle]][edge];
  }

  std::vector<std::uint32_t> place_;  // per triangle of the input, those of pairs in their order
  std::vector<OfTriangle> edges_;     // of each of these
  std::vector<Inner> inner_;
};

}  // namespace dupin::arrangement
