#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/broad_phase.h"
#include "arrangement/input.h"

namespace dupin::arrangement {

/// Edges inside of flat sheets: between two triangles of an operand, and no others, on both sides
/// of it in one plane and under one label. Where sheets of two operands overlap in one plane, as
/// the flat ends of pipes do, these edges cross each other in as many points as the product of
/// their numbers, and the surface is the same on all sides of such a point. So none is made there,
/// and no sheet is divided along these edges where it overlaps another.
///
/// Lemma: where two of them cross, each of the four triangles overlaps the two at the other edge,
/// which have an area in common with it around the point. So all four are triangulated together,
/// and no other triangle has either edge: an edge that is left out is so on all of its sides.
class FlatSheets {
 public:
  FlatSheets() = default;
  /// Of the candidates, two triangles at an edge of no others where it crosses an edge of another
  /// operand in their plane, those with the edge inside. Operands do not cross themselves.
  FlatSheets(const ArrangementInput& input, const std::vector<TrianglePair>& candidates);

  [[nodiscard]] bool empty() const { return edges_.empty(); }
  /// The two triangles at an edge inside of a sheet; none of any other edge.
  [[nodiscard]] const TrianglePair* at(EdgeKey edge) const;

 private:
  struct Inner {
    EdgeKey edge;
    TrianglePair sides;
  };
  std::vector<Inner> edges_;  // by edge
};

/// Whether two triangles with a common edge, and no others, are part of one sheet. Needs
/// UpwardRounding.
[[nodiscard]] bool are_one_sheet(const ArrangementInput& input, const TrianglePair& pair);

}  // namespace dupin::arrangement
