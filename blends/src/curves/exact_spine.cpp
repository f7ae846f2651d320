#include "curves/exact_spine.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"
#include "numbers/polynomial.h"

namespace dupin::curves {
namespace {

bool is_zero(const numbers::ExactVec3& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

// Scaled by its largest coordinate first: exact numbers may lie outside the range of doubles.
Vec3 direction(const numbers::ExactVec3& v) {
  mpq_class largest = 0;
  for (const mpq_class& x : v) {
    largest = std::max<mpq_class>(largest, abs(x));
  }
  const auto scaled = [&](int i) { return mpq_class(v[i] / largest).get_d(); };
  return Vec3(scaled(0), scaled(1), scaled(2)).normalized();
}

Vec3 any_normal(const Vec3& tangent) {
  int smallest = 0;
  tangent.cwiseAbs().minCoeff(&smallest);
  return tangent.cross(Vec3::Unit(smallest)).normalized();
}

std::optional<Vec3> common_normal(const std::vector<numbers::ExactVec3>& vectors) {
  const numbers::ExactVec3* along = nullptr;
  std::optional<numbers::ExactVec3> normal;
  for (const numbers::ExactVec3& v : vectors) {
    if (is_zero(v)) {
      continue;
    }
    if (along == nullptr) {
      along = &v;
    } else if (!normal) {
      const numbers::ExactVec3 across = cross(*along, v);
      if (!is_zero(across)) {
        normal = across;
      }
    } else if (dot(*normal, v) != 0) {
      return std::nullopt;
    }
  }
  if (normal) {
    return direction(*normal);
  }
  return along == nullptr ? Vec3::UnitZ() : any_normal(direction(*along));
}

}  // namespace

std::vector<numbers::ExactVec3> velocity(const LineSpine& line) {
  return {numbers::exact(line.to) - numbers::exact(line.from)};
}

std::vector<numbers::ExactVec3> velocity(const HermiteSpine& h) {
  const numbers::ExactVec3 delta = numbers::exact(h.to) - numbers::exact(h.from);
  const numbers::ExactVec3 s = numbers::exact(h.start_velocity), e = numbers::exact(h.end_velocity);
  return {s, mpq_class(6) * delta - mpq_class(4) * s - mpq_class(2) * e,
          mpq_class(3) * (s + e) - mpq_class(6) * delta};
}

// With y = p / w: y' w^2 = p' w - p w'.
RationalVelocity velocity(const BezierSpine& bezier) {
  numbers::VectorPolynomial points;
  numbers::Polynomial weights;
  for (std::size_t i = 0; i < bezier.points.size(); ++i) {
    weights.push_back(numbers::exact(bezier.weights.empty() ? 1 : bezier.weights[i]));
    points.push_back(weights.back() * numbers::exact(bezier.points[i]));
  }
  const numbers::VectorPolynomial p = numbers::power_basis(points);
  const numbers::Polynomial w = numbers::trimmed(numbers::power_basis(weights));
  numbers::VectorPolynomial numerator(p.size() + w.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < w.size(); ++j) {
      if (i + j > 0) {
        const mpq_class factor(static_cast<long>(i) - static_cast<long>(j));
        numerator[i + j - 1] = numerator[i + j - 1] + factor * w[j] * p[i];
      }
    }
  }
  return {numbers::trimmed(numerator), w};
}

std::optional<Vec3> plane_normal(const Spine& spine) {
  struct Visitor {
    std::optional<Vec3> operator()(const ArcSpine& arc) const { return arc.axis.normalized(); }
    std::optional<Vec3> operator()(const LineSpine& line) const {
      return common_normal(velocity(line));
    }
    std::optional<Vec3> operator()(const HermiteSpine& hermite) const {
      return common_normal(velocity(hermite));
    }
    std::optional<Vec3> operator()(const BezierSpine& bezier) const {
      return common_normal(velocity(bezier).numerator);
    }
  };
  return std::visit(Visitor{}, spine);
}

}  // namespace dupin::curves
