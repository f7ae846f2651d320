#include "exchange/part_faces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

using Point = std::array<double, 4>;

Vec3 place(const Point& p) { return Vec3(p[0] / p[3], p[1] / p[3], p[2] / p[3]); }

std::vector<double> knots_of(std::size_t pieces) {
  std::vector<double> all{0};
  for (std::size_t i = 0; i <= pieces; ++i) {
    all.insert(all.end(), 2, double(i) / double(pieces));
  }
  all.push_back(1);
  return all;
}

// A net of patches that lie beside each other in rows along, each of columns around.
class PatchNet {
 public:
  explicit PatchNet(const std::vector<BiquadraticPatch>& patches) : patches_(patches) {
    const Vec3 first = place(point(0, 0, 0));
    size_ = first.norm() + (first - place(point(0, 0, 2))).norm();
    // A row closes where a column ends in the row's first.
    while (columns_ < patches.size() && !is_same(point(columns_ - 1, 0, 2), point(0, 0, 0))) {
      ++columns_;
    }
    if (patches.size() % columns_ != 0) {
      refuse();
    }
    rows_ = patches.size() / columns_;
  }

  NurbsSurface joined() {
    net_.assign(2 * rows_ + 1, std::vector<Point>(2 * columns_ + 1));
    for (std::size_t r = 0; r < rows_; ++r) {
      for (std::size_t c = 0; c < columns_; ++c) {
        add(r, c);
      }
    }
    // The last column is the first one again, up to a factor.
    for (auto& row : net_) {
      const double factor = row.back()[3] / row.front()[3];
      require(row.front(), row.back(), net_.front().back()[3] / net_.front().front()[3]);
      for (std::size_t k = 0; k < 4; ++k) {
        row.back().at(k) = factor * row.front().at(k);
      }
    }
    return {2, 2, knots_of(rows_), knots_of(columns_), std::move(net_)};
  }

 private:
  static constexpr double kSame = 1e-9;

  [[noreturn]] static void refuse() {
    throw Error(Errc::boolean_failed,
                "the patches of its surface make no net, which STEP asks for");
  }

  [[nodiscard]] Point point(std::size_t patch, std::size_t i, std::size_t j) const {
    const Vec3& p = patches_[patch].points.at(i).at(j);
    return {p.x(), p.y(), p.z(), patches_[patch].weights.at(i).at(j)};
  }

  [[nodiscard]] bool is_same(const Point& a, const Point& b) const {
    return (place(a) - place(b)).norm() < kSame * size_;
  }

  void require(const Point& a, const Point& b, double factor) const {
    if (!is_same(a, b) || std::abs(factor * a[3] / b[3] - 1) > kSame) {
      refuse();
    }
  }

  // Points of the patch times f p^i q^j are the same surface by other parameters: such that the
  // neighbours' borders are met as they are.
  void add(std::size_t r, std::size_t c) {
    std::array<std::array<Point, 3>, 3> own;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        own.at(i).at(j) = point(r * columns_ + c, i, j);
      }
    }
    const auto known = [&](std::size_t i, std::size_t j) -> Point& {
      return net_[2 * r + i][2 * c + j];
    };
    const auto ratio = [&](std::size_t i, std::size_t j) {
      return known(i, j)[3] / own.at(i).at(j)[3];
    };
    const double f = r > 0 || c > 0 ? ratio(0, 0) : 1;
    const double p = c > 0 ? std::sqrt(ratio(2, 0) / f) : 1;
    const double q = r > 0 ? std::sqrt(ratio(0, 2) / f) : 1;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        Point& here = own.at(i).at(j);
        const double factor = f * std::pow(p, double(i)) * std::pow(q, double(j));
        std::ranges::for_each(here, [&](double& x) { x *= factor; });
        if ((i == 0 && r > 0) || (j == 0 && c > 0)) {
          require(known(i, j), here, 1);
        } else {
          known(i, j) = here;
        }
      }
    }
  }

  const std::vector<BiquadraticPatch>& patches_;
  double size_ = 1;
  std::size_t rows_ = 1, columns_ = 1;
  std::vector<std::vector<Point>> net_;
};

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
    const double rounding = kRounding * tube.start.radius;
    const auto steps_evenly = [&](const auto& points, const auto& size) {
      return size(points[0] + points[2] - 2 * points[1]) < rounding &&
             size(points[1] + points[3] - 2 * points[2]) < rounding;
    };
    if (is_straight && is_right(tube.start, tube.end) &&
        steps_evenly(tube.surface.radius, [](double x) { return std::abs(x); }) &&
        steps_evenly(tube.surface.center, [](const Vec3& x) { return x.norm(); })) {
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
    if (form.kind == CyclideKind::torus &&
        std::abs(piece.end.radius - radius) < kRounding * radius &&
        std::abs(piece.start.slope) < kRounding) {
      return exact(torus(piece, form));
    }
    return exact(PatchNet(patches(arc)).joined());
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
    return {form.origin, axis, angle > 0 ? angle : angle + 2 * std::numbers::pi};
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
