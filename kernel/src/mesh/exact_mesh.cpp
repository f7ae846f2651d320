#include "mesh/exact_mesh.h"

#include "exact/exact_numbers.h"

namespace dupin::mesh {

double nearest_double(const CGAL::Mpzf& numerator, const CGAL::Mpzf& denominator) {
  const mpq_class n = exact::rational(numerator), d = exact::rational(denominator);
  return exact::nearest_double(mpz_class(n.get_num() * d.get_den()),
                               mpz_class(n.get_den() * d.get_num()));
}

ExactPoint exact_point(const ExactMesh& mesh, std::uint32_t index) {
  return MeshView(mesh).exact(index);
}

}  // namespace dupin::mesh
