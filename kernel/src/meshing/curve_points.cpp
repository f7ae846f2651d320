#include "meshing/curve_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "dupin/kernel/parallel.h"

namespace dupin::meshing {
namespace {

/// Of balls, in shares of the way to the next one: neighbours' overlap and others' do not.
constexpr double kRadius = 0.7;
/// Of ways between neighbours, in shares of the gap to other curves: their balls do not overlap.
constexpr double kShareOfGap = 2.0 / 3;
/// The same for balls of corners.
constexpr double kCornerShareOfGap = 0.4;
/// How much lengths may change along a curve.
constexpr double kGrowth = 0.4;
/// From a corner's ball to the first point, in shares of the way to the next one.
constexpr double kFirst = 0.4;

/// A curve as a function of the length along it.
class Path {
 public:
  explicit Path(const std::vector<Vec3>& points) : points_(points), at_(1, 0) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      at_.push_back(at_.back() + (points[i] - points[i - 1]).norm());
    }
  }
  [[nodiscard]] double length() const { return at_.back(); }
  [[nodiscard]] Vec3 place(double along) const {
    const auto next = std::ranges::upper_bound(at_, along);
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
        next - at_.begin(), 1, static_cast<std::ptrdiff_t>(at_.size()) - 1));
    const double edge = at_[i] - at_[i - 1];
    const double part = edge > 0 ? std::clamp((along - at_[i - 1]) / edge, 0.0, 1.0) : 0;
    return points_[i - 1] + part * (points_[i] - points_[i - 1]);
  }

 private:
  const std::vector<Vec3>& points_;
  std::vector<double> at_;
};

/// How long ways between neighbours may be at a place of a curve.
struct Sample {
  double along, length;
};

class Placer {
 public:
  Placer(const Features& features, const EdgeLengths& lengths, const std::vector<double>& shares,
         std::size_t most)
      : features_(features), lengths_(lengths), shares_(shares), most_(most) {}

  CurvePoints run() {
    place_corners();
    const std::size_t count = features_.curves.size();
    std::vector<std::vector<CurvePoint>> between(count);
    for_each_in_parallel(
        count, [&](std::size_t c) { between[c] = points_on(static_cast<std::uint32_t>(c)); });
    for (std::size_t c = 0; c < count; ++c) {
      std::vector<std::uint32_t> chain = {ends_[c][0]};
      for (const CurvePoint& point : between[c]) {
        chain.push_back(static_cast<std::uint32_t>(result_.points.size()));
        result_.points.push_back(point);
      }
      chain.push_back(ends_[c][1]);
      result_.chains.push_back(std::move(chain));
    }
    return std::move(result_);
  }

 private:
  void place_corners() {
    std::map<std::array<double, 3>, std::uint32_t> numbers;
    std::vector<std::vector<std::uint32_t>> curves_at;
    for (std::uint32_t c = 0; c < features_.curves.size(); ++c) {
      const std::vector<Vec3>& points = features_.curves[c].points;
      std::array<std::uint32_t, 2> ends{};
      for (std::size_t k = 0; k < 2; ++k) {
        const Vec3& end = k == 0 ? points.front() : points.back();
        const auto [at, is_new] = numbers.try_emplace(
            {end.x(), end.y(), end.z()}, static_cast<std::uint32_t>(result_.points.size()));
        if (is_new) {
          result_.points.push_back({end, 0, false});
          curves_at.emplace_back();
        }
        ends[k] = at->second;
        curves_at[at->second].push_back(c);
      }
      ends_.push_back(ends);
    }
    for_each_in_parallel(curves_at.size(), [&](std::size_t q) {
      std::vector<std::uint32_t>& curves = curves_at[q];
      CurvePoint& corner = result_.points[q];
      corner.is_corner = curves.size() != 2 || curves[0] != curves[1];
      std::ranges::sort(curves);
      curves.erase(std::unique(curves.begin(), curves.end()), curves.end());
      corner.radius = corner_radius(corner.place, curves);
    });
  }

  [[nodiscard]] double corner_radius(const Vec3& place,
                                     const std::vector<std::uint32_t>& curves) const {
    double radius = std::numeric_limits<double>::infinity();
    for (const std::uint32_t c : curves) {
      const double length = lengths_.along(place, c) * shares_[c];
      const double way =
          Path(features_.curves[c].points).length() / (ends_[c][0] == ends_[c][1] ? 8 : 4);
      radius = std::min({radius, kRadius * length, way});
    }
    const double reach = radius / kCornerShareOfGap;
    for (const std::uint32_t c : curves) {
      radius = std::min(radius, kCornerShareOfGap * lengths_.gap_beside(place, c, curves, reach));
    }
    for (const std::uint32_t c : curves) {
      radius = graded_radius(place, c, curves, radius);
    }
    return radius;
  }

