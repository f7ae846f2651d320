#include "tessellation/kneecap_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace dupin::tessellation {
namespace {

using std::numbers::pi;
using Indices = std::vector<std::uint32_t>;

// How far a triangle inscribed in a sphere is from it: the nearest point to the centre is the foot
// of its plane, on the circumscribed circle's axis, or the middle of the edge opposite an obtuse
// angle.
double sagitta(double sphere_radius, const Vec3& a, const Vec3& b, const Vec3& c) {
  std::array<double, 3> squares{(b - c).squaredNorm(), (c - a).squaredNorm(),
                                (a - b).squaredNorm()};
  std::sort(squares.begin(), squares.end());
  const auto [s, m, l] = squares;
  double radius2 = l / 4;
  if (l < s + m) {
    const double area = (b - a).cross(c - a).norm();
    radius2 = s * m * l / (4 * area * area);
  }
  const double foot2 = sphere_radius * sphere_radius - radius2;
  return foot2 > 0 ? sphere_radius - std::sqrt(foot2) : sphere_radius;
}

// The oriented planes of the contact circles as functions f = (x - m).n - h that vanish there; the
// kneecap is where the first is positive and the second negative, and each of its points lies on
// one circle of the pencil (1 - s) f1 + s f2 = 0, 0 <= s <= 1.
class Pencil {
 public:
  explicit Pencil(const JointCircles& joint)
      : joint_(joint),
        h1_((joint.before.center - joint.sphere.m).dot(joint.before.normal)),
        h2_((joint.after.center - joint.sphere.m).dot(joint.after.normal)) {}

  // The angle of the kneecap in its plane of symmetry.
  [[nodiscard]] double width() const {
    const Vec3 from = middle_of(joint_.before), to = middle_of(joint_.after);
    const double angle = std::atan2(joint_.before.normal.dot(to), outward_before().dot(to)) -
                         std::atan2(joint_.before.normal.dot(from), outward_before().dot(from));
    return angle > 0 ? angle : angle + 2 * pi;
  }

  // The circle through the point of the plane of symmetry that lies at a share of the width.
  [[nodiscard]] Ring circle(double share) const {
    const double angle = std::asin(std::clamp(h1_ / joint_.sphere.r, -1.0, 1.0)) + share * width();
    const Vec3 point = joint_.sphere.r * (std::cos(angle) * outward_before() +
                                          std::sin(angle) * joint_.before.normal);
    const double f1 = point.dot(joint_.before.normal) - h1_;
    const double f2 = point.dot(joint_.after.normal) - h2_;
    const double s = f1 / (f1 - f2);
    const Vec3 normal = (1 - s) * joint_.before.normal + s * joint_.after.normal;
    const double length = normal.norm();
    const double height = ((1 - s) * h1_ + s * h2_) / length;
    const double square = (joint_.sphere.r - height) * (joint_.sphere.r + height);
    return {joint_.sphere.m + height / length * normal, normal / length,
            std::sqrt(std::max(0.0, square))};
  }

 private:
  [[nodiscard]] Vec3 outward_before() const { return outward(joint_, joint_.before.normal); }

  [[nodiscard]] Vec3 middle_of(const Ring& circle) const {
    return circle.center + circle.radius * outward(joint_, circle.normal) - joint_.sphere.m;
  }

  const JointCircles& joint_;
  double h1_, h2_;
};

class Patch {
 public:
  Patch(TriMesh& mesh, const JointCircles& joint, const KneecapSampling& sampling)
      : mesh_(mesh), joint_(joint), sampling_(sampling), pencil_(joint) {}

  // With `rows` strips. Returns the largest sagitta.
  double append(const Indices& before, const Indices& after, std::uint32_t rows) {
    const std::size_t first = mesh_.triangles.size();
    Indices last = before;
    for (std::uint32_t k = 1; k < rows; ++k) {
      const Ring circle = pencil_.circle(double(k) / rows);
      Indices row = joint_.kind == JointKind::lune ? arc(circle, before.front(), before.back())
                                                   : loop(circle, before.size() - 1);
      stitch(last, row);
      last = std::move(row);
    }
    stitch(last, after);
    double largest = 0;
    for (std::size_t i = first; i < mesh_.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh_.triangles[i];
      largest = std::max(
          largest, sagitta(joint_.sphere.r, mesh_.points[a], mesh_.points[b], mesh_.points[c]));
    }
    return largest;
  }

