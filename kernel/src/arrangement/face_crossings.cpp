#include "arrangement/face_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "support/bulk_vector.h"
#include "support/sequences.h"

namespace dupin::arrangement {
namespace {

using Vec2 = Eigen::Vector2d;
using Corners = std::array<Vec3, 3>;

struct Segment {
  Vec2 from, to;
};

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

std::optional<Corners> corners_of(const ArrangementInput& input, std::uint32_t triangle) {
  const Triangle& t = input.triangles[triangle];
  if (!std::ranges::all_of(t, [&](PointId p) { return input.points.is_double(p); })) {
    return std::nullopt;
  }
  return Corners{input.points.coordinates(t[0]), input.points.coordinates(t[1]),
                 input.points.coordinates(t[2])};
}

/// A face as seen along the coordinate axis that is most across to it, and what cuts it.
class CutFace {
 public:
  explicit CutFace(const Corners& corners)
      : origin_(corners[0]), normal_((corners[1] - corners[0]).cross(corners[2] - corners[0])) {
    normal_.cwiseAbs().maxCoeff(&axis_);
    for (std::size_t i = 0; i < 3; ++i) {
      corners_[i] = seen(corners[i]);
    }
    turn_ = cross(corners_[1] - corners_[0], corners_[2] - corners_[0]) > 0 ? 1 : -1;
  }

  /// Where a triangle that lies on both sides of its plane meets it, unless that is no segment.
  [[nodiscard]] std::optional<Segment> cut_by(const Corners& other) const {
    std::array<double, 3> height{};
    for (std::size_t i = 0; i < 3; ++i) {
      height[i] = normal_.dot(other[i] - origin_);
    }
    std::array<Vec2, 2> ends{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      if ((height[i] > 0) != (height[k] > 0) && count < 2) {
        const double part = height[i] / (height[i] - height[k]);
        ends[count++] = seen(other[i] + part * (other[k] - other[i]));
      }
    }
    return count == 2 ? within({ends[0], ends[1]}) : std::nullopt;
  }

 private:
  [[nodiscard]] Vec2 seen(const Vec3& p) const { return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]}; }

  [[nodiscard]] std::optional<Segment> within(const Segment& line) const {
    const Vec2 along = line.to - line.from;
    double begin = 0, end = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 edge = corners_[(i + 1) % 3] - corners_[i];
      const double here = turn_ * cross(edge, line.from - corners_[i]);
      const double slope = turn_ * cross(edge, along);
      if (slope > 0) {
        begin = std::max(begin, -here / slope);
      } else if (slope < 0) {
        end = std::min(end, -here / slope);
      } else if (here < 0) {
        return std::nullopt;
      }
    }
    return begin < end ? std::optional(Segment{line.from + begin * along, line.from + end * along})
                       : std::nullopt;
  }

  Vec3 origin_, normal_;
  Eigen::Index axis_ = 0;
  std::array<Vec2, 3> corners_{};
  double turn_ = 1;
};

/// Where the segments cross, unless that is at an end; a point of more than two once.
std::size_t crossings(std::span<const Segment> segments) {
  constexpr double kEnd = 1e-6;
  std::vector<std::pair<float, float>> points;  // coarse enough for those of one place to be alike
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Vec2 along = segments[i].to - segments[i].from;
    for (std::size_t k = 0; k < i; ++k) {
      const Vec2 other = segments[k].to - segments[k].from;
      const Vec2 between = segments[k].from - segments[i].from;
      const double turn = cross(along, other);
      const double here = cross(between, other) / turn, there = cross(between, along) / turn;
      if (here > kEnd && here < 1 - kEnd && there > kEnd && there < 1 - kEnd) {
        const Vec2 point = segments[i].from + here * along - segments[0].from;
        points.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()));
      }
    }
  }
  support::sort_unique(points);
  return points.size();
}

/// Some faces that have candidates, and of each the triangles that may cut it.
struct FaceSample {
  std::vector<std::uint32_t> faces;
  std::vector<std::vector<std::uint32_t>> others;
};

FaceSample sampled(const ArrangementInput& input, std::span<const TrianglePair> candidates) {
  constexpr std::uint8_t kFaces = 32;
  FaceSample sample;
  for (std::size_t i = 0; i < kFaces && !candidates.empty(); ++i) {
    sample.faces.push_back(candidates[candidates.size() * i / kFaces].first);
  }
  support::sort_unique(sample.faces);
  sample.others.resize(sample.faces.size());
  support::BulkVector<std::uint8_t> place(input.triangles.size(), kFaces);
  for (std::size_t i = 0; i < sample.faces.size(); ++i) {
    place[sample.faces[i]] = static_cast<std::uint8_t>(i);
  }
  for (const auto& [first, second] : candidates) {
    if (place[first] != kFaces) {
      sample.others[place[first]].push_back(second);
    }
    if (place[second] != kFaces) {
      sample.others[place[second]].push_back(first);
    }
  }
  return sample;
}

std::vector<Segment> cuts(const ArrangementInput& input, std::uint32_t face,
                          std::span<const std::uint32_t> others) {
  std::vector<Segment> segments;
  if (const auto corners = corners_of(input, face)) {
    const CutFace cut_face(*corners);
    for (const std::uint32_t triangle : others) {
      const auto other = corners_of(input, triangle);
      if (const auto segment = other ? cut_face.cut_by(*other) : std::nullopt) {
        segments.push_back(*segment);
      }
    }
  }
  return segments;
}

/// Of many segments some are looked at.
double estimated_crossings(const std::vector<Segment>& segments) {
  constexpr std::size_t kMost = 32;
  std::vector<Segment> some;
  for (std::size_t i = 0; i < segments.size(); i += (segments.size() + kMost - 1) / kMost) {
    some.push_back(segments[i]);
  }
  const double times = static_cast<double>(segments.size()) / static_cast<double>(some.size());
  return times * times * static_cast<double>(crossings(some));
}

}  // namespace

double crossings_per_face(const ArrangementInput& input, std::span<const TrianglePair> candidates) {
  const FaceSample sample = sampled(input, candidates);
  double all = 0, cut = 0;
  for (std::size_t i = 0; i < sample.faces.size(); ++i) {
    const std::vector<Segment> segments = cuts(input, sample.faces[i], sample.others[i]);
    if (!segments.empty()) {
      all += estimated_crossings(segments);
      ++cut;
    }
  }
  return cut > 0 ? all / cut : 0;
}

}  // namespace dupin::arrangement