  /// No larger than what lengths grow to from those further along a curve. Gaps to other curves of
  /// the corner, which are as small as its ball is, count where they get smaller again.
  [[nodiscard]] double graded_radius(const Vec3& corner, std::uint32_t c,
                                     const std::vector<std::uint32_t>& curves,
                                     double radius) const {
    const std::vector<Vec3>& points = features_.curves[c].points;
    const Path path(points);
    for (const bool from_end : {false, true}) {
      if ((from_end ? points.back() : points.front()) != corner) {
        continue;
      }
      double least = 0;  // of gaps to all
      for (double along = radius;
           kRadius * kGrowth * along < radius && along < path.length() / 2;) {
        const Vec3 place = path.place(from_end ? path.length() - along : along);
        const double reach = radius / kRadius / kShareOfGap;
        const double to_all = lengths_.gap_beside(place, c, {c}, reach);
        const double gap = to_all < least ? to_all : lengths_.gap_beside(place, c, curves, reach);
        least = least > 0 ? std::min(least, to_all) : to_all;
        const double length = std::min(lengths_.along(place, c) * shares_[c], kShareOfGap * gap);
        radius = std::min(radius, kRadius * (length + kGrowth * along));
        along += std::max(length, kGrowth * along) / 2;
      }
    }
    return radius;
  }

  /// Those between its ends' balls.
  [[nodiscard]] std::vector<CurvePoint> points_on(std::uint32_t c) const {
    const Path path(features_.curves[c].points);
    const double begin = result_.points[ends_[c][0]].radius,
                 end = path.length() - result_.points[ends_[c][1]].radius;
    const std::vector<Sample> samples = samples_on(c, path, begin, end);
    // Lengths' reciprocals, summed up: how many ways there are up to each sample.
    std::vector<double> ways(1, 0);
    for (std::size_t i = 1; i < samples.size(); ++i) {
      ways.push_back(ways.back() + (samples[i].along - samples[i - 1].along) / 2 *
                                       (1 / samples[i - 1].length + 1 / samples[i].length));
    }
    const double count = std::max(1.0, std::ceil(ways.back() - 2 * kFirst + 1));
    const double step = ways.back() / (count - 1 + 2 * kFirst);  // at most 1
    std::vector<CurvePoint> points;
    std::size_t i = 1;
    for (double k = 0; k < count; ++k) {
      const double way = (kFirst + k) * step;
      while (i + 1 < samples.size() && ways[i] < way) {
        ++i;
      }
      const double part = std::clamp((way - ways[i - 1]) / (ways[i] - ways[i - 1]), 0.0, 1.0);
      const auto between = [&](double a, double b) { return a + part * (b - a); };
      const double along = between(samples[i - 1].along, samples[i].along);
      const double length = between(samples[i - 1].length, samples[i].length);
      points.push_back({path.place(along), kRadius * step * length, false});
    }
    return points;
  }

  [[nodiscard]] std::vector<Sample> samples_on(std::uint32_t c, const Path& path, double begin,
                                               double end) const {
    std::vector<Sample> samples;
    for (double along = begin;;) {
      const Vec3 place = path.place(along);
      const double length = lengths_.along(place, c) * shares_[c];
      const double gap = lengths_.gap(place, c, along, length / kShareOfGap);
      samples.push_back({along, std::min(length, kShareOfGap * gap)});
      if (along >= end) {
        break;
      }
      const double next = along + samples.back().length / 2;
      if (samples.size() > 2 * most_ || !(next > along)) {
        throw gap < length / kShareOfGap ? too_near(place, gap) : too_short(place, length);
      }
      along = std::min(next, end);
    }
    const auto [first, last] = ends_[c];
    limit_growth({0, result_.points[first].radius / kRadius}, samples.front());
    limit_growth({path.length(), result_.points[last].radius / kRadius}, samples.back());
    for (std::size_t i = 1; i < samples.size(); ++i) {
      limit_growth(samples[i - 1], samples[i]);
    }
    for (std::size_t i = samples.size() - 1; i > 0; --i) {
      limit_growth(samples[i], samples[i - 1]);
    }
    return samples;
  }
  static void limit_growth(const Sample& from, Sample& to) {
    to.length = std::min(to.length, from.length + kGrowth * std::abs(to.along - from.along));
  }

  const Features& features_;
  const EdgeLengths& lengths_;
  const std::vector<double>& shares_;
  std::size_t most_;
  std::vector<std::array<std::uint32_t, 2>> ends_;  // per curve, points
  CurvePoints result_;
};

}  // namespace

CurvePoints points_along(const Features& features, const EdgeLengths& lengths,
                         const std::vector<double>& shares, std::size_t most) {
  return Placer(features, lengths, shares, most).run();
}

}  // namespace dupin::meshing
