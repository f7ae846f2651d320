#include "junction/hub_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <unordered_map>

#include <Eigen/Geometry>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/triangulate_region.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin::junction {
namespace {

// A cap of the hub and its polygon.
struct Cap {
  Vec3 axis;
  double angle = 0;
  double step = 1;  // length of the polygon's sides
  double sagitta = 0;
};

// The stereographic chart from the middle of a cap: seen from outside, and that cap outermost.
class Chart {
 public:
  explicit Chart(const Vec3& pole) : pole_(pole) {
    int smallest = 0;
    pole.cwiseAbs().minCoeff(&smallest);
    first_ = Vec3::Unit(smallest).cross(pole).normalized();
    second_ = first_.cross(pole);
  }

  [[nodiscard]] Vec2 place(const Vec3& direction) const {
    const double over = 1 - direction.dot(pole_);
    return {direction.dot(first_) / over, direction.dot(second_) / over};
  }

 private:
  Vec3 pole_, first_, second_;
};

// Points in cells of a lattice, to tell whether one is near.
class Neighbourhood {
 public:
  explicit Neighbourhood(double cell) : cell_(cell) {}

  void add(const Vec3& p) { points_[key(cell_of(p))].push_back(p); }

  // Nearer than `distance`, at most a cell's length.
  [[nodiscard]] bool has_near(const Vec3& p, double distance) const {
    const Cell cell = cell_of(p);
    for (int i = 0; i < 27; ++i) {
      const auto found =
          points_.find(key({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1}));
      if (found != points_.end() && std::ranges::any_of(found->second, [&](const Vec3& q) {
            return (p - q).norm() < distance;
          })) {
        return true;
      }
    }
    return false;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  [[nodiscard]] Cell cell_of(const Vec3& p) const {
    Cell cell{};
    std::ranges::transform(p, cell.begin(),
                           [this](double x) { return std::int64_t(std::floor(x / cell_)); });
    return cell;
  }

  // Cells may share one.
  static std::uint64_t key(const Cell& cell) {
    std::uint64_t result = 0;
    for (const std::int64_t x : cell) {
      result = result * 2097143 + std::uint64_t(x);
    }
    return result;
  }

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<Vec3>> points_;
};

// The circle about a triangle's corners.
struct Circle {
  Vec3 center;
  double radius = 0;
};

class HubMesher {
 public:
  HubMesher(const Junction& junction, std::span<const std::vector<Vec3>> circles,
            const HubSampling& sampling)
      : hub_(junction.hub),
        sampling_(sampling),
        displacement_(
            tessellation::point_error(hub_.center.norm() + 2 * hub_.radius, sampling.grid)),
        allowed_(tessellation::allowed_error(sampling.tolerance, displacement_)),
        largest_(
            std::min(kLargest * hub_.radius, std::sqrt(allowed_ * (2 * hub_.radius - allowed_)))),
        chart_(widest_cap(junction)),
        neighbourhood_(largest_) {
    for (std::size_t i = 0; i < circles.size(); ++i) {
      append_cap(junction.arms[i], circles[i]);
    }
    for (const Vec3& point : mesh().points) {
      places_.push_back(chart_.place((point - hub_.center).normalized()));
      neighbourhood_.add(point);
    }
  }

  Tessellation run() {
    constexpr int kRounds = 100;
    refuse_too_fine();
    triangulate([&] { region_.emplace(places_, polygons_); });
    for (int i = 0; i < kRounds; ++i) {
      const std::size_t before = places_.size();
      if (!add_points()) {
        break;
      }
      triangulate([&] { region_->add(std::span(places_).subspan(before)); });
    }
    refuse_inside_out();
    result_.bands = 1;
    result_.error_bound = error();
    return std::move(result_);
  }

 private:
  // By the hub's radius: the largest circle about a triangle.
  static constexpr double kLargest = 0.3;
  // By the sides of a cap's polygon: the largest circle about a triangle at the cap, by which part
  // of the distance from there it grows, and how near points may come.
  static constexpr double kAtCap = 0.75, kGrowth = 0.4, kNearest = 0.4;

  static Vec3 widest_cap(const Junction& junction) {
    const auto widest =
        std::ranges::max_element(junction.arms, {}, [](const auto& arm) { return cap_angle(arm); });
    return -cap_circle(*widest).normal;
  }

  TriMesh& mesh() { return result_.mesh; }
  [[nodiscard]] const TriMesh& mesh() const { return result_.mesh; }

