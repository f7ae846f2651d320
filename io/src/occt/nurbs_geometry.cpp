#include "occt/nurbs_geometry.h"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pnt.hxx>

namespace dupin::occt {
namespace {

struct Knots {
  std::vector<double> values;
  std::vector<int> multiplicities;
};

Knots distinct(const std::vector<double>& repeated) {
  Knots result;
  for (const double knot : repeated) {
    if (!result.values.empty() && result.values.back() == knot) {
      ++result.multiplicities.back();
    } else {
      result.values.push_back(knot);
      result.multiplicities.push_back(1);
    }
  }
  return result;
}

TColStd_Array1OfReal reals(const std::vector<double>& values) {
  TColStd_Array1OfReal result(1, int(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    result.SetValue(int(i) + 1, values[i]);
  }
  return result;
}

TColStd_Array1OfInteger integers(const std::vector<int>& values) {
  TColStd_Array1OfInteger result(1, int(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    result.SetValue(int(i) + 1, values[i]);
  }
  return result;
}

constexpr int kDegree = 11;
using Bezier = Eigen::Matrix<double, kDegree + 1, 1>;

// Places in [0, 1] between which polynomials are told by their values.
double node(int i) { return (1 - std::cos(std::numbers::pi * i / kDegree)) / 2; }

// Bernstein coefficients of the polynomial with these values at the nodes.
Bezier interpolated(const Bezier& values) {
  static const auto kInverse = [] {
    Eigen::Matrix<double, kDegree + 1, kDegree + 1> matrix;
    for (int i = 0; i <= kDegree; ++i) {
      double binomial = 1;
      for (int k = 0; k <= kDegree; ++k) {
        matrix(i, k) = binomial * std::pow(node(i), k) * std::pow(1 - node(i), kDegree - k);
        binomial = binomial * (kDegree - k) / (k + 1);
      }
    }
    return matrix.inverse().eval();
  }();
  return kInverse * values;
}

Vec3 vec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

// A boundary of a surface by angles, whose sense is that of the parameter or the other one.
class Boundary {
 public:
  Boundary(const Handle(Geom_BSplineSurface) & surface, double v, const exchange::RingCurve& ring)
      : surface_(surface), v_(v), ring_(ring) {
    const double first = angle(0), next = std::remainder(angle(1.0 / 64) - first, kTurn);
    sense_ = next > 0 ? 1 : -1;
    seam_ = first;
  }

  // How far the angle has come from the seam, in [0, turn].
  [[nodiscard]] double turned(double u) const {
    if (u <= 0 || u >= 1) {
      return u <= 0 ? 0 : kTurn;
    }
    const double by = sense_ * (angle(u) - seam_);
    const double turned = by - kTurn * std::floor(by / kTurn);
    // Near the seam rounding may put it on the other side.
    return turned > kTurn / 2 && u < 0.05   ? turned - kTurn
           : turned < kTurn / 2 && u > 0.95 ? turned + kTurn
                                            : turned;
  }

  [[nodiscard]] double parameter(double turn, double low, double high) const {
    for (int i = 0; i < 60; ++i) {
      const double middle = low + (high - low) / 2;
      (turned(middle) < turn ? low : high) = middle;
    }
    return low + (high - low) / 2;
  }

  [[nodiscard]] int sense() const { return sense_; }

  static constexpr double kTurn = 2 * std::numbers::pi;

 private:
  [[nodiscard]] double angle(double u) const {
    return angle_on(ring_, vec(surface_->Value(u, v_)));
  }

  const Handle(Geom_BSplineSurface) & surface_;
  double v_;
  const exchange::RingCurve& ring_;
  int sense_ = 1;
  double seam_ = 0;
};

}  // namespace

Handle(Geom_BSplineSurface) bspline_surface(const NurbsSurface& surface) {
  const std::size_t along = surface.net.size(), around = surface.net.front().size();
  TColgp_Array2OfPnt poles(1, int(around), 1, int(along));
  TColStd_Array2OfReal weights(1, int(around), 1, int(along));
  for (std::size_t i = 0; i < along; ++i) {
    for (std::size_t j = 0; j < around; ++j) {
      const auto& [x, y, z, w] = surface.net[i][j];
      poles.SetValue(int(j) + 1, int(i) + 1, gp_Pnt(x / w, y / w, z / w));
      weights.SetValue(int(j) + 1, int(i) + 1, w);
    }
  }
  const Knots u = distinct(surface.knots_around), v = distinct(surface.knots_along);
  Handle(Geom_BSplineSurface) result = new Geom_BSplineSurface(
      poles, weights, reals(u.values), reals(v.values), integers(u.multiplicities),
      integers(v.multiplicities), surface.degree_around, surface.degree_along);
  // Cubics that meet tangentially need no more than double knots.
  if (surface.degree_along == 3) {
    for (int i = result->NbVKnots() - 1; i > 1; --i) {
      (void)result->RemoveVKnot(i, 2, 1e-9);
    }
  }
  return result;
}

double angle_on(const exchange::RingCurve& ring, const Vec3& point) {
  const Vec3 across = ring.normal.cross(ring.axis), from = point - ring.center;
  return std::atan2(from.dot(across) / ring.second, from.dot(ring.axis) / ring.first);
}

Handle(Geom2d_BSplineCurve) boundary_by_angle(const Handle(Geom_BSplineSurface) & surface, double v,
                                              const exchange::RingCurve& ring, double seam) {
  const Boundary boundary(surface, v, ring);
  std::vector<double> knots;
  for (int i = 1; i <= surface->NbUKnots(); ++i) {
    knots.push_back(surface->UKnot(i));
  }
  const int spans = int(knots.size()) - 1;
  TColgp_Array1OfPnt2d poles(1, spans * kDegree + 1);
  std::vector<double> angles{seam};
  for (int s = 0; s < spans; ++s) {
    // From the end if the angle falls.
    const int span = boundary.sense() > 0 ? s : spans - 1 - s;
    const double u0 = knots[std::size_t(span)], u1 = knots[std::size_t(span) + 1];
    const double t0 = boundary.turned(u0), t1 = boundary.turned(u1);
    Bezier values;
    for (int i = 0; i <= kDegree; ++i) {
      const double turn = t0 + (t1 - t0) * node(i);
      values[i] = i == 0 ? u0 : i == kDegree ? u1 : boundary.parameter(turn, u0, u1);
    }
    const Bezier bezier = interpolated(values);
    for (int i = 0; i <= kDegree; ++i) {
      const int at = boundary.sense() > 0 ? i : kDegree - i;
      const double u = at == 0 ? u0 : at == kDegree ? u1 : bezier[at];
      poles.SetValue(s * kDegree + i + 1, gp_Pnt2d(u, v));
    }
    angles.push_back(s + 1 == spans ? seam + Boundary::kTurn : angles.back() + (t1 - t0));
  }
  std::vector<int> multiplicities(angles.size(), kDegree);
  multiplicities.front() = multiplicities.back() = kDegree + 1;
  return new Geom2d_BSplineCurve(poles, reals(angles), integers(multiplicities), kDegree);
}

}  // namespace dupin::occt
