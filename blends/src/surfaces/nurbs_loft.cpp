#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "ringed/second_derivatives.h"
#include "surfaces/nurbs_rows.h"
#include "tessellation/swept_mesh.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin::surfaces {
namespace {

// Places per cubic where it is compared with the surface, and rotations of the frame between them.
constexpr int kSamples = 64, kRotations = 16;

// The rows of both kinds of tubes, as those of an elliptic one.
struct Axes {
  Vec3 center, first, second;  // the semi-axes as vectors
};

struct RowJet {
  Axes value, rate;
};

// A tube cut into equal pieces, with frames at all samples.
template <class Tube>
class Loft {
 public:
  Loft(const Tube& tube, int pieces) : tube_(tube), pieces_(pieces) {
    const int count = pieces * kSamples;
    Vec3 tangent = evaluate(tube.spine, 0).first.normalized();
    Vec3 first = start_axis(tube);
    first = (first - first.dot(tangent) * tangent).normalized();
    firsts_.push_back(first);
    for (int i = 1; i <= count; ++i) {
      for (int step = 1; step <= kRotations; ++step) {
        const double t = (i - 1 + double(step) / kRotations) / count;
        const Vec3 next = evaluate(tube.spine, t).first.normalized();
        first = tessellation::carried(tangent, next, first);
        tangent = next;
      }
      first = (first - first.dot(tangent) * tangent).normalized();
      firsts_.push_back(first);
    }
    turn_ = turn_at_end(tube);
  }

  // The bound; `rows` take the control rows.
  double measure(std::vector<NurbsRow>& rows) const {
    double largest = 0, drift = 0;
    for (int piece = 0; piece < pieces_; ++piece) {
      const auto [error, turned] = append_piece(piece, rows);
      largest = std::max(largest, error);
      drift += turned;
    }
    return largest + axis_error(tube_, drift) + tessellation::point_error(tube_, 0);
  }

 private:
  static Vec3 start_axis(const RingedSurface& surface) { return reference_axis(surface.start); }
  static Vec3 start_axis(const EllipticTube& tube) { return tube.axis; }

  double turn_at_end(const RingedSurface&) const { return 0; }
  double turn_at_end(const EllipticTube& tube) const {
    if (!tube.end.ellipse) {
      return tube.turn;
    }
    const Vec3 tangent = evaluate(tube.spine, 1).first.normalized();
    const Vec3 &axis = tube.end.ellipse->axis, &first = firsts_.back();
    const double angle = std::atan2(axis.dot(tangent.cross(first)), axis.dot(first));
    return tube.turn + std::remainder(angle - tube.turn, std::numbers::pi);
  }

  // Turned circles are the same; turned ellipses are off by the angle times the semi-axes'
  // difference, where the angle is lost on the way or corrected for at the end.
  static double axis_error(const RingedSurface&, double) { return 0; }
  static double axis_error(const EllipticTube& tube, double drift) {
    return 2 * drift * std::max(largest_radius(tube.first), largest_radius(tube.second));
  }

  static std::array<RadiusValue, 2> radii(const RingedSurface& surface, double t) {
    return {evaluate(surface.radius, t), evaluate(surface.radius, t)};
  }
  static std::array<RadiusValue, 2> radii(const EllipticTube& tube, double t) {
    return {evaluate(tube.first, t), evaluate(tube.second, t)};
  }

  static std::array<double, 2> eased(const RingedSurface&, double) { return {0, 0}; }
  static std::array<double, 2> eased(const EllipticTube& tube, double t) {
    const double s = 1 - t;
    return tube.continuity == Continuity::g1
               ? std::array{t * t * (3 - 2 * t), 6 * t * s}
               : std::array{t * t * t * (10 - t * (15 - 6 * t)), 30 * t * t * s * s};
  }

  // c' = -(c.T') T + turn' (T x c) for a direction c across the spine.
  [[nodiscard]] RowJet row_at(int sample) const {
    const double t = double(sample) / (pieces_ * kSamples);
    const SpinePoint y = evaluate(tube_.spine, t);
    const double speed = y.first.norm();
    const Vec3 tangent = y.first / speed, &first = firsts_[std::size_t(sample)];
    const Vec3 bend = (y.second - y.second.dot(tangent) * tangent) / speed;
    const auto [angle, rate] = eased(tube_, t);
    const double c = std::cos(turn_ * angle), s = std::sin(turn_ * angle);
    const Vec3 across = tangent.cross(first);
    const Vec3 c1 = c * first + s * across, c2 = c * across - s * first;
    const auto [a, b] = radii(tube_, t);
    const double spin = turn_ * rate;
    return {{y.position, a.value * c1, b.value * c2},
            {y.first, a.first * c1 + a.value * (spin * c2 - c1.dot(bend) * tangent),
             b.first * c2 - b.value * (spin * c1 + c2.dot(bend) * tangent)}};
  }

