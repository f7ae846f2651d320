#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

#include "exchange/exchange_model.h"

namespace dupin::occt {

/// A part of a ring between two vertices, by its angle.
struct RingArc {
  TopoDS_Edge edge;
  double from = 0, to = 0;
};

/// A ring as edges that all faces at it share: one for each place where a face has its seam.
class RingEdges {
 public:
  explicit RingEdges(const exchange::RingCurve& ring) : ring_(ring) {}

  /// Before `make`: a face's seam ends at this angle. Those within rounding are one.
  void add_seam(double angle);
  [[nodiscard]] bool has_seam() const { return !angles_.empty(); }
  [[nodiscard]] double seam() const { return angles_.front(); }
  void make();

  [[nodiscard]] const exchange::RingCurve& ring() const { return ring_; }
  /// In the order of angles, from one vertex round to it again.
  [[nodiscard]] const std::vector<RingArc>& arcs() const { return arcs_; }
  /// The arc that begins at the seam.
  [[nodiscard]] std::size_t arc_at(double angle) const;
  [[nodiscard]] const TopoDS_Vertex& vertex_at(double angle) const;

 private:
  exchange::RingCurve ring_;
  std::vector<double> angles_;  // in [0, 2 pi)
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<RingArc> arcs_;
};

}  // namespace dupin::occt
