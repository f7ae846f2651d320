#include "tessellation/refined_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>

#include "dupin/kernel/triangulate_region.h"
#include "tessellation/plane_segments.h"

namespace dupin::tessellation {
namespace {

struct Side {
  Vec2 from, to;
};

double squared_distance(const Side& side, const Vec2& p) {
  const Vec2 along = side.to - side.from;
  const double share = std::clamp((p - side.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - side.from - share * along).squaredNorm();
}

// Whether the side is seen from there under more than 120 degrees.
bool is_wide_from(const Side& side, const Vec2& p) {
  const Vec2 a = side.from - p, b = side.to - p;
  return a.dot(b) < -0.5 * a.norm() * b.norm();
}

// Things by the cells of a lattice that they lie in.
template <class Thing>
class Cells {
 public:
  explicit Cells(double size) : size_(size) {}

  void add(const Vec2& low, const Vec2& high, const Thing& thing) {
    for (std::int64_t i = index(low.x()); i <= index(high.x()); ++i) {
      for (std::int64_t j = index(low.y()); j <= index(high.y()); ++j) {
        things_[key(i, j)].push_back(thing);
      }
    }
  }

  // Of all in the cells that this rectangle meets, and some others.
  template <class Test>
  [[nodiscard]] bool any(const Vec2& low, const Vec2& high, const Test& test) const {
    for (std::int64_t i = index(low.x()); i <= index(high.x()); ++i) {
      for (std::int64_t j = index(low.y()); j <= index(high.y()); ++j) {
        const auto found = things_.find(key(i, j));
        if (found != things_.end() && std::ranges::any_of(found->second, test)) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  [[nodiscard]] std::int64_t index(double x) const { return std::int64_t(std::floor(x / size_)); }
  static std::uint64_t key(std::int64_t i, std::int64_t j) {
    return std::uint64_t(i) * 2654435761U + std::uint64_t(j);
  }

  double size_;
  std::unordered_map<std::uint64_t, std::vector<Thing>> things_;
};

// A triangle that is to vanish, by the centre of the circle about it.
struct Fault {
  double shortest = 0;
  Vec2 inner;  // a point of it
  Vec2 center;
  double radius = 0;
};

class Refiner {
 public:
  Refiner(std::vector<Vec2> points, const std::vector<std::vector<std::uint32_t>>& polygons,
          const Refinement& refinement)
      : polygons_(polygons),
        refinement_(refinement),
        given_(points.size()),
        points_(std::move(points)),
        sides_(refinement.spacing),
        columns_(refinement.spacing) {
    for (const auto& polygon : polygons_) {
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Side side{points_[polygon[i]], points_[polygon[(i + 1) % polygon.size()]]};
        const Vec2 low = side.from.cwiseMin(side.to), high = side.from.cwiseMax(side.to);
        sides_.add(low, high, side);
        columns_.add({low.x(), 0}, {high.x(), 0}, side);
        longest_ = std::max(longest_, (side.to - side.from).norm());
        all_sides_.push_back(side);
        given_edges_.insert(std::minmax(polygon[i], polygon[(i + 1) % polygon.size()]));
      }
    }
  }

  RefinedRegion run() {
    constexpr int kRounds = 40;
    fill();
    std::vector<std::uint32_t> inner(points_.size() - given_);
    std::iota(inner.begin(), inner.end(), std::uint32_t(given_));
    RegionTriangulation region(points_, polygons_, inner);
    auto triangles = region.triangles();
    const auto rounds = [&](const auto& added) {
      for (int i = 0; i < kRounds; ++i) {
        const std::size_t before = points_.size();
        if (!added(triangles)) {
          return;
        }
        region.add(std::span(points_).subspan(before));
        triangles = region.triangles();
      }
    };
    rounds([&](const auto& all) { return add_centers(all); });
    rounds([&](const auto& all) { return divide_wide(all); });
    return {std::move(points_), std::move(triangles)};
  }

 private:
  // In [-1, 1], the same for all shapes.
  double random() { return 2 * double(engine_()) / double(std::mt19937::max()) - 1; }

  static constexpr double kJitter = 0.04;
  static constexpr double kSquaredRatio = 1.4;  // of circumradius and shortest side: 25 degrees

  // Rows of an equilateral lattice, between every other two crossings with sides.
  void fill() {
    if (all_sides_.empty()) {
      return;
    }
    Vec2 low = all_sides_.front().from, high = low;
    for (const Side& side : all_sides_) {
      low = low.cwiseMin(side.from);
      high = high.cwiseMax(side.from);
    }
    const double step = refinement_.spacing, rise = step * std::numbers::sqrt3 / 2;
    const auto rows = std::int64_t((high.y() - low.y()) / rise);
    // Evenly between the lowest and the highest corner.
    const double first = (high.y() - low.y() - double(rows - 1) * rise) / 2;
    std::vector<std::vector<double>> crossings(std::size_t(std::max<std::int64_t>(rows, 0)));
    const auto height = [&](std::int64_t row) { return low.y() + first + double(row) * rise; };
    for (const Side& side : all_sides_) {
      const auto [under, over] = std::minmax(side.from.y(), side.to.y());
      const auto begin = std::int64_t(std::floor((under - low.y() - first) / rise));
      for (std::int64_t row = std::max<std::int64_t>(begin, 0); row < rows && height(row) <= over;
           ++row) {
        const double y = height(row);
        if ((side.from.y() <= y) != (side.to.y() <= y)) {
          const double share = (y - side.from.y()) / (side.to.y() - side.from.y());
          crossings[std::size_t(row)].push_back(side.from.x() +
                                                share * (side.to.x() - side.from.x()));
        }
      }
    }
    for (std::int64_t row = 0; row < rows; ++row) {
      auto& at = crossings[std::size_t(row)];
      std::ranges::sort(at);
      for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
        fill_row(at[i], at[i + 1], height(row), row % 2 == 0 ? 0 : step / 2);
      }
    }
  }

  // Not quite where the lattice is: of points on one line or circle doubles cannot tell which
  // triangles are better.
  void fill_row(double from, double to, double y, double offset) {
    const double step = refinement_.spacing;
    for (double n = std::ceil((from - offset) / step); n * step + offset < to; ++n) {
      const Vec2 p = Vec2(n * step + offset, y) + kJitter * step * Vec2(random(), random());
      const Vec2 reach = Vec2::Constant(kFree * step);
      if (!sides_.any(p - reach, p + reach, [&](const Side& side) {
            return squared_distance(side, p) < kFree * kFree * step * step;
          })) {
        points_.push_back(p);
      }
    }
  }

  // Those of faulty triangles, the smallest first, unless they are inside of a circle whose centre
  // was added before them.
  bool add_centers(const std::vector<Triangle>& triangles) {
    std::vector<Fault> faults;
    for (const Triangle& triangle : triangles) {
      append_if_faulty(triangle, faults);
    }
    std::ranges::stable_sort(faults, {}, &Fault::shortest);
    Cells<Vec2> added(refinement_.spacing);
    const std::size_t before = points_.size();
    for (const Fault& fault : faults) {
      const Vec2 reach = Vec2::Constant(fault.radius), &p = fault.center;
      const auto is_inside = [&](const Vec2& other) {
        return (other - p).squaredNorm() < fault.radius * fault.radius;
      };
      if (!added.any(p - reach, p + reach, is_inside) && is_free(p) && sees(fault.inner, p)) {
        added.add(p, p, p);
        points_.push_back(p);
      }
    }
    return points_.size() > before;
  }

  [[nodiscard]] double width(std::uint32_t a, std::uint32_t b) const {
    return std::abs(points_[a].x() - points_[b].x());
  }

  // Triangles that are too wide beside a side, where no centre is free, are so because of an edge
  // between corners of polygons: its middle is added, whatever angles it makes.
  bool divide_wide(const std::vector<Triangle>& triangles) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Triangle& triangle : triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(triangle.at(i), triangle.at((i + 1) % 3));
        if (width(a, b) > refinement_.widest * (1 + kRounding) && !given_edges_.contains({a, b})) {
          edges.insert({a, b});
        }
      }
    }
    for (const auto& [a, b] : edges) {
      points_.push_back((points_[a] + points_[b]) / 2);
    }
    return !edges.empty();
  }

