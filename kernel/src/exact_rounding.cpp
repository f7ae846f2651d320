#include "exact_rounding.h"

#include <algorithm>
#include <map>

#include <tbb/parallel_for.h>

#include "identical_points.h"

namespace dupin::detail {
namespace {

int sign(double value) { return (value > 0) - (value < 0); }

/// The exact error of the rounded difference a - b [Knuth, TAOCP 2, 4.2.2].
double difference_error(double a, double b, double difference) {
  const double b_taken = a - difference, a_taken = difference + b_taken;
  return (a - a_taken) + (b_taken - b);
}

bool same_place(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[3] == b[0] * a[3] && a[1] * b[3] == b[1] * a[3] && a[2] * b[3] == b[2] * a[3];
}

void round_double_point(const Vec3& point, const Vec3& origin, const Lattice& lattice,
                        RoundedPoints& rounded, std::uint32_t i) {
  for (int k = 0; k < 3; ++k) {
    const double value = point[k] - origin[k];
    const double error = difference_error(point[k], origin[k], value);
    rounded.doubles[i][k] = value + 0.0;
    rounded.on_lattice[i][k] = lattice.nearest(value, [&] { return sign(error); });
    if (error != 0) {
      rounded.inexact[i] = rounded.moved[i] = 1;
    }
    if (rounded.on_lattice[i][k] != value) {
      rounded.moved[i] = 1;
    }
  }
}

void round_implicit_point(const ExactPoint& point, const Vec3& nearest, const Vec3& origin,
                          const Lattice& lattice, RoundedPoints& rounded, std::uint32_t i) {
  const CGAL::Mpzf& weight = point[3];
  for (int k = 0; k < 3; ++k) {
    const double value = origin[k] == 0
                             ? nearest[k]
                             : nearest_double(point[k] - CGAL::Mpzf(origin[k]) * weight, weight);
    rounded.doubles[i][k] = value + 0.0;
    rounded.on_lattice[i][k] = lattice.nearest(value, [&] {
      return static_cast<int>(
          CGAL::sign(point[k] - (CGAL::Mpzf(origin[k]) + CGAL::Mpzf(value)) * weight));
    });
  }
  rounded.inexact[i] = rounded.moved[i] = 1;
}

}  // namespace

RoundedPoints round_points(const ExactMesh& mesh, const Lattice& lattice, const Vec3& origin) {
  const auto count = static_cast<std::uint32_t>(mesh.points.size());
  const std::uint32_t doubles = mesh.double_count();
  RoundedPoints rounded{std::vector<Vec3>(count), std::vector<std::uint8_t>(count, 0),
                        std::vector<Vec3>(count), std::vector<std::uint8_t>(count, 0)};
  tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t i) {
    if (i < doubles) {
      round_double_point(mesh.points[i], origin, lattice, rounded, i);
    } else {
      round_implicit_point(mesh.implicit[i - doubles], mesh.points[i], origin, lattice, rounded, i);
    }
  });
  return rounded;
}

std::vector<std::uint32_t> exact_twins(const ExactMesh& mesh) {
  // Points in the same place have the same nearest doubles. No implicit point is a double.
  std::vector<std::uint32_t> twins = first_identical(mesh.points);
  const std::uint32_t doubles = mesh.double_count();
  std::map<std::uint32_t, std::vector<std::uint32_t>> places;  // of the same nearest doubles
  for (std::uint32_t i = doubles; i < twins.size(); ++i) {
    const std::uint32_t first = twins[i];
    if (first == i) {
      continue;
    }
    std::vector<std::uint32_t>& known = places[first];
    if (known.empty() && first >= doubles) {
      known.push_back(first);
    }
    const auto twin = std::find_if(known.begin(), known.end(), [&](std::uint32_t other) {
      return same_place(mesh.implicit[i - doubles], mesh.implicit[other - doubles]);
    });
    twins[i] = twin != known.end() ? *twin : i;
    if (twin == known.end()) {
      known.push_back(i);
    }
  }
  return twins;
}

}  // namespace dupin::detail
