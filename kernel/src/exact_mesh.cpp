#include "exact_mesh.h"

#include "exact.h"
#include "mesh_view.h"

namespace dupin::detail {

double nearest_double(const CGAL::Mpzf& numerator, const CGAL::Mpzf& denominator) {
  const mpq_class n = rational(numerator), d = rational(denominator);
  return nearest_double(mpz_class(n.get_num() * d.get_den()), mpz_class(n.get_den() * d.get_num()));
}

ExactPoint exact_point(const ExactMesh& mesh, std::uint32_t index) {
  return MeshView(mesh).exact(index);
}

}  // namespace dupin::detail
