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

// Patches in rows along, which close around: each row is a surface.
class PatchRows {
 public:
  explicit PatchRows(const std::vector<BiquadraticPatch>& patches) : patches_(patches) {
    const Vec3 first = place(point(0, 0, 0));
    size_ = first.norm() + (first - place(point(0, 0, 2))).norm();
  }

  std::vector<NurbsSurface> surfaces() const {
    std::vector<NurbsSurface> result;
    for (std::size_t begin = 0; begin < patches_.size();) {
      // Up to where a column ends in the row's first.
      std::size_t end = begin + 1;
      while (end < patches_.size() && !is_same(point(end - 1, 0, 2), point(begin, 0, 0))) {
        ++end;
      }
      result.push_back(row(begin, end));
      begin = end;
    }
    return result;
  }

 private:
  static constexpr double kSame = 1e-9;

  [[nodiscard]] Point point(std::size_t patch, std::size_t i, std::size_t j) const {
    const Vec3& p = patches_[patch].points.at(i).at(j);
    return {p.x(), p.y(), p.z(), patches_[patch].weights.at(i).at(j)};
  }

  [[nodiscard]] bool is_same(const Point& a, const Point& b) const {
    return (place(a) - place(b)).norm() < kSame * size_;
  }

  void require(const Point& a, const Point& b) const {
    if (!is_same(a, b) || std::abs(a[3] / b[3] - 1) > kSame) {
      throw Error(Errc::boolean_failed,
                  "the patches of its surface make no net, which STEP asks for");
    }
  }

  [[nodiscard]] NurbsSurface row(std::size_t begin, std::size_t end) const {
    const std::size_t columns = end - begin;
    std::vector<std::vector<Point>> net(3, std::vector<Point>(2 * columns + 1));
    for (std::size_t c = 0; c < columns; ++c) {
      add(begin + c, c, net);
    }
    // The last column is the first one again, up to a factor.
    const double factor = net.front().back()[3] / net.front().front()[3];
    for (auto& points : net) {
      Point closing = points.front();
      std::ranges::for_each(closing, [&](double& x) { x *= factor; });
      require(closing, points.back());
      points.back() = closing;
    }
    return {2, 2, knots_of(1), knots_of(columns), std::move(net)};
  }

  // Points of the patch times f p^i are the same surface by another parameter along: such that the
  // last one's border is met as it is.
  void add(std::size_t patch, std::size_t column, std::vector<std::vector<Point>>& net) const {
    const auto ratio = [&](std::size_t i) { return net[i][2 * column][3] / point(patch, i, 0)[3]; };
    const double f = column > 0 ? ratio(0) : 1;
    const double p = column > 0 ? std::sqrt(ratio(2) / f) : 1;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        Point here = point(patch, i, j);
        std::ranges::for_each(here, [&](double& x) { x *= f * std::pow(p, double(i)); });
        if (j == 0 && column > 0) {
          require(net[i][2 * column], here);
        } else {
          net[i][2 * column + j] = here;
        }
      }
    }
  }

  const std::vector<BiquadraticPatch>& patches_;
  double size_ = 1;
};

struct SurfaceOf {
  double tolerance;
  SurfaceCount& count;

  std::vector<PieceSurface> operator()(const RingedSurface& tube) const {
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

  std::vector<PieceSurface> operator()(const RationalRingedTube& tube) const {
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

  std::vector<PieceSurface> operator()(const EllipticTube& tube) const { return other(tube); }

  std::vector<PieceSurface> operator()(const CyclidePiece& piece) const {
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
    const std::vector<BiquadraticPatch> all = patches(arc);
    std::vector<PieceSurface> result;
    for (NurbsSurface& row : PatchRows(all).surfaces()) {
      result.emplace_back(std::move(row));
      ++count.exact;
    }
    return result;
  }

 private:
  template <class Surface>
  std::vector<PieceSurface> exact(Surface surface) const {
    ++count.exact;
    return {PieceSurface(std::move(surface))};
  }

  // The way that the piece travels, which leaves along the start's normal turned back.
  static TorusArc torus(const CyclidePiece& piece, const CanonicalCyclide& form) {
    const Vec3 from = piece.start.center - form.origin, to = piece.end.center - form.origin;
    const Vec3 axis = from.cross(Vec3(-piece.start.normal)).normalized();
    const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
    return {form.origin, axis, angle > 0 ? angle : angle + 2 * std::numbers::pi};
  }

  std::vector<PieceSurface> other(const Piece& piece) const {
    NurbsForm form = nurbs(Chain(piece), tolerance);
    ++(form.error_bound == 0 ? count.exact : count.lofted);
    count.error = std::max(count.error, form.error_bound);
    return {PieceSurface(std::move(form.surfaces.at(0)))};
  }
};

}  // namespace

RingCurve end_circle(const NurbsSurface& surface) {
  const Vec3 a = evaluate(surface, 1, 0), b = evaluate(surface, 1, 1. / 3) - a,
             c = evaluate(surface, 1, 2. / 3) - a;
  const Vec3 normal = b.cross(c);
  const Vec3 to_center = (b.squaredNorm() * c.cross(normal) - c.squaredNorm() * b.cross(normal)) /
                         (2 * normal.squaredNorm());
  return {a + to_center, normal.normalized(), -to_center.normalized(), to_center.norm(),
          to_center.norm()};
}

RingCurve ring_curve(const Ring& ring) {
  return {ring.center, ring.normal, reference_axis(ring), ring.radius, across(ring)};
}

std::vector<PieceSurface> piece_surfaces(const Piece& piece, double tolerance,
                                         SurfaceCount& count) {
  return std::visit(SurfaceOf{tolerance, count}, piece);
}

}  // namespace dupin::exchange
