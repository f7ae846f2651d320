#include "surfaces/mesh_cost.h"

#include <variant>
#include <vector>

#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/parallel.h"
#include "surfaces/kneecap_chain_mesh.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin::surfaces {
namespace {

// At worst all: the boxes of triangles along a tube that is oblique to the axes of coordinates.
double pairs_of_needles(double segments) { return segments * segments / 2; }

MeshCost skin_cost(const Chain& chain, const RingSampling& sampling, double tolerance) {
  const double segments = sampling.segments;
  MeshCost cost;
  double rows = chain.joints == Joints::spherical
                    ? expected_kneecap_rows(cyclide_pieces(chain), sampling, tolerance)
                    : 0;
  std::vector<double> bands(chain.pieces.size());
  for_each_in_parallel(bands.size(), [&](std::size_t i) {
    bands[i] = std::visit([&](const auto& p) { return expected_bands(p, sampling, tolerance); },
                          chain.pieces[i]);
  });
  for (const double own : bands) {
    rows += own;
    cost.pairs += pairs_of_needles(segments) / own;
  }
  cost.triangles = 2 * segments * rows;
  return cost;
}

}  // namespace

MeshCost mesh_cost(const Chain& chain, const RingSampling& sampling, double tolerance) {
  MeshCost cost = skin_cost(chain, sampling, tolerance);
  if (chain.wall > 0) {
    const MeshCost inner = skin_cost(inner_skin(chain), sampling, tolerance);
    cost.triangles += inner.triangles + 4. * sampling.segments;
    cost.pairs += inner.pairs;
  }
  return cost;
}

MeshCost mesh_cost(const Sphere&, const RingSampling& sampling, double) {
  return {double(sampling.segments) * sampling.segments, 0};
}

}  // namespace dupin::surfaces
