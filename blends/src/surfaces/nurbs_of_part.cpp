#include <algorithm>
#include <cmath>

#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/nurbs.h"
#include "surfaces/nurbs_rows.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin {
namespace {

// Half a turn of half a circle, twice.
NurbsSurface sphere_form(const Sphere& sphere) {
  NurbsSurface result{2, 2, surfaces::bezier_knots(2, 2), surfaces::bezier_knots(2, 4), {}};
  const double root = std::sqrt(0.5), r = sphere.radius;
  const double heights[] = {-1, -1, 0, 1, 1}, radii[] = {0, 1, 1, 1, 0};
  for (std::size_t i = 0; i < 5; ++i) {
    const double weight = i % 2 == 0 ? 1 : root;
    result.net.push_back(surfaces::row_points(
        {weight * (sphere.center + r * heights[i] * Vec3::UnitZ()),
         weight * radii[i] * r * Vec3::UnitX(), weight * radii[i] * r * Vec3::UnitY(), weight}));
  }
  return result;
}

void append(const Chain& chain, double tolerance, NurbsForm& form) {
  for (const Piece& piece : chain.pieces) {
    const NurbsForm own =
        std::visit([=](const auto& p) { return surfaces::nurbs(p, tolerance); }, piece);
    form.surfaces.insert(form.surfaces.end(), own.surfaces.begin(), own.surfaces.end());
    form.error_bound = std::max(form.error_bound, own.error_bound);
  }
}

struct Form {
  double tolerance;

  NurbsForm operator()(const Chain& chain) const {
    NurbsForm result;
    append(chain, tolerance, result);
    if (chain.wall > 0) {
      append(inner_skin(chain), tolerance, result);
    }
    if (chain.joints == Joints::spherical) {
      const auto arcs = cyclide_pieces(chain);
      for (std::size_t i = 1; i < arcs.size(); ++i) {
        const auto& [center, radius] = arcs[i].start();
        result.surfaces.push_back(sphere_form({center, radius}));
      }
    }
    return result;
  }

  NurbsForm operator()(const Sphere& sphere) const { return {{sphere_form(sphere)}, 0}; }
};

}  // namespace

NurbsForm nurbs(const PartSurface& surface, double tolerance) {
  surfaces::require_nurbs_tolerance(tolerance);
  return std::visit(Form{tolerance}, surface);
}

}  // namespace dupin
