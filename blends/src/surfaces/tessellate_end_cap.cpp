#include <utility>

#include "dupin/blends/tessellate.h"
#include "numbers/point_order.h"
#include "tessellation/convex_fill.h"

namespace dupin {

TriMesh end_cap_mesh(const Ring& ring, const RingSampling& sampling) {
  TriMesh mesh{sample(ring, sampling), {}, {}, {}};
  const std::uint32_t n = sampling.segments;
  // The polygon of flipped(ring) runs the other way from the same first corner. Both sides halve in
  // the direction whose second corner precedes its last.
  tessellation::fill(0, n - 1, mesh.triangles);
  const numbers::PointOrder precedes;
  if (!precedes(mesh.points[1], mesh.points[n - 1])) {
    for (auto& triangle : mesh.triangles) {
      for (auto& corner : triangle) {
        corner = (n - corner) % n;
      }
      std::swap(triangle[1], triangle[2]);
    }
  }
  return mesh;
}

}  // namespace dupin
