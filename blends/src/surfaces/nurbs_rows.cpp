#include "surfaces/nurbs_rows.h"

#include <cmath>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::surfaces {

void require_nurbs_tolerance(double tolerance) {
  if (!(tolerance > 0 && std::isfinite(tolerance))) {
    throw Error(Errc::invalid_argument, "the tolerance of NURBS must be positive and finite, not " +
                                            decimal(tolerance, kMessageDigits));
  }
}

std::vector<double> bezier_knots(int degree, int pieces) {
  std::vector<double> knots{0};
  for (int piece = 0; piece <= pieces; ++piece) {
    knots.insert(knots.end(), std::size_t(degree), double(piece) / pieces);
  }
  knots.push_back(1);
  return knots;
}

std::vector<std::array<double, 4>> row_points(const NurbsRow& row) {
  // Corners and sides' middles of the square about the unit circle.
  constexpr int kCos[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, kSin[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  std::vector<std::array<double, 4>> points;
  for (std::size_t j = 0; j < 9; ++j) {
    const double weight = j % 2 == 0 ? 1 : std::sqrt(0.5);
    const Vec3 p = weight * (row.center + kCos[j] * row.a + kSin[j] * row.b);
    points.push_back({p.x(), p.y(), p.z(), weight * row.weight});
  }
  return points;
}

NurbsSurface nurbs_through(const std::vector<NurbsRow>& rows, int degree) {
  NurbsSurface result{
      degree, 2, bezier_knots(degree, int(rows.size() - 1) / degree), bezier_knots(2, 4), {}};
  for (const NurbsRow& row : rows) {
    result.net.push_back(row_points(row));
  }
  return result;
}

}  // namespace dupin::surfaces
