#include <algorithm>
#include <array>
#include <functional>

#include "dupin/blends/tessellate.h"
#include "tessellation/convex_fill.h"

namespace dupin {
namespace {

bool precedes(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

TriMesh end_cap_mesh(const Ring& ring, const RingSampling& sampling) {
  TriMesh mesh{sample(ring, sampling), {}, {}, {}};
  const std::uint32_t n = sampling.segments;
  // The polygon of flipped(ring) runs the other way from the same first corner. Both sides halve in
  // the direction whose second corner precedes its last.
  tessellation::fill(0, n - 1, mesh.triangles);
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
