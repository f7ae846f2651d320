#include <cmath>

#include <Eigen/Geometry>

#include "cyclide/complementary_sphere.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/kernel/error.h"

namespace dupin {

std::array<BoundingCircle, 2> bounding_circles(const PeArc& arc) {
  const ArcFrame axes = frame(arc);
  std::array<BoundingCircle, 2> result;
  for (std::size_t i = 0; i < 2; ++i) {
    const cyclide::ComplementarySphere q =
        cyclide::complementary_sphere(arc, axes, 1, i == 0 ? 1 : -1, 0);
    if (q.weight == 0) {
      throw Error(Errc::invalid_argument, "one of the piece's bounding circles is a line");
    }
    result.at(i) = {q.center / q.weight, q.radius / q.weight};
  }
  return result;
}

// The circles have the centres (+-c, 0, 0) and radii mu +- a in the plane z = 0, or (+-a, 0, 0) and
// mu +- c in the plane y = 0; x leads to the one of smaller signed radius.
CanonicalCyclide canonical_form(const BoundingCircle& one, const BoundingCircle& other,
                                const Vec3& plane_normal) {
  const bool is_one_smaller = one.radius < other.radius;
  const Vec3 across = is_one_smaller ? one.center - other.center : other.center - one.center;
  const double centres = across.norm() / 2, radii = std::abs(one.radius - other.radius) / 2;
  if (!(centres > 0 || radii > 0)) {
    throw Error(Errc::invalid_argument, "equal bounding circles belong to no cyclide");
  }
  CanonicalCyclide form;
  const bool is_elliptic = radii > centres;
  form.a = std::max(centres, radii);
  form.c = std::min(centres, radii);
  form.b = std::sqrt((form.a - form.c) * (form.a + form.c));
  form.mu = (one.radius + other.radius) / 2;
  form.origin = (one.center + other.center) / 2;
  form.x = centres > 0 ? Vec3(across / (2 * centres)) : plane_normal.unitOrthogonal();
  const Vec3 second = plane_normal.cross(form.x);
  form.kind = form.c == 0   ? CyclideKind::torus
              : is_elliptic ? CyclideKind::elliptic
                            : CyclideKind::hyperbolic;
  form.y = is_elliptic ? second : plane_normal;
  form.z = is_elliptic ? plane_normal : Vec3(-second);
  return form;
}

}  // namespace dupin
