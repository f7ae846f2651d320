#include "exchange/part_faces.h"

#include <algorithm>
#include <cmath>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/nurbs.h"
#include "dupin/kernel/error.h"

namespace dupin::exchange {
namespace {

// Of what is the same but for rounding.
constexpr double kRounding = 1e-9;

bool is_right(const Ring& start, const Ring& end) {
  const Vec3 axis = (end.center - start.center).normalized();
  return !start.ellipse && !end.ellipse && (axis - end.normal).norm() < kRounding &&
         (axis + start.normal).norm() < kRounding;
}

// The surface as it is in the piece's list of patches: rows along, each of columns around.
NurbsSurface joined(const std::vector<BiquadraticPatch>& patches) {
  using Point = std::array<double, 4>;
  const auto point = [](const BiquadraticPatch& patch, std::size_t i, std::size_t j) {
    const Vec3& p = patch.points.at(i).at(j);
    return Point{p.x(), p.y(), p.z(), patch.weights.at(i).at(j)};
  };
  const auto place = [](const Point& p) { return Vec3(p[0] / p[3], p[1] / p[3], p[2] / p[3]); };
  const double size = place(point(patches.front(), 0, 0)).norm() +
                      (place(point(patches.front(), 0, 0)) - place(point(patches.front(), 0, 2))).norm();
  const auto same = [&](const Point& a, const Point& b) {
    return (place(a) - place(b)).norm() < 1e-7 * size;
  };
  // A row closes where a column ends in the row's first.
  std::size_t columns = 1;
  while (columns < patches.size() &&
         !same(point(patches[columns - 1], 0, 2), point(patches.front(), 0, 0))) {
    ++columns;
  }
  if (patches.size() % columns != 0) {
    throw Error(Errc::boolean_failed, "its patches make no rows");
  }
  const std::size_t rows = patches.size() / columns;
  NurbsSurface result{2, 2, {}, {}, {}};
  const auto knots = [](std::size_t pieces) {
    std::vector<double> all{0};
    for (std::size_t i = 0; i <= pieces; ++i) {
      all.insert(all.end(), 2, double(i) / double(pieces));
    }
    all.push_back(1);
    return all;
  };
  result.knots_along = knots(rows);
  result.knots_around = knots(columns);
  result.net.assign(2 * rows + 1, std::vector<Point>(2 * columns + 1));
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const BiquadraticPatch& patch = patches[r * columns + c];
      // Homogeneous points are those of the neighbours up to a factor.
      const Point first = point(patch, 0, 0);
      const double factor = c > 0   ? result.net[2 * r][2 * c][3] / first[3]
                            : r > 0 ? result.net[2 * r][0][3] / first[3]
                                    : 1;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          Point own = point(patch, i, j);
          std::ranges::for_each(own, [&](double& x) { x *= factor; });
          Point& at = result.net[2 * r + i][2 * c + j];
          const bool is_known = (i == 0 && r > 0) || (j == 0 && c > 0);
          if (is_known && (!same(at, own) || std::abs(at[3] / own[3] - 1) > 1e-7)) {
            throw Error(Errc::boolean_failed, "its patches have parameters of their own");
          }
          at = is_known ? at : own;
        }
      }
    }
  }
  for (auto& row : result.net) {
    row.back() = row.front();
  }
  return result;
}

struct SurfaceOf {
  double tolerance;
  SurfaceCount& count;

  PieceSurface operator()(const RingedSurface& tube) const {
    if (std::holds_alternative<LineSpine>(tube.spine) && is_linear(tube.radius) &&
        is_right(tube.start, tube.end)) {
      return exact(CylinderOrCone{});
    }
    const auto* arc = std::get_if<ArcSpine>(&tube.spine);
    if (arc != nullptr && std::holds_alternative<ConstantRadius>(tube.radius)) {
      return exact(TorusArc{arc->center, arc->axis, arc->angle});
    }
    return other(tube);
  }

  PieceSurface operator()(const RationalRingedTube& tube) const {
    const bool is_straight =
        tube.surface.rotation.size() == 2 && tube.surface.rotation[0] == tube.surface.rotation[1];
    const auto steps_evenly = [](const auto& points, const auto& size) {
      return size(points[0] + points[2] - 2 * points[1]) < kRounding &&
             size(points[1] + points[3] - 2 * points[2]) < kRounding;
    };
    if (is_straight && is_right(tube.start, tube.end) &&
        steps_evenly(tube.surface.radius, [](double x) { return std::abs(x); })) {
      return exact(CylinderOrCone{});
    }
    return other(tube);
  }

  PieceSurface operator()(const EllipticTube& tube) const { return other(tube); }

  PieceSurface operator()(const CyclidePiece& piece) const {
    const PeArc arc = arc_of(piece);
    const CanonicalCyclide form = canonical_form(arc);
    if ((form.kind == CyclideKind::cylinder || form.kind == CyclideKind::cone) &&
        is_right(piece.start, piece.end)) {
      return exact(CylinderOrCone{});
    }
    const double radius = piece.start.radius;
    if (form.kind == CyclideKind::torus && std::abs(piece.end.radius - radius) < kRounding * radius &&
        std::abs(piece.start.slope) < kRounding) {
      return exact(torus(piece, form));
    }
    NurbsSurface surface = joined(patches(arc));
    return exact(std::move(surface));
  }

 private:
  template <class Surface>
  PieceSurface exact(Surface surface) const {
    ++count.exact;
    return surface;
  }

  // The way that the piece travels, which leaves along the start's normal turned back.
  static TorusArc torus(const CyclidePiece& piece, const CanonicalCyclide& form) {
    const Vec3 from = piece.start.center - form.origin, to = piece.end.center - form.origin;
    const Vec3 axis = from.cross(Vec3(-piece.start.normal)).normalized();
    const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
    return {form.origin, axis, angle > 0 ? angle : angle + 2 * 3.14159265358979323846};
  }

  PieceSurface other(const Piece& piece) const {
    NurbsForm form = nurbs(Chain(piece), tolerance);
    ++(form.error_bound == 0 ? count.exact : count.lofted);
    count.error = std::max(count.error, form.error_bound);
    return std::move(form.surfaces.at(0));
  }
};

}  // namespace

RingCurve ring_curve(const Ring& ring) {
  return {ring.center, ring.normal, reference_axis(ring), ring.radius, across(ring)};
}

PieceSurface piece_surface(const Piece& piece, double tolerance, SurfaceCount& count) {
  return std::visit(SurfaceOf{tolerance, count}, piece);
}

}  // namespace dupin::exchange
