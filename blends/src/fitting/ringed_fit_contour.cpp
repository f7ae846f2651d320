#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

#include "dupin/blends/ringed_fit.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "fitting/circle_tracker.h"

namespace dupin {
namespace {

class ContourTracer {
 public:
  ContourTracer(const ImplicitSurface& surface, const Vec3& direction, double step)
      : surface_(surface), direction_(direction), step_(step) {}

  [[nodiscard]] std::vector<Vec3> run(const Vec3& start, std::size_t most_points) const {
    std::vector<Vec3> result{corrected(start)};
    Vec3 along = tangent(result.front(), Vec3::Zero());
    double length = step_;
    while (result.size() < most_points) {
      const Vec3 to_first = result.front() - result.back();
      // The first point is within a step ahead.
      if (result.size() > 2 && to_first.norm() < 1.5 * length && to_first.dot(along) > 0) {
        result.push_back(result.front());
        return result;
      }
      result.push_back(next(result.back(), along, length));
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
    const Vec3 first = both.row(0), second = both.row(1), along = first.cross(second);
    if (!(along.norm() > kRounding * first.norm() * (second.norm() + first.norm() / step_))) {
      throw Error(Errc::infeasible_blend,
                  "the contour has no direction at " + decimal(point) +
                      ": it crosses itself there, or all of the surface is along the direction");
    }
    return along.dot(before) < 0 ? Vec3(-along.normalized()) : along.normalized();
  }

  // A step on, or less where the contour turns: one that is too long leads elsewhere. It grows so
  // slowly that the first point is not passed.
  [[nodiscard]] Vec3 next(const Vec3& last, Vec3& along, double& length) const {
    constexpr int kMostHalvings = 40;
    constexpr double kStraight = 0.7, kAside = 0.4, kGrowth = 1.4;  // cosine; of the step
    length = std::min(kGrowth * length, step_);
    for (int i = 0; i < kMostHalvings; ++i, length /= 2) {
      const Vec3 expected = last + length * along;
      const std::optional<Vec3> found = on_contour(expected);
      if (found && (*found - expected).norm() < kAside * length) {
        const Vec3 ahead = tangent(*found, along);
        if (ahead.dot(along) > kStraight) {
          along = ahead;
          return *found;
        }
      }
    }
    throw Error(Errc::infeasible_blend,
                "the contour ends, or turns too sharply to be followed, at " + decimal(last));
  }

  [[nodiscard]] Vec3 corrected(const Vec3& start) const {
    if (const auto found = on_contour(start)) {
      return *found;
    }
    throw Error(Errc::infeasible_blend, "no point of the contour was found near " + decimal(start) +
                                            "; begin nearer to it, or take smaller steps");
  }

  // By Newton's iteration of least norm.
  [[nodiscard]] std::optional<Vec3> on_contour(const Vec3& start) const {
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
        return is_on_contour(point) ? std::optional(point) : std::nullopt;
      }
    }
    return std::nullopt;
  }

  // The iteration also settles where nothing is to be gained.
  [[nodiscard]] bool is_on_contour(const Vec3& point) const {
    constexpr double kNearly = 1e-6;
    const Vec3 gradient = surface_.gradient(point);
    const double size = gradient.norm();
    return std::abs(surface_.value(point)) <= kNearly * step_ * size &&
           std::abs(gradient.dot(direction_)) <= kNearly * size;
  }

  static constexpr double kRounding = 1e-12;
  const ImplicitSurface& surface_;
  const Vec3& direction_;
  double step_;
};

}  // namespace

std::vector<Vec3> implicit_contour(const ImplicitSurface& surface, const Vec3& direction,
                                   const Vec3& start, const ImplicitContourOptions& options) {
  fitting::require_functions(surface);
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
