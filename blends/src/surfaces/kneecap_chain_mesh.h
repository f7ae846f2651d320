#pragma once

#include <cstdint>
#include <vector>

#include "dupin/blends/pe_arc.h"
#include "dupin/blends/tessellation.h"

namespace dupin::surfaces {

/// What segments_for() and tessellate() do for chains of these arcs with spherical joints, between
/// the rings stored at their ends.
[[nodiscard]] std::uint32_t kneecap_chain_segments(const std::vector<PeArc>& arcs, double tolerance,
                                                   double grid);
/// About how many rows of triangles the joints' kneecaps have.
[[nodiscard]] double expected_kneecap_rows(const std::vector<PeArc>& arcs,
                                           const RingSampling& sampling, double tolerance);

/// Triangles, and what bounds their distance from the pieces and the balls.
struct KneecapChainMesh {
  Tessellation tessellation;
  std::vector<double> knots;  ///< parameters of the rows, i + t on the i-th piece
  double turn = 0;            ///< radians by which columns turn at most from row to row
  double apart = 0;           ///< so near circles of a joint, or their crossings, are taken for one
  std::vector<double> depths;  ///< of the triangles of each joint's kneecap; 0 where there is none
};

[[nodiscard]] KneecapChainMesh kneecap_chain_mesh(const Ring& start, const Ring& end,
                                                  const std::vector<PeArc>& arcs,
                                                  const RingSampling& sampling,
                                                  const TessellationOptions& options);

}  // namespace dupin::surfaces