 private:
  std::uint32_t add(const Ring& circle, const Vec3& first, double angle) {
    const Vec3 direction = std::cos(angle) * first + std::sin(angle) * circle.normal.cross(first);
    mesh_.points.push_back(snapped(circle.center + circle.radius * direction, sampling_.grid));
    return std::uint32_t(mesh_.points.size() - 1);
  }

  // From corner to corner in steps as long as those of the pieces.
  Indices arc(const Ring& circle, std::uint32_t from, std::uint32_t to) {
    const Vec3 first = (joint_.corners[0] - circle.center).normalized();
    const Vec3 out = outward(joint_, circle.normal);
    const double angle =
        2 * std::abs(std::atan2(circle.normal.dot(first.cross(out)), first.dot(out)));
    const double longest = std::max(joint_.before.radius, joint_.after.radius);
    const double wanted =
        std::ceil(sampling_.segments * angle / (2 * pi) * circle.radius / longest);
    const std::uint32_t steps = std::max(2U, std::uint32_t(wanted));
    Indices row{from};
    for (std::uint32_t i = 1; i < steps; ++i) {
      row.push_back(add(circle, first, angle * i / steps));
    }
    row.push_back(to);
    return row;
  }

  Indices loop(const Ring& circle, std::size_t steps) {
    const Vec3 first = band_start(joint_, circle.normal, steps);
    Indices row;
    for (std::size_t i = 0; i < steps; ++i) {
      row.push_back(add(circle, first, 2 * pi * double(i) / double(steps)));
    }
    row.push_back(row.front());
    return row;
  }

  // The strip between two rows, along the shorter diagonals.
  void stitch(const Indices& here, const Indices& next) {
    const auto squared = [&](std::uint32_t a, std::uint32_t b) {
      return (mesh_.points[a] - mesh_.points[b]).squaredNorm();
    };
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (a != b && b != c && c != a) {
        mesh_.triangles.push_back({a, b, c});
      }
    };
    std::size_t i = 0, j = 0;
    while (i + 1 < here.size() || j + 1 < next.size()) {
      const bool can_here = i + 1 < here.size(), can_next = j + 1 < next.size();
      const bool advance_here =
          can_here && (!can_next || squared(here[i + 1], next[j]) <= squared(here[i], next[j + 1]));
      if (advance_here) {
        triangle(here[i], here[i + 1], next[j]);
        ++i;
      } else {
        triangle(here[i], next[j + 1], next[j]);
        ++j;
      }
    }
  }

  TriMesh& mesh_;
  const JointCircles& joint_;
  const KneecapSampling& sampling_;
  Pencil pencil_;
};

// In steps as long as the segments of the larger circle.
double wanted_rows(const JointCircles& joint, std::uint32_t segments) {
  const double step = 2 * pi / segments * std::max(joint.before.radius, joint.after.radius);
  return std::ceil(Pencil(joint).width() * joint.sphere.r / step);
}

}  // namespace

double expected_rows(const JointCircles& joint, std::uint32_t segments) {
  return joint.kind == JointKind::lune || joint.kind == JointKind::band
             ? wanted_rows(joint, segments)
             : 0;
}

double append_kneecap(TriMesh& mesh, const JointCircles& joint,
                      std::span<const std::uint32_t> before, std::span<const std::uint32_t> after,
                      const KneecapSampling& sampling) {
  Indices from(before.begin(), before.end()), to(after.begin(), after.end());
  if (joint.kind == JointKind::band) {
    from.push_back(from.front());
    to.push_back(to.front());
  }
  const double wanted = wanted_rows(joint, sampling.segments);
  const std::size_t points = mesh.points.size(), triangles = mesh.triangles.size();
  // Where the rows of a band are unevenly far apart, twice as many.
  for (std::uint32_t rows = std::max(1U, std::uint32_t(wanted));; rows *= 2) {
    mesh.points.resize(points);
    mesh.triangles.resize(triangles);
    const double error = Patch(mesh, joint, sampling).append(from, to, rows);
    if (error <= sampling.allowed || rows > sampling.segments) {
      return error;
    }
  }
}

}  // namespace dupin::tessellation
