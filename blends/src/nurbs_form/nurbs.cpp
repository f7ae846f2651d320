#include "dupin/blends/nurbs.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/cyclide_form.h"
#include "numbers/bezier.h"
#include "nurbs_form/nurbs_rows.h"

namespace dupin {
namespace {

using nurbs_form::NurbsRow;

constexpr double kPi = std::numbers::pi;

// The Bernstein coefficients of the same polynomial with one more of them.
template <class T>
std::vector<T> elevated(const std::vector<T>& c) {
  const std::size_t n = c.size();
  std::vector<T> result{c.front()};
  for (std::size_t i = 1; i < n; ++i) {
    const double share = double(i) / double(n);
    result.push_back(share * c[i - 1] + (1 - share) * c[i]);
  }
  result.push_back(c.back());
  return result;
}

// None for R2, which is no polynomial.
std::vector<double> bernstein(const RadiusLaw& law) {
  struct Coefficients {
    std::vector<double> operator()(const ConstantRadius& r) const { return {r.radius}; }
    std::vector<double> operator()(const LinearRadius& r) const { return {r.start, r.end}; }
    std::vector<double> operator()(const CubicRadius& r) const {
      return {r.start, r.start, r.end, r.end};
    }
    std::vector<double> operator()(const CyclideRadius&) const { return {}; }
    std::vector<double> operator()(const BezierRadius& r) const { return r.coefficients; }
  };
  return std::visit(Coefficients(), law);
}

// The control points of a straight spine; none for others.
std::vector<Vec3> straight(const Spine& spine) {
  std::vector<Vec3> points;
  if (const auto* line = std::get_if<LineSpine>(&spine)) {
    points = {line->from, line->to};
  } else if (const auto* cubic = std::get_if<HermiteSpine>(&spine)) {
    points = {cubic->from, cubic->from + cubic->start_velocity / 3,
              cubic->to - cubic->end_velocity / 3, cubic->to};
  } else if (const auto* bezier = std::get_if<BezierSpine>(&spine);
             bezier != nullptr && bezier->weights.empty()) {
    points = bezier->points;
  }
  for (const Vec3& point : points) {
    const Vec3 chord = points.back() - points.front();
    if (!chord.cross(point - points.front()).isZero(0)) {
      return {};
    }
  }
  return points;
}

// A section of a part where it begins: its semi-axes as vectors.
struct Section {
  Vec3 first, second;  ///< unit
};

std::vector<NurbsRow> straight_rows(std::vector<Vec3> spine, std::vector<double> first,
                                    std::vector<double> second, const Section& section) {
  const std::size_t size = std::max({spine.size(), first.size(), second.size()});
  while (spine.size() < size) {
    spine = elevated(spine);
  }
  for (auto* law : {&first, &second}) {
    while (law->size() < size) {
      *law = elevated(*law);
    }
  }
  std::vector<NurbsRow> rows;
  for (std::size_t i = 0; i < size; ++i) {
    rows.push_back({spine[i], first[i] * section.first, second[i] * section.second, 1});
  }
  return rows;
}

// The circle through a row turned about the arc's axis, in pieces of about a right angle or less:
// the middle row of a piece is w = cos(half) times the axis' foot and the rest turned by half.
std::vector<NurbsRow> turned_rows(const ArcSpine& arc, const NurbsRow& start) {
  constexpr double kLargest = 1.6;  // a little more, so that quarter turns are one piece
  const int pieces = int(std::ceil(arc.angle / kLargest));
  const double half = arc.angle / pieces / 2;
  std::vector<NurbsRow> rows;
  for (int i = 0; i <= 2 * pieces; ++i) {
    const Eigen::AngleAxisd turn(half * i, arc.axis);
    const double weight = i % 2 == 0 ? 1 : std::cos(half);
    const auto turned = [&](const Vec3& v) {
      const Vec3 along = v.dot(arc.axis) * arc.axis;
      return Vec3(weight * along + turn * Vec3(v - along));
    };
    rows.push_back({weight * arc.center + turned(start.center - arc.center), turned(start.a),
                    turned(start.b), weight});
  }
  return rows;
}

Section section_of(const Spine& spine, const Vec3& axis) {
  const Vec3 tangent = evaluate(spine, 0).first.normalized();
  const Vec3 first = (axis - axis.dot(tangent) * tangent).normalized();
  return {first, tangent.cross(first)};
}

// The exact rows with their degree; none where there is no exact form.
struct ExactRows {
  std::vector<NurbsRow> rows;
  int degree = 1;
};

ExactRows exact_rows(const Spine& spine, const RadiusLaw& first, const RadiusLaw& second,
                     const Vec3& axis) {
  const auto a = bernstein(first), b = bernstein(second);
  if (a.empty() || b.empty()) {
    return {};
  }
  const Section section = section_of(spine, axis);
  if (const auto* arc = std::get_if<ArcSpine>(&spine)) {
    if (a.size() > 1 || b.size() > 1) {
      return {};
    }
    return {turned_rows(*arc, {arc->start, a[0] * section.first, b[0] * section.second, 1}), 2};
  }
  const auto points = straight(spine);
  if (points.empty()) {
    return {};
  }
  auto rows = straight_rows(points, a, b, section);
  const int degree = int(rows.size()) - 1;
  return {std::move(rows), degree};
}

class Exact {
 public:
  explicit Exact(double tolerance) : tolerance_(tolerance) {}

