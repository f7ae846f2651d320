#include "dupin/kernel/triangulate_region.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <utility>

#include "arrangement/faces/constrained_triangulation.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using arrangement::ConstrainedTriangulation;
using arrangement::kNone;
using arrangement::PointId;
using Polygon = std::vector<std::uint32_t>;

[[noreturn]] void refuse_touching() {
  throw Error(Errc::self_intersecting, "the polygons that bound a region cross or touch");
}

void require_points(std::span<const std::uint32_t> corners, std::size_t points) {
  for (const std::uint32_t corner : corners) {
    if (corner >= points) {
      throw Error(Errc::invalid_argument, "a region has the corner " + std::to_string(corner) +
                                              ", but there are " + std::to_string(points) +
                                              " points");
    }
  }
}

class Region {
 public:
  Region(std::span<const Vec2> points, std::span<const Polygon> polygons,
         std::span<const std::uint32_t> inner)
      : polygons_(polygons),
        corners_(inner.begin(), inner.end()),
        vertex_of_(points.size(), kNone) {
    for (const Polygon& polygon : polygons) {
      if (polygon.size() < 3) {
        throw Error(Errc::invalid_argument, "a polygon needs at least three corners, not " +
                                                std::to_string(polygon.size()));
      }
      corners_.insert(corners_.end(), polygon.begin(), polygon.end());
    }
    std::ranges::sort(corners_);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    refuse_coincident(points);
    order_for_insertion(points);
    for (const std::uint32_t corner : corners_) {
      table_.add(Vec3(points[corner].x(), points[corner].y(), 0));
    }
    support_ = {table_.add(Vec3(0, 0, 0)), table_.add(Vec3(1, 0, 0)), table_.add(Vec3(0, 1, 0))};
  }

  std::vector<Triangle> triangles() {
    const arrangement::UpwardRounding rounding;
    const auto refuse = [](std::uint32_t, std::uint32_t) -> std::uint32_t { refuse_touching(); };
    const auto refuse_point = [](std::uint32_t, std::uint32_t) -> arrangement::ImplicitPoint {
      refuse_touching();
    };
    ConstrainedTriangulation triangulation(table_, {refuse_point, refuse});
    triangulation.clear({2, 1});
    std::vector<PointId> ids(corners_.size());
    std::iota(ids.begin(), ids.end(), PointId{0});
    triangulation.start_around(ids);
    for (const PointId id : ids) {
      vertex_of_[corners_[id]] = triangulation.add(id);
      triangulation.insert(vertex_of_[corners_[id]]);
    }
    constrain(triangulation);
    triangulation.improve(support_);
    return inside(triangulation);
  }

 private:
  // In rounds of random points, each twice as large as all before and along a curve that fills the
  // plane: a search starts near its end, in a triangulation of which nothing is known (N. Amenta,
  // S. Choi, G. Rote, Incremental constructions con BRIO, 2003).
  void order_for_insertion(std::span<const Vec2> points) {
    std::mt19937 random(1);
    for (std::size_t i = corners_.size(); i > 1; --i) {
      std::swap(corners_[i - 1], corners_[random() % i]);
    }
    Vec2 low = points[corners_.front()], high = low;
    for (const std::uint32_t corner : corners_) {
      low = low.cwiseMin(points[corner]);
      high = high.cwiseMax(points[corner]);
    }
    const auto place = [&](std::uint32_t corner) {
      return interleaved(share(points[corner].x(), low.x(), high.x()),
                         share(points[corner].y(), low.y(), high.y()));
    };
    for (std::size_t end = corners_.size(); end > 1;) {
      const std::size_t begin = end / 3;
      std::ranges::sort(corners_.begin() + std::ptrdiff_t(begin),
                        corners_.begin() + std::ptrdiff_t(end), {},
                        [&](std::uint32_t corner) { return std::pair(place(corner), corner); });
      end = begin;
    }
  }

  // Of the way from low to high, in 2^-16.
  static std::uint32_t share(double x, double low, double high) {
    constexpr double kFinest = 65535;
    return high > low ? static_cast<std::uint32_t>((x - low) / (high - low) * kFinest) : 0;
  }

  static std::uint64_t interleaved(std::uint32_t x, std::uint32_t y) {
    std::uint64_t result = 0;
    for (int bit = 15; bit >= 0; --bit) {
      result = result << 2 | (x >> bit & 1U) << 1 | (y >> bit & 1U);
    }
    return result;
  }

  void refuse_coincident(std::span<const Vec2> points) const {
    std::vector<std::array<double, 2>> places;
    for (const std::uint32_t corner : corners_) {
      const Vec2& point = points[corner];
      if (!point.allFinite()) {
        throw Error(Errc::invalid_argument, "the corner of a region is not finite");
      }
      places.push_back({point.x(), point.y()});
    }
    std::ranges::sort(places);
    if (std::ranges::adjacent_find(places) != places.end()) {
      refuse_touching();
    }
  }

  // Every side by a number of its own: one that passes a corner would be there twice.
  void constrain(ConstrainedTriangulation& triangulation) const {
    std::uint32_t sides = 0;
    for (const Polygon& polygon : polygons_) {
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::uint32_t to = polygon[(i + 1) % polygon.size()];
        triangulation.constrain(vertex_of_[polygon[i]], vertex_of_[to], sides++);
      }
    }
    std::size_t halves = 0;
    for (const auto& face : triangulation.faces()) {
      halves += std::size_t(std::ranges::count_if(face.slots, [](auto s) { return s != kNone; }));
    }
    if (halves != 2 * std::size_t{sides}) {
      refuse_touching();
    }
  }

  // From the outside in.
  [[nodiscard]] std::vector<Triangle> inside(const ConstrainedTriangulation& triangulation) const {
    enum class Side : std::uint8_t { unknown, outside, inside };
    const auto& faces = triangulation.faces();
    std::vector<Side> side(faces.size(), Side::unknown);
    std::vector<std::uint32_t> open{triangulation.face_at_frame()};
    side[open.front()] = Side::outside;
    std::vector<Triangle> result;
    while (!open.empty()) {
      const std::uint32_t face = open.back();
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t next = faces[face].neighbours.at(i);
        if (next != kNone && side[next] == Side::unknown) {
          const bool crosses = faces[face].slots.at(i) != kNone;
          side[next] = (side[face] == Side::inside) != crosses ? Side::inside : Side::outside;
          open.push_back(next);
        }
      }
      if (side[face] == Side::inside) {
        Triangle corners{};
        std::ranges::transform(faces[face].corners, corners.begin(),
                               [&](auto v) { return corners_[triangulation.point(v)]; });
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        result.push_back(corners);
      }
    }
    std::ranges::sort(result);
    return result;
  }

  std::span<const Polygon> polygons_;
  std::vector<std::uint32_t> corners_;  // by their ids in the table
  std::vector<std::uint32_t> vertex_of_;
  arrangement::PointTable table_;
  Triangle support_{};
};

}  // namespace

std::vector<Triangle> triangulate_region(std::span<const Vec2> points,
                                         std::span<const std::vector<std::uint32_t>> polygons,
                                         std::span<const std::uint32_t> inner) {
  require_points(inner, points.size());
  for (const Polygon& polygon : polygons) {
    require_points(polygon, points.size());
  }
  if (polygons.empty()) {
    return {};
  }
  return Region(points, polygons, inner).triangles();
}

}  // namespace dupin
