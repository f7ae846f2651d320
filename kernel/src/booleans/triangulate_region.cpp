#include "dupin/kernel/triangulate_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <numeric>
#include <random>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "arrangement/faces/constrained_triangulation.h"
#include "dupin/kernel/coordinates.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "support/sequences.h"

namespace dupin {
namespace {

using arrangement::ConstrainedTriangulation;
using arrangement::kNone;
using arrangement::PointId;
using Polygon = std::vector<std::uint32_t>;

[[noreturn]] void refuse_touching() {
  throw Error(Errc::self_intersecting,
              "the polygons that bound a region cross or touch each other or a point within");
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

// In [0, 1] of the way from low to high, in 2^-16.
std::uint32_t share(double x, double low, double high) {
  constexpr double kFinest = 65535;
  return high > low ? static_cast<std::uint32_t>((x - low) / (high - low) * kFinest) : 0;
}

std::uint64_t interleaved(std::uint32_t x, std::uint32_t y) {
  std::uint64_t result = 0;
  for (int bit = 15; bit >= 0; --bit) {
    result = result << 2 | (x >> bit & 1U) << 1 | (y >> bit & 1U);
  }
  return result;
}

// A corner by its place along a curve that fills the plane.
struct Keyed {
  std::uint64_t place;
  std::uint32_t corner;
  auto operator<=>(const Keyed&) const = default;
};

std::vector<Keyed> keyed(std::span<const Vec2> points, const Eigen::AlignedBox2d& box,
                         std::span<const std::uint32_t> corners) {
  std::vector<Keyed> result;
  result.reserve(corners.size());
  for (const std::uint32_t corner : corners) {
    const Vec2& point = points[corner];
    result.push_back({interleaved(share(point.x(), box.min().x(), box.max().x()),
                                  share(point.y(), box.min().y(), box.max().y())),
                      corner});
  }
  return result;
}

// In rounds of random points, each twice as large as all before and along the curve: a search
// starts near its end, in a triangulation of which nothing is known (N. Amenta, S. Choi, G. Rote,
// Incremental constructions con BRIO, 2003).
void order_for_insertion(std::vector<Keyed>& order) {
  std::mt19937 random(1);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[random() % i]);
  }
  for (std::size_t end = order.size(); end > 1;) {
    const std::size_t begin = end / 3;
    std::ranges::sort(order.begin() + std::ptrdiff_t(begin), order.begin() + std::ptrdiff_t(end));
    end = begin;
  }
}

// What refuses to make a point where sides cross, or a side where there are two.
ConstrainedTriangulation::Caller refusing() {
  return {[](std::uint32_t, std::uint32_t) -> arrangement::ImplicitPoint { refuse_touching(); },
          [](std::uint32_t, std::uint32_t) -> std::uint32_t { refuse_touching(); }};
}

}  // namespace

class RegionTriangulation::Region {
 public:
  Region(std::span<const Vec2> points, std::span<const Polygon> polygons,
         std::span<const std::uint32_t> inner)
      : given_(points.size()) {
    std::vector<std::uint32_t> corners;
    for (const Polygon& polygon : polygons) {
      if (polygon.size() < 3) {
        throw Error(Errc::invalid_argument, "a polygon needs at least three corners, not " +
                                                std::to_string(polygon.size()));
      }
      corners.insert(corners.end(), polygon.begin(), polygon.end());
    }
    support::sort_unique(corners);
    for (const std::uint32_t point : inner) {
      if (std::ranges::binary_search(corners, point)) {
        refuse_touching();
      }
    }
    corners.insert(corners.end(), inner.begin(), inner.end());
    support::sort_unique(corners);
    for (const std::uint32_t corner : corners) {
      note_place(points[corner]);
    }
    refuse_coincident(0);
    for (const std::uint32_t corner : corners) {
      box_.extend(points[corner]);
    }
    std::vector<Keyed> order = keyed(points, box_, corners);
    order_for_insertion(order);
    start(points, order);
    constrain(polygons);
  }

