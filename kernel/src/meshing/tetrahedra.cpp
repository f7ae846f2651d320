#include "meshing/tetrahedra.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace dupin::meshing {

bool is_positive(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const auto point = [](const Vec3& p) { return Point(p.x(), p.y(), p.z()); };
  return CGAL::orientation(point(a), point(b), point(c), point(d)) == CGAL::POSITIVE;
}

}  // namespace dupin::meshing