  void append_cap(const JunctionArm& arm, const std::vector<Vec3>& polygon) {
    const Ring circle = cap_circle(arm);
    const double half = std::numbers::pi / double(polygon.size()), sine = std::sin(half / 2);
    caps_.push_back({-circle.normal, cap_angle(arm), 2 * circle.radius * std::sin(half),
                     2 * circle.radius * sine * sine});
    auto& corners = polygons_.emplace_back(polygon.size());
    std::iota(corners.begin(), corners.end(), std::uint32_t(mesh().points.size()));
    mesh().points.insert(mesh().points.end(), polygon.begin(), polygon.end());
    cap_of_.insert(cap_of_.end(), polygon.size(), caps_.size() - 1);
  }

  void triangulate(const auto& step) {
    try {
      step();
      mesh().triangles = region_->triangles();
    } catch (const Error& error) {
      if (error.code() != Errc::self_intersecting) {
        throw;
      }
      refuse_polygons();
    }
    refuse_too_many(double(mesh().triangles.size()));
  }

  // As many of the largest size as there is room for; half of them, as triangles may be flatter.
  void refuse_too_fine() const {
    double share = 1;
    for (const Cap& cap : caps_) {
      share -= (1 - std::cos(cap.angle)) / 2;
    }
    const double sphere = 4 * std::numbers::pi * hub_.radius * hub_.radius;
    const double equilateral = 3 * std::numbers::sqrt3 / 4 * largest_ * largest_;
    refuse_too_many(share * sphere / equilateral / 2);
  }

  void refuse_too_many(double triangles) const {
    if (triangles > double(sampling_.most_triangles)) {
      throw Error(Errc::limit_exceeded,
                  "a tolerance of " + decimal(sampling_.tolerance, kMessageDigits) +
                      " asks for more than " +
                      tessellation::count_text(double(sampling_.most_triangles)) +
                      " triangles for this hub alone; use a larger one, or a higher limit");
    }
  }

  [[noreturn]] static void refuse_polygons() {
    throw Error(Errc::infeasible_blend,
                "the polygons of the hub's caps touch; use a smaller tolerance, more segments, or "
                "smaller caps");
  }

  // Convex from the centre, triangles that are counter-clockwise from there do not cross.
  void refuse_inside_out() const {
    for (const Triangle& t : mesh().triangles) {
      const Vec3 a = arm(t[0]), b = arm(t[1]), c = arm(t[2]);
      if (!(a.dot(b.cross(c)) > 0)) {
        refuse_polygons();
      }
    }
  }

  [[nodiscard]] Vec3 arm(std::uint32_t corner) const { return mesh().points[corner] - hub_.center; }

  [[nodiscard]] bool is_side_of_cap(std::uint32_t a, std::uint32_t b) const {
    if (a >= cap_of_.size() || b >= cap_of_.size() || cap_of_[a] != cap_of_[b]) {
      return false;
    }
    const auto& polygon = polygons_[cap_of_[a]];
    const std::uint32_t apart = a > b ? a - b : b - a;
    return apart == 1 || apart + 1 == polygon.size();
  }

  // Along the sphere, negative within a cap.
  [[nodiscard]] double distance_to(const Cap& cap, const Vec3& direction) const {
    return hub_.radius *
           (std::atan2(cap.axis.cross(direction).norm(), cap.axis.dot(direction)) - cap.angle);
  }

  // How large the circle about a triangle may be here.
  [[nodiscard]] double size_at(const Vec3& direction) const {
    double size = largest_;
    for (const Cap& cap : caps_) {
      const double distance = std::max(0.0, distance_to(cap, direction));
      size = std::min(size, kAtCap * cap.step + kGrowth * distance);
    }
    return size;
  }

  [[nodiscard]] bool has_room(const Vec3& direction, double share) const {
    return std::ranges::all_of(caps_, [&](const Cap& cap) {
      return distance_to(cap, direction) > share * std::min(cap.step, largest_);
    });
  }

  [[nodiscard]] Circle circle_about(const Triangle& t) const {
    const Vec3 a = arm(t[0]), u = arm(t[1]) - a, v = arm(t[2]) - a, normal = u.cross(v);
    const Vec3 to_center = (u.squaredNorm() * v.cross(normal) + v.squaredNorm() * normal.cross(u)) /
                           (2 * normal.squaredNorm());
    return {a + to_center, to_center.norm()};
  }

