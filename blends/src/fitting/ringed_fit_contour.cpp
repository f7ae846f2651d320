#include <cmath>

#include <Eigen/Dense>

#include "dupin/blends/ringed_fit.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

class ContourTracer {
 public:
  ContourTracer(const ImplicitSurface& surface, const Vec3& direction, double step)
      : surface_(surface), direction_(direction), step_(step) {}

  [[nodiscard]] std::vector<Vec3> run(const Vec3& start, std::size_t most_points) const {
    std::vector<Vec3> result{corrected(start)};
    Vec3 along = tangent(result.front(), Vec3::Zero());
    while (result.size() < most_points) {
      const Vec3 next = corrected(result.back() + step_ * along);
      const Vec3 to_first = result.front() - result.back();
      // The first point is within a step ahead.
      if (result.size() > 2 && to_first.norm() < 1.5 * step_ && to_first.dot(along) > 0) {
        result.push_back(result.front());
        return result;
      }
      along = tangent(next, along);
      result.push_back(next);
    }
    return result;
  }

 private:
  // The gradients of f and of its derivative along the direction.
  [[nodiscard]] Eigen::Matrix<double, 2, 3> gradients(const Vec3& point) const {
    const double h = 1e-4 * step_;
    Eigen::Matrix<double, 2, 3> result;
    result.row(0) = surface_.gradient(point);
    result.row(1) =
        (surface_.gradient(point + h * direction_) - surface_.gradient(point - h * direction_)) /
        (2 * h);
    return result;
  }

  // On the side of `before`.
  [[nodiscard]] Vec3 tangent(const Vec3& point, const Vec3& before) const {
    const auto both = gradients(point);
    const Vec3 along = Vec3(both.row(0)).cross(Vec3(both.row(1))).normalized();
    return along.dot(before) < 0 ? Vec3(-along) : along;
  }

  // Newton's iteration of least norm.
  [[nodiscard]] Vec3 corrected(const Vec3& start) const {
    constexpr int kMostSteps = 50;
    Vec3 point = start;
    for (int i = 0; i < kMostSteps; ++i) {
      const Eigen::Vector2d off(surface_.value(point), surface_.gradient(point).dot(direction_));
      const Vec3 move = gradients(point).completeOrthogonalDecomposition().solve(-off);
      if (!move.allFinite()) {
        break;
      }
      point += move;
      if (move.norm() <= 1e-10 * step_) {
        if (is_on_contour(point)) {
          return point;
        }
        break;
      }
    }
    throw Error(Errc::infeasible_blend, "no point of the contour was found near " + decimal(start) +
                                            "; begin nearer to it, or take smaller steps");
  }

  // The iteration also settles where nothing is to be gained.
  [[nodiscard]] bool is_on_contour(const Vec3& point) const {
    constexpr double kNearly = 1e-6;
    const Vec3 gradient = surface_.gradient(point);
    const double size = gradient.norm();
    return std::abs(surface_.value(point)) <= kNearly * step_ * size &&
           std::abs(gradient.dot(direction_)) <= kNearly * size;
  }

  const ImplicitSurface& surface_;
  const Vec3& direction_;
  double step_;
};

}  // namespace

std::vector<Vec3> implicit_contour(const ImplicitSurface& surface, const Vec3& direction,
                                   const Vec3& start, const ImplicitContourOptions& options) {
  if (!direction.allFinite() || !(direction.norm() > 0) || !start.allFinite() ||
      !(options.step > 0) || !std::isfinite(options.step) || options.most_points == 0) {
    throw Error(Errc::invalid_argument,
                "a contour needs a finite direction that is not zero, a finite start, a positive "
                "step and at least one point");
  }
  return ContourTracer(surface, direction.normalized(), options.step)
      .run(start, options.most_points);
}

}  // namespace dupin
