#include "canal/perpendicular_net.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "dupin/blends/canal_fillet.h"
#include "dupin/blends/nurbs.h"
#include "numbers/exact_vec3.h"
#include "numbers/polynomial.h"

namespace dupin {
namespace canal {
namespace {

using numbers::Polynomial;

Polynomial scaled(const mpq_class& factor, Polynomial p) {
  for (mpq_class& coefficient : p) {
    coefficient *= factor;
  }
  return p;
}

Polynomial product(const Polynomial& a, const Polynomial& b, const Polynomial& c) {
  return numbers::product(numbers::product(a, b), c);
}

/// Coefficients, of degree 10 by q, of a polynomial in s = sin of degree 5 or less, which is
/// multiplied by cos if `with_cosine` (and is of degree 4 then), times (1 + q^2)^5.
std::array<mpq_class, 11> by_half_angle(const Polynomial& in_sine, bool with_cosine) {
  const Polynomial sine{0, 2}, cosine{1, 0, -1}, one{1, 0, 1};
  Polynomial sum(11);
  for (std::size_t k = 0; k < in_sine.size(); ++k) {
    if (sgn(in_sine[k]) == 0) {
      continue;
    }
    Polynomial term{in_sine[k]};
    for (std::size_t i = 0; i < 5; ++i) {
      const bool is_cosine = with_cosine && i == 4;
      term = numbers::product(term, is_cosine ? cosine : (i < k ? sine : one));
    }
    for (std::size_t i = 0; i < term.size(); ++i) {
      sum[i] += term[i];
    }
  }
  std::array<mpq_class, 11> result;
  const auto coefficients = numbers::bernstein(sum, 10);
  std::copy(coefficients.begin(), coefficients.end(), result.begin());
  return result;
}

/// Polynomials in the sine; x is still to be multiplied by the cosine.
struct HomogeneousRow {
  Polynomial x, y, z, weight;
};

/// B.8 with m for `size`.
std::array<HomogeneousRow, 3> rows(const mpq_class& r1, const mpq_class& r2, const mpq_class& m) {
  const mpq_class m2 = m * m, m3 = m2 * m, m4 = m2 * m2, rest = 1 - 2 * m, dl = r1 - r2;
  const Polynomial k1{1, 0, m2}, k2{rest * rest, 0, m * (2 - 3 * m)};
  const Polynomial q{rest, 0, m * (2 - m)}, n{rest, 0, m2}, less{1, 0, -m2}, sine{0, 1};
  return {{{scaled(4 * m * dl, k1), scaled(2 * r1, numbers::product(less, n)),
            scaled(4 * m * r1, numbers::product(sine, n)), scaled(2, numbers::product(k1, n))},
           {{r2 * rest * rest, 0, 4 * m2 * (1 - m) * r1 - 2 * m2 * r2, 0, m4 * r2},
            {r1 * rest * rest, 0, 2 * m * (1 - m) * r1 - 2 * m * (1 - 2 * m + 2 * m2) * r2, 0,
             m3 * ((m - 2) * r1 + 2 * r2)},
            {0, (1 - 2 * m + 2 * m2) * r2 - 4 * m2 * (1 - m) * r1, 0,
             4 * m2 * (1 - m) * r1 - 2 * m2 * (1 - m + m2) * r2, 0, m4 * r2},
            numbers::product(q, n)},
           {scaled(r2, numbers::product(k2, n)), scaled(dl, numbers::product(less, k2)),
            scaled(r2, product(sine, k2, n)), numbers::product(k2, n)}}};
}

}  // namespace

ExactNet perpendicular_net(const mpq_class& thick, const mpq_class& thin, const mpq_class& size) {
  ExactNet net;
  const auto homogeneous = rows(thick, thin, size);
  for (std::size_t j = 0; j < 3; ++j) {
    const std::array<std::array<mpq_class, 11>, 4> coordinates{
        by_half_angle(homogeneous[j].x, true), by_half_angle(homogeneous[j].y, false),
        by_half_angle(homogeneous[j].z, false), by_half_angle(homogeneous[j].weight, false)};
    for (std::size_t i = 0; i < 11; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        net[j][i][k] = coordinates[k][i];
      }
    }
  }
  return net;
}

}  // namespace canal

namespace {

bool is_perpendicular_and_constant(const CanalFillet& fillet, const RationalCrossing& motion) {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  const auto& [g, g1, g2, g3] = motion.size;
  return fillet.quadrics[0].slope == 0 && fillet.quadrics[1].slope == 0 &&
         std::abs(motion.cosine) <= kRounding && motion.e4.m.norm() <= kRounding &&
         std::abs(g1) + std::abs(g2) + std::abs(g3) <= kRounding;
}

}  // namespace

std::optional<std::array<CanalNet, 4>> exact_nets(const CanalFillet& fillet) {
  const auto* motion = std::get_if<RationalCrossing>(&fillet.motion);
  if (motion == nullptr || !is_perpendicular_and_constant(fillet, *motion)) {
    return std::nullopt;
  }
  const auto [smaller, larger] = std::minmax(fillet.quadrics[0].radius, fillet.quadrics[1].radius);
  const canal::ExactNet exact = canal::perpendicular_net(
      numbers::exact(larger), numbers::exact(smaller), numbers::exact(motion->size[0]));
  const bool from_thicker = fillet.quadrics[0].radius == larger;
  std::array<CanalNet, 4> nets;
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    // The signs of cosine and sine there; the quarters of unequal signs run the other way.
    const double c = quarter == 0 || quarter == 3 ? -1 : 1, s = quarter < 2 ? -1 : 1;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 11; ++i) {
        const auto& point = exact[from_thicker ? j : 2 - j][c == s ? i : 10 - i];
        const double weight = point[3].get_d();
        const Vec3 weighted = weight * motion->origin.m + c * point[0].get_d() * motion->along.m +
                              motion->side * point[1].get_d() * motion->across.m +
                              s * point[2].get_d() * motion->e3.m;
        nets.at(quarter)[j][i] = {weighted.x(), weighted.y(), weighted.z(), weight};
      }
    }
  }
  return nets;
}

}  // namespace dupin