  void add(std::span<const Vec2> points) {
    const std::size_t before = places_.size();
    std::ranges::for_each(points, [&](const Vec2& point) { note_place(point); });
    refuse_coincident(before);
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (box_.contains(points[i])) {  // no other can lie within the region
        corners.push_back(i);
      }
    }
    std::vector<Keyed> order = keyed(points, box_, corners);
    std::ranges::sort(order);
    const arrangement::UpwardRounding rounding;
    for (const auto& [place, i] : order) {
      insert(append(points[i], std::uint32_t(given_ + i)));
    }
    given_ += points.size();
    refuse_broken_sides();
  }

  // From the outside in.
  [[nodiscard]] std::vector<Triangle> inside() const {
    enum class Side : std::uint8_t { unknown, outside, inside };
    const auto& faces = triangulation_.faces();
    std::vector<Side> side(faces.size(), Side::unknown);
    std::vector<std::uint32_t> open{triangulation_.face_at_frame()};
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
                               [&](auto v) { return corners_[triangulation_.point(v)]; });
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        result.push_back(corners);
      }
    }
    std::ranges::sort(result);
    return result;
  }

 private:
  using Place = std::array<double, 2>;

  PointId append(const Vec2& point, std::uint32_t corner) {
    corners_.push_back(corner);
    return table_.add(Vec3(point.x(), point.y(), 0));
  }

  ConstrainedTriangulation::Vertex insert(PointId id) {
    const ConstrainedTriangulation::Vertex vertex = triangulation_.add(id);
    triangulation_.insert(vertex);
    return vertex;
  }

  void start(std::span<const Vec2> points, std::span<const Keyed> order) {
    const arrangement::UpwardRounding rounding;
    std::vector<PointId> ids;
    ids.reserve(order.size());
    for (const auto& [place, corner] : order) {
      ids.push_back(append(points[corner], corner));
    }
    triangulation_.clear({2, 1});
    triangulation_.start_around(ids);
    vertex_of_.assign(points.size(), kNone);
    for (const PointId id : ids) {
      vertex_of_[corners_[id]] = insert(id);
    }
  }

  // Every side by a number of its own: one that passes a corner would be there twice.
  void constrain(std::span<const Polygon> polygons) {
    const arrangement::UpwardRounding rounding;
    for (const Polygon& polygon : polygons) {
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::uint32_t to = polygon[(i + 1) % polygon.size()];
        triangulation_.constrain(vertex_of_[polygon[i]], vertex_of_[to], sides_++);
      }
    }
    vertex_of_ = {};
    refuse_broken_sides();
    triangulation_.improve({append({0, 0}, kNone), append({1, 0}, kNone), append({0, 1}, kNone)});
  }

  void refuse_broken_sides() const {
    std::size_t halves = 0;
    for (const auto& face : triangulation_.faces()) {
      halves += std::size_t(std::ranges::count_if(face.slots, [](auto s) { return s != kNone; }));
    }
    if (halves != 2 * std::size_t{sides_}) {
      refuse_touching();
    }
  }

  void note_place(const Vec2& point) {
    for (const double x : point) {
      if (!(std::abs(x) <= kGreatestCoordinate)) {
        throw Error(Errc::invalid_argument,
                    "a point of a region has the coordinate " + decimal(x, kMessageDigits) +
                        ", which must be at most " + decimal(kGreatestCoordinate) + " in size");
      }
    }
    places_.push_back({point.x(), point.y()});
  }

  // Places from there on, with each other or with those before.
  void refuse_coincident(std::size_t from) {
    const auto first_new = places_.begin() + std::ptrdiff_t(from);
    std::ranges::sort(first_new, places_.end());
    std::ranges::inplace_merge(places_, first_new);
    if (const auto twice = std::ranges::adjacent_find(places_); twice != places_.end()) {
      throw Error(Errc::self_intersecting, "two points of a region lie at (" +
                                               decimal((*twice)[0], kPlaceDigits) + ", " +
                                               decimal((*twice)[1], kPlaceDigits) + ")");
    }
  }

  arrangement::PointTable table_;
  ConstrainedTriangulation triangulation_{table_, refusing()};
  std::vector<std::uint32_t> corners_;  // by their ids in the table
  std::vector<std::uint32_t> vertex_of_;
  std::vector<Place> places_;  // sorted
  Eigen::AlignedBox2d box_;
  std::size_t given_;  // points
  std::uint32_t sides_ = 0;
};

RegionTriangulation::RegionTriangulation(std::span<const Vec2> points,
                                         std::span<const Polygon> polygons,
                                         std::span<const std::uint32_t> inner) {
  require_points(inner, points.size());
  for (const Polygon& polygon : polygons) {
    require_points(polygon, points.size());
  }
  if (!polygons.empty()) {
    region_ = std::make_unique<Region>(points, polygons, inner);
  }
}

RegionTriangulation::~RegionTriangulation() = default;

void RegionTriangulation::add(std::span<const Vec2> points) {
  if (region_) {
    region_->add(points);
  }
}

std::vector<Triangle> RegionTriangulation::triangles() const {
  return region_ ? region_->inside() : std::vector<Triangle>();
}

std::vector<Triangle> triangulate_region(std::span<const Vec2> points,
                                         std::span<const Polygon> polygons,
                                         std::span<const std::uint32_t> inner) {
  return RegionTriangulation(points, polygons, inner).triangles();
}

}  // namespace dupin