  // How far the triangle's points lie inside the sphere.
  [[nodiscard]] double depth(const Triangle& t) const {
    double nearest = std::numeric_limits<double>::infinity();
    const Vec3 a = arm(t[0]), b = arm(t[1]), c = arm(t[2]);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const Vec3 side = to - from;
      const double share = std::clamp(-from.dot(side) / side.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (from + share * side).norm());
    }
    const Vec3 normal = (b - a).cross(c - a).normalized(), foot = a.dot(normal) * normal;
    const auto is_left = [&](const Vec3& from, const Vec3& to) {
      return (to - from).cross(foot - from).dot(normal) >= 0;
    };
    if (is_left(a, b) && is_left(b, c) && is_left(c, a)) {
      nearest = std::min(nearest, foot.norm());
    }
    return hub_.radius - nearest;
  }

  // A point that a triangle asks for, and how much.
  struct Wish {
    double urgency = 0;
    Vec3 direction;
    double clear = 0;  // of other points
  };

  [[nodiscard]] std::optional<Wish> wish(const Triangle& t) const {
    const Circle circle = circle_about(t);
    const bool too_deep = depth(t) > allowed_;
    const Vec3 middle = circle.center.normalized();
    const double size = size_at(middle);
    const double urgency = std::max(circle.radius / size, too_deep ? 1.1 : 0);
    if (!(urgency > 1)) {
      return {};
    }
    if (has_room(middle, too_deep ? kNearest / 2 : kNearest)) {
      return Wish{urgency, middle, 0.9 * std::min(circle.radius, size)};
    }
    // Halved where it does not belong to a cap.
    std::optional<Wish> result;
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t.at(i), to = t.at((i + 1) % 3);
      const double length = (arm(from) - arm(to)).norm();
      const Vec3 half = (arm(from) + arm(to)).normalized();
      if (length > longest && length > 2 * size_at(half) && !is_side_of_cap(from, to) &&
          has_room(half, kNearest)) {
        longest = length;
        result = Wish{urgency, half, 0.7 * size_at(half)};
      }
    }
    return result;
  }

  // Those that triangles ask for, most urgently first, where there is room beside the others.
  bool add_points() {
    std::vector<Wish> wishes;
    for (const Triangle& t : mesh().triangles) {
      if (auto wished = wish(t)) {
        wishes.push_back(*wished);
      }
    }
    std::ranges::stable_sort(wishes, std::ranges::greater(), &Wish::urgency);
    bool has_added = false;
    for (const Wish& wished : wishes) {
      const Vec3 point = hub_.center + hub_.radius * wished.direction;
      if (!neighbourhood_.has_near(point, wished.clear)) {
        has_added = true;
        neighbourhood_.add(point);
        mesh().points.push_back(snapped(point, sampling_.grid));
        places_.push_back(chart_.place((mesh().points.back() - hub_.center).normalized()));
      }
    }
    return has_added;
  }

  // Between the circle of a cap and a side of its polygon the surface is a collar's. A point there
  // at the depth e is, seen from the centre, at most sagitta * cos(angle) within the circle, hence
  // at most the root of the squares' sum off it.
  [[nodiscard]] double error() const {
    double largest = 0;
    for (const Triangle& t : mesh().triangles) {
      double here = depth(t);
      for (std::size_t i = 0; i < 3; ++i) {
        if (is_side_of_cap(t.at(i), t.at((i + 1) % 3))) {
          const Cap& cap = caps_[cap_of_[t.at(i)]];
          here = std::max(here, std::hypot(depth(t), cap.sagitta * std::cos(cap.angle)));
        }
      }
      largest = std::max(largest, here);
    }
    return largest + displacement_;
  }

  const Sphere& hub_;
  const HubSampling& sampling_;
  double displacement_, allowed_, largest_;
  Chart chart_;
  Neighbourhood neighbourhood_;
  std::vector<Cap> caps_;
  std::vector<std::vector<std::uint32_t>> polygons_;
  std::vector<std::size_t> cap_of_;  // by point of a polygon
  std::vector<Vec2> places_;
  std::optional<RegionTriangulation> region_;
  Tessellation result_;
};

}  // namespace

Tessellation hub_mesh(const Junction& junction, std::span<const std::vector<Vec3>> circles,
                      const HubSampling& sampling) {
  return HubMesher(junction, circles, sampling).run();
}

}  // namespace dupin::junction
