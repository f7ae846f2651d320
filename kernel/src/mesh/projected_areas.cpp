#include "mesh/projected_areas.h"

#include <cstddef>

#include "exact/exact_numbers.h"

namespace dupin::mesh {

std::array<mpq_class, 3> projected_areas(const MeshView& mesh) {
  std::array<mpq_class, 3> sum;
  for (const Triangle& t : mesh.triangles) {
    std::array<std::array<mpq_class, 3>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const ExactPoint point = mesh.exact(t[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        p[i][k] = exact::rational(point[k]) / exact::rational(point[3]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      const mpq_class area =
          (p[1][u] - p[0][u]) * (p[2][v] - p[0][v]) - (p[1][v] - p[0][v]) * (p[2][u] - p[0][u]);
      sum[k] += abs(area);
    }
  }
  return sum;
}

}  // namespace dupin::mesh