  void append_if_faulty(const Triangle& triangle, std::vector<Fault>& faults) const {
    const Vec2 &a = points_[triangle[0]], &b = points_[triangle[1]], &c = points_[triangle[2]];
    const Vec2 ab = b - a, ac = c - a;
    const double shortest = std::min({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
    const double doubled = cross(ab, ac);
    if (!(doubled > 0)) {
      return;
    }
    const Vec2 to_center = Vec2(ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm(),
                                ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm()) /
                           (2 * doubled);
    const double squared_radius = to_center.squaredNorm();
    const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
    const bool is_wide = right - left > refinement_.widest * (1 + kRounding);
    // What is larger than this has its centre beyond a side.
    const bool is_told = squared_radius < kLargest * kLargest;
    if (is_told && (is_wide || squared_radius > kSquaredRatio * shortest)) {
      faults.push_back(
          {std::sqrt(shortest), (a + b + c) / 3, a + to_center, std::sqrt(squared_radius)});
    }
  }

  // Inside, and not so near a side that it makes a small angle with it.
  [[nodiscard]] bool is_free(const Vec2& p) const {
    const Vec2 reach = Vec2::Constant(0.3 * longest_);
    return is_inside(p) && !sides_.any(p - reach, p + reach,
                                       [&](const Side& side) { return is_wide_from(side, p); });
  }

  // Beyond a side a centre would leave the triangle as it is, and be added again.
  [[nodiscard]] bool sees(const Vec2& from, const Vec2& to) const {
    return !sides_.any(from.cwiseMin(to), from.cwiseMax(to), [&](const Side& side) {
      return cross_inside(from, to, side.from, side.to);
    });
  }

  [[nodiscard]] bool is_inside(const Vec2& p) const {
    bool inside = false;
    (void)columns_.any({p.x(), 0}, {p.x(), 0}, [&](const Side& side) {
      if ((side.from.x() <= p.x()) != (side.to.x() <= p.x())) {
        const double share = (p.x() - side.from.x()) / (side.to.x() - side.from.x());
        inside ^= side.from.y() + share * (side.to.y() - side.from.y()) < p.y();
      }
      return false;
    });
    return inside;
  }

  static constexpr double kFree = 0.55;      // of the lattice's spacing, around its points
  static constexpr double kLargest = 4;      // of the circles
  static constexpr double kRounding = 1e-9;  // of a width
  const std::vector<std::vector<std::uint32_t>>& polygons_;
  Refinement refinement_;
  std::size_t given_;
  std::vector<Vec2> points_;
  Cells<Side> sides_, columns_;
  std::vector<Side> all_sides_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> given_edges_;
  double longest_ = 0;
  std::mt19937 engine_{1};
};

}  // namespace

RefinedRegion refined_region(std::vector<Vec2> points,
                             const std::vector<std::vector<std::uint32_t>>& polygons,
                             const Refinement& refinement) {
  return Refiner(std::move(points), polygons, refinement).run();
}

}  // namespace dupin::tessellation