  struct PieceError {
    double error = 0, drift = 0;
  };

  // Cubics with the rows and rates at both ends. Between samples d apart, the difference from the
  // surface exceeds that at the samples by at most d^2 / 8 times the bound of the second
  // derivatives of both, and by what the frame may have lost there.
  PieceError append_piece(int piece, std::vector<NurbsRow>& rows) const {
    const int base = piece * kSamples;
    const double width = 1. / pieces_, d = width / kSamples;
    const RowJet from = row_at(base), to = row_at(base + kSamples);
    const auto cubic = [&](auto part) {
      return std::array<Vec3, 4>{from.value.*part, from.value.*part + width / 3 * (from.rate.*part),
                                 to.value.*part - width / 3 * (to.rate.*part), to.value.*part};
    };
    const auto center = cubic(&Axes::center), a = cubic(&Axes::first), b = cubic(&Axes::second);
    double largest = 0;
    for (int i = 1; i < kSamples; ++i) {
      const double t = double(i) / kSamples, s = 1 - t;
      const auto at = [&](const std::array<Vec3, 4>& p) {
        return Vec3(s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] +
                    t * t * t * p[3]);
      };
      const Axes exact = row_at(base + i).value;
      largest = std::max(
          largest, (at(center) - exact.center).norm() +
                       std::hypot((at(a) - exact.first).norm(), (at(b) - exact.second).norm()));
    }
    const auto second = [&](const std::array<Vec3, 4>& p) {
      return 6 / (width * width) *
             std::max((p[0] - 2 * p[1] + p[2]).norm(), (p[1] - 2 * p[2] + p[3]).norm());
    };
    const ringed::BandBounds bounds =
        ringed::band_bounds(tube_, base * d, std::min(1., (base + kSamples) * d));
    const double curved = bounds.second.along + second(center) + std::hypot(second(a), second(b));
    const double step = bounds.turning * d / kRotations;
    const double lost = 0.27 * step * step * kRotations;
    for (std::size_t i = rows.empty() ? 0 : 1; i < 4; ++i) {
      rows.push_back({center[i], a[i], b[i], 1});
    }
    return {largest + d * d / 8 * curved + lost * bounds.second.around, lost * kSamples};
  }

  const Tube& tube_;
  int pieces_;
  std::vector<Vec3> firsts_;
  double turn_ = 0;
};

template <class Tube>
NurbsForm lofted(const Tube& tube, double tolerance) {
  constexpr int kMost = 4096;
  (void)tessellation::allowed_error(
      tolerance, tessellation::point_error(tube, 0));  // or no number of cubics is enough
  std::optional<Error> undecided;
  for (int pieces = 2; pieces <= kMost; pieces += (pieces + 1) / 2) {
    std::vector<NurbsRow> rows;
    try {
      undecided.reset();
      const double error = Loft<Tube>(tube, pieces).measure(rows);
      if (error <= tolerance) {
        return {{nurbs_through(rows, 3)}, error};
      }
    } catch (const Error& error) {
      // Over a long stretch intervals do not tell that the spine goes on; over shorter ones they
      // do.
      if (error.code() != Errc::irregular_surface) {
        throw;
      }
      undecided = error;
    }
  }
  if (undecided) {
    throw *undecided;
  }
  throw Error(Errc::limit_exceeded, "a tolerance of " + decimal(tolerance, kMessageDigits) +
                                        " asks for more than " + std::to_string(kMost) +
                                        " cubics along the part; use a larger one");
}

}  // namespace

NurbsForm lofted_nurbs(const RingedSurface& surface, double tolerance) {
  return lofted(surface, tolerance);
}

NurbsForm lofted_nurbs(const EllipticTube& tube, double tolerance) {
  return lofted(tube, tolerance);
}

}  // namespace dupin::surfaces
