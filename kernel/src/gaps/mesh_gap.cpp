#include "dupin/kernel/mesh_gap.h"

#include <algorithm>
#include <cmath>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "gaps/boundary_loops.h"
#include "gaps/gap_regions.h"
#include "gaps/union_components.h"

namespace dupin {
namespace {

void validate(const MeshGapOptions& options) {
  if (!std::isfinite(options.connect) || options.connect < 0) {
    throw Error(Errc::invalid_argument,
                "the distance within which faces are connected must be a finite length of at least "
                "0, not " +
                    decimal(options.connect, kMessageDigits));
  }
  if (!(options.cosine > 0 && options.cosine <= 1)) {
    throw Error(Errc::invalid_argument,
                "the cosine for faces that look at each other must be above 0 and at most 1, not " +
                    decimal(options.cosine, kMessageDigits));
  }
}

/// The triangle from its lowest corner on, or read the other way round.
Triangle rotated(Triangle t, bool reversed = false) {
  if (reversed) {
    std::swap(t[1], t[2]);
  }
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

std::size_t count_welded(const gaps::MeshPair& pair) {
  std::vector<Triangle> others;
  for (const Triangle& t : pair.of_b()) {
    others.push_back(rotated(t, true));
  }
  std::sort(others.begin(), others.end());
  const auto of_a = pair.of_a();
  return static_cast<std::size_t>(std::count_if(of_a.begin(), of_a.end(), [&](const Triangle& t) {
    return std::binary_search(others.begin(), others.end(), rotated(t));
  }));
}

}  // namespace

MeshGapReport measure_gaps(const TriMesh& a, const TriMesh& b, const MeshGapOptions& options) {
  const gaps::MeshPair pair = gaps::merged(a, b);
  validate(options);
  const gaps::FaceBoxIndex boxes(pair);

  MeshGapReport report;
  report.flat_faces = pair.flat_faces;
  report.boundary_a = gaps::boundary_loops(a);
  report.boundary_b = gaps::boundary_loops(b);
  report.welded_faces = count_welded(pair);
  report.facing = gaps::gap_regions(pair, boxes, options);
  const bool closed = report.boundary_a.empty() && report.boundary_b.empty();
  const auto topology = gaps::union_topology(pair, boxes, closed);
  report.touching = topology.touching;
  report.components = topology.components;
  return report;
}

}  // namespace dupin
