#include "dupin/blends/nurbs.h"

#include <algorithm>
#include <cmath>

#include "dupin/blends/cyclide_tube.h"
#include "surfaces/nurbs_rows.h"
#include "surfaces/surface_piece.h"

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

// The span of a knot vector that holds t, and de Boor's points of it.
template <class Value>
Value de_boor(const std::vector<Value>& points, const std::vector<double>& knots, int degree,
              double t) {
  std::size_t span = std::size_t(degree);
  while (span + 1 < points.size() && knots[span + 1] <= t) {
    ++span;
  }
  std::vector<Value> d(points.begin() + std::ptrdiff_t(span) - degree,
                       points.begin() + std::ptrdiff_t(span) + 1);
  for (int r = 1; r <= degree; ++r) {
    for (int j = degree; j >= r; --j) {
      const std::size_t i = span - std::size_t(degree) + std::size_t(j);
      const double low = knots[i], high = knots[i + 1 + std::size_t(degree - r)];
      const double share = (t - low) / (high - low);
      d[std::size_t(j)] = (1 - share) * d[std::size_t(j) - 1] + share * d[std::size_t(j)];
    }
  }
  return d.back();
}

}  // namespace

Vec3 evaluate(const NurbsSurface& surface, double along, double around) {
  std::vector<Eigen::Array4d> column;
  for (const auto& row : surface.net) {
    std::vector<Eigen::Array4d> points;
    points.reserve(row.size());
    for (const auto& p : row) {
      points.emplace_back(p[0], p[1], p[2], p[3]);
    }
    column.push_back(de_boor(points, surface.knots_around, surface.degree_around, around));
  }
  const Eigen::Array4d point = de_boor(column, surface.knots_along, surface.degree_along, along);
  return Vec3(point[0], point[1], point[2]) / point[3];
}

NurbsForm nurbs(const PartSurface& surface, double tolerance) {
  return std::visit(Form{tolerance}, surface);
}

}  // namespace dupin