  NurbsForm operator()(const RingedSurface& surface) const {
    const auto [rows, degree] =
        exact_rows(surface.spine, surface.radius, surface.radius, reference_axis(surface.start));
    return rows.empty() ? nurbs_form::lofted_nurbs(surface, tolerance_)
                        : NurbsForm{{nurbs_form::nurbs_through(rows, degree)}, 0};
  }

  NurbsForm operator()(const EllipticTube& tube) const {
    if (tube.turn == 0) {
      const auto [rows, degree] = exact_rows(tube.spine, tube.first, tube.second, tube.axis);
      if (!rows.empty()) {
        return {{nurbs_form::nurbs_through(rows, degree)}, 0};
      }
    }
    return nurbs_form::lofted_nurbs(tube, tolerance_);
  }

  // A quarter at a time, in the order of the columns.
  NurbsForm operator()(const RationalRingedTube& tube) const {
    NurbsSurface result;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const RationalPatch patch =
          rational_patch(tube.surface, quarter * kPi / 2, (quarter + 1) * kPi / 2);
      result.net.resize(patch.net.size());
      for (std::size_t i = 0; i < patch.net.size(); ++i) {
        auto& row = result.net[i];
        row.insert(row.end(), patch.net[i].begin() + (quarter > 0 ? 1 : 0), patch.net[i].end());
      }
    }
    result.degree_along = int(result.net.size()) - 1;
    result.knots_along = nurbs_form::bezier_knots(result.degree_along, 1);
    result.knots_around = nurbs_form::bezier_knots(2, 4);
    return {{result}, 0};
  }

  NurbsForm operator()(const SplinePipe& pipe) const {
    NurbsForm result;
    for (const RingedSurface& piece : pipe.pieces) {
      NurbsForm form = (*this)(piece);
      result.surfaces.insert(result.surfaces.end(), form.surfaces.begin(), form.surfaces.end());
      result.error_bound = std::max(result.error_bound, form.error_bound);
    }
    return result;
  }

  NurbsForm operator()(const CyclideTube& tube) const {
    NurbsForm result;
    append(tube.chain.pieces, result);
    if (tube.wall > 0) {
      append(inner_tube(tube).chain.pieces, result);
    }
    return result;
  }

  NurbsForm operator()(const KneecapChain& chain) const {
    NurbsForm result;
    append(chain.pieces, result);
    for (std::size_t i = 1; i < chain.pieces.size(); ++i) {
      const auto& [center, radius] = chain.pieces[i].start();
      result.surfaces.push_back((*this)(Sphere{center, radius}).surfaces.front());
    }
    return result;
  }

  // Half a turn of half a circle, twice.
  NurbsForm operator()(const Sphere& sphere) const {
    NurbsSurface result{2, 2, nurbs_form::bezier_knots(2, 2), nurbs_form::bezier_knots(2, 4), {}};
    const double root = std::sqrt(0.5), r = sphere.radius;
    const double heights[] = {-1, -1, 0, 1, 1}, radii[] = {0, 1, 1, 1, 0};
    for (std::size_t i = 0; i < 5; ++i) {
      const double weight = i % 2 == 0 ? 1 : root;
      result.net.push_back(nurbs_form::row_points(
          {weight * (sphere.center + r * heights[i] * Vec3::UnitZ()),
           weight * radii[i] * r * Vec3::UnitX(), weight * radii[i] * r * Vec3::UnitY(), weight}));
    }
    return {{result}, 0};
  }

 private:
  static void append(const std::vector<PeArc>& pieces, NurbsForm& form) {
    for (const PeArc& arc : pieces) {
      for (const BiquadraticPatch& patch : patches(arc)) {
        NurbsSurface surface{
            2, 2, nurbs_form::bezier_knots(2, 1), nurbs_form::bezier_knots(2, 1), {}};
        for (std::size_t i = 0; i < 3; ++i) {
          auto& row = surface.net.emplace_back();
          for (std::size_t j = 0; j < 3; ++j) {
            const Vec3& p = patch.points.at(i).at(j);
            row.push_back({p.x(), p.y(), p.z(), patch.weights.at(i).at(j)});
          }
        }
        form.surfaces.push_back(std::move(surface));
      }
    }
  }

  double tolerance_;
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
  return std::visit(Exact(tolerance), surface);
}

}  // namespace dupin
