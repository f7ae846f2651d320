#include "avoidance/polyline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include <Eigen/Geometry>

#include "avoidance/clearance.h"

namespace dupin::avoidance {
namespace {

// By the larger radius: how far the first and last corners are from the ends, and the radii of
// elbows that are tried.
constexpr double kLead = 3;
constexpr std::array kBends{3.0, 2.0, 1.5, 1.2};
constexpr int kMostAlong = 40;  // points of the lattice along an axis

// Of the obstacle, or what its boxes hold, to the point: whether it is less than that.
bool is_near(const Obstacle& shape, const std::vector<ObstacleBox>& parts, const Vec3& point,
             double wanted) {
  if ((point - nearest_core_point(shape, point)).norm() >= wanted + shape.radius) {
    return false;
  }
  return parts.empty() || std::ranges::any_of(parts, [&](const ObstacleBox& part) {
           return is_near(part.shape, part.parts, point, wanted);
         });
}

RingedSurface straight(const Vec3& from, const Vec3& to, double start, double end) {
  const Vec3 along = (to - from).normalized();
  RingedSurface result{{from, -along, start}, {to, along, end}, LineSpine{from, to}, {}};
  if (start == end) {
    result.radius = ConstantRadius{start};
  } else {
    result.radius = CubicRadius{start, end};
  }
  return result;
}

class Planner {
 public:
  Planner(const Ring& from, const Ring& to, std::span<const NamedObstacle> obstacles,
          double clearance)
      : from_(from),
        to_(to),
        obstacles_(obstacles),
        clearance_(clearance),
        radius_(std::max(from.radius, to.radius)) {}

  std::optional<std::vector<RingedSurface>> run() {
    first_ = from_.center + kLead * radius_ * from_.normal;
    last_ = to_.center + kLead * radius_ * to_.normal;
    lay_out();
    const std::vector<Vec3> found = path();
    if (found.empty()) {
      return std::nullopt;
    }
    const std::vector<Vec3> corners = straightened(found);
    for (const double bend : kBends) {
      if (auto pipe = rounded(corners, bend * radius_);
          pipe &&
          !prove_clearance(std::vector<Piece>(pipe->begin(), pipe->end()), obstacles_, clearance_)
               .spot) {
        return pipe;
      }
    }
    return std::nullopt;
  }

 private:
  using Cell = std::array<int, 3>;

  void lay_out() {
    Eigen::AlignedBox3d box(first_);
    box.extend(last_);
    for (const NamedObstacle& obstacle : obstacles_) {
      extend(box, obstacle.shape);
    }
    const double beyond = 2 * (radius_ + clearance_);
    low_ = box.min() - Vec3::Constant(beyond);
    const Vec3 size = box.sizes() + Vec3::Constant(2 * beyond);
    step_ = std::max(radius_ + clearance_, size.maxCoeff() / kMostAlong);
    for (int k = 0; k < 3; ++k) {
      counts_.at(std::size_t(k)) = int(std::ceil(size[k] / step_)) + 1;
    }
  }

  // No further than it matters: what is large is passed at its end nearest to the ports.
  void extend(Eigen::AlignedBox3d& box, const Obstacle& shape) const {
    const double reach = 4 * (last_ - first_).norm() + 8 * radius_;
    const Vec3 middle = (first_ + last_) / 2;
    for (std::size_t i = 0; i < std::size_t(1) << shape.edges.size(); ++i) {
      Vec3 corner = shape.corner;
      for (std::size_t k = 0; k < shape.edges.size(); ++k) {
        corner += ((i >> k) & 1U) != 0 ? shape.edges[k] : Vec3(0, 0, 0);
      }
      for (const double side : {-1.0, 1.0}) {
        const Vec3 off =
            corner + Vec3::Constant(side * (shape.radius + radius_ + clearance_)) - middle;
        box.extend(middle + off.cwiseMax(Vec3::Constant(-reach)).cwiseMin(Vec3::Constant(reach)));
      }
    }
  }

  [[nodiscard]] Vec3 place(const Cell& cell) const {
    return low_ + step_ * Vec3(cell[0], cell[1], cell[2]);
  }

  [[nodiscard]] std::size_t index(const Cell& cell) const {
    return (std::size_t(cell[2]) * std::size_t(counts_[1]) + std::size_t(cell[1])) *
               std::size_t(counts_[0]) +
           std::size_t(cell[0]);
  }

  [[nodiscard]] bool is_free(const Vec3& point) const {
    return std::ranges::none_of(obstacles_, [&](const NamedObstacle& obstacle) {
      return is_near(obstacle.shape, obstacle.parts, point, radius_ + clearance_);
    });
  }

  [[nodiscard]] bool is_clear(const Vec3& a, const Vec3& b) const {
    if (!((b - a).norm() > 0)) {
      return true;
    }
    const std::vector<Piece> pipe{straight(a, b, radius_, radius_)};
    return !prove_clearance(pipe, obstacles_, clearance_).spot;
  }

  [[nodiscard]] Cell nearest(const Vec3& point) const {
    Cell result{};
    for (int k = 0; k < 3; ++k) {
      result.at(std::size_t(k)) = std::clamp(int(std::lround((point[k] - low_[k]) / step_)), 0,
                                             counts_.at(std::size_t(k)) - 1);
    }
    return result;
  }

  // The free lattice points about a corner that can be reached from it.
  [[nodiscard]] std::vector<Cell> around(const Vec3& corner) const {
    std::vector<Cell> result;
    const Cell middle = nearest(corner);
    for (int i = 0; i < 27; ++i) {
      const Cell cell{middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1};
      if (is_inside(cell) && is_free(place(cell)) && is_clear(corner, place(cell))) {
        result.push_back(cell);
      }
    }
    return result;
  }

  [[nodiscard]] bool is_inside(const Cell& cell) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell.at(k) < 0 || cell.at(k) >= counts_.at(k)) {
        return false;
      }
    }
    return true;
  }

  // A* from corner to corner; the places between them.
  [[nodiscard]] std::vector<Vec3> path() const {
    struct Open {
      double cost;
      std::size_t number;
      Cell cell;
      bool operator<(const Open& other) const {
        return cost != other.cost ? cost > other.cost : number > other.number;
      }
    };
    const std::size_t count = index({counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}) + 1;
    std::vector<double> best(count, std::numeric_limits<double>::infinity());
    std::vector<int> came(count, -1);          // by which step
    std::vector<signed char> free(count, -1);  // not known yet
    std::priority_queue<Open> open;
    std::size_t number = 0;
    for (const Cell& cell : around(first_)) {
      best[index(cell)] = (place(cell) - first_).norm();
      open.push({best[index(cell)] + (last_ - place(cell)).norm(), number++, cell});
    }
    const std::vector<Cell> goals = around(last_);
    while (!open.empty()) {
      const Cell cell = open.top().cell;
      const double cost = open.top().cost;
      open.pop();
      if (cost > best[index(cell)] + (last_ - place(cell)).norm()) {
        continue;
      }
      if (std::ranges::count(goals, cell) > 0) {
        return traced(cell, came);
      }
      for (int step = 0; step < 6; ++step) {
        Cell next = cell;
        next.at(std::size_t(step / 2)) += step % 2 == 0 ? 1 : -1;
        if (!is_inside(next)) {
          continue;
        }
        const std::size_t at = index(next);
        if (free[at] < 0) {
          free[at] = is_free(place(next)) ? 1 : 0;
        }
        const double so_far = best[index(cell)] + step_;
        if (free[at] == 1 && so_far < best[at] && is_clear(place(cell), place(next))) {
          best[at] = so_far;
          came[at] = step;
          open.push({so_far + (last_ - place(next)).norm(), number++, next});
        }
      }
    }
    return {};
  }

  [[nodiscard]] std::vector<Vec3> traced(Cell cell, const std::vector<int>& came) const {
    std::vector<Vec3> result{last_, place(cell)};
    for (int step = came[index(cell)]; step >= 0; step = came[index(cell)]) {
      cell.at(std::size_t(step / 2)) -= step % 2 == 0 ? 1 : -1;
      result.push_back(place(cell));
    }
    result.push_back(first_);
    std::ranges::reverse(result);
    return result;
  }

  // From each corner straight to the last one that it sees, if the turn there leaves room for an
  // elbow.
  [[nodiscard]] std::vector<Vec3> straightened(const std::vector<Vec3>& path) const {
    std::vector<Vec3> result{from_.center, path.front()};
    for (std::size_t i = 0; i + 1 < path.size();) {
      std::size_t next = path.size() - 1;
      while (next > i + 1 && !(is_clear(path[i], path[next]) && turns_well(result, path[next]))) {
        --next;
      }
      if ((path[next] - result.back()).norm() > 0) {
        result.push_back(path[next]);
      }
      i = next;
    }
    result.push_back(to_.center);
    return result;
  }

  [[nodiscard]] static bool turns_well(const std::vector<Vec3>& way, const Vec3& next) {
    const Vec3 before = (way.back() - way[way.size() - 2]).normalized(),
               after = (next - way.back()).normalized();
    return before.dot(after) > -0.1;
  }

  // Corners rounded by elbows of at most this radius that leave room for each other.
  [[nodiscard]] std::optional<std::vector<RingedSurface>> rounded(const std::vector<Vec3>& way,
                                                                  double bend) const {
    std::vector<Elbow> elbows;
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
      const Vec3 in = way[i] - way[i - 1], out = way[i + 1] - way[i];
      const Vec3 u = in.normalized(), v = out.normalized();
      const double turn = std::atan2(u.cross(v).norm(), u.dot(v));
      if (turn < 1e-9) {
        continue;
      }
      const bool is_first = i == 1, is_last = i + 2 == way.size();
      const double room =
          0.98 * std::min(in.norm() / (is_first ? 1 : 2), out.norm() / (is_last ? 1 : 2));
      const double tangent = std::tan(turn / 2), radius = std::min(bend, room / tangent);
      if (!(radius > 1.05 * radius_)) {
        return std::nullopt;
      }
      elbows.push_back({way[i], u, v, turn, radius, radius * tangent});
    }
    return pieces(elbows);
  }

  struct Elbow {
    Vec3 corner, in, out;
    double turn, radius, leg;
  };

  [[nodiscard]] std::optional<std::vector<RingedSurface>> pieces(
      const std::vector<Elbow>& elbows) const {
    std::vector<std::array<Vec3, 2>> legs;
    Vec3 at = from_.center;
    for (const Elbow& elbow : elbows) {
      legs.push_back({at, elbow.corner - elbow.leg * elbow.in});
      at = elbow.corner + elbow.leg * elbow.out;
    }
    legs.push_back({at, to_.center});
    const auto longest = std::ranges::max_element(
        legs, {}, [](const auto& leg) { return (leg[1] - leg[0]).norm(); });
    const auto widening = std::size_t(longest - legs.begin());
    std::vector<RingedSurface> result;
    double radius = from_.radius;
    for (std::size_t i = 0; i < legs.size(); ++i) {
      const double next = i == widening ? to_.radius : radius;
      result.push_back(straight(legs[i][0], legs[i][1], radius, next));
      radius = next;
      if (i < elbows.size()) {
        result.push_back(elbow_piece(elbows[i], radius));
      }
    }
    return joined(std::move(result));
  }

  [[nodiscard]] static RingedSurface elbow_piece(const Elbow& e, double radius) {
    const Vec3 axis = e.in.cross(e.out).normalized(), inward = axis.cross(e.in);
    const Vec3 start = e.corner - e.leg * e.in, end = e.corner + e.leg * e.out;
    const Vec3 center = start + e.radius * inward;
    return {{start, -e.in, radius},
            {end, e.out, radius},
            ArcSpine{center, axis, start, e.turn},
            ConstantRadius{radius}};
  }

  // Rings of neighbours are the same, bitwise, and those of the ends are theirs.
  [[nodiscard]] std::vector<RingedSurface> joined(std::vector<RingedSurface> pipe) const {
    pipe.front().start = flipped(from_);
    for (std::size_t i = 0; i + 1 < pipe.size(); ++i) {
      pipe[i + 1].start = flipped(pipe[i].end);
    }
    pipe.back().end = flipped(to_);
    return pipe;
  }

  const Ring &from_, &to_;
  std::span<const NamedObstacle> obstacles_;
  double clearance_, radius_, step_ = 1;
  Vec3 first_, last_, low_;
  std::array<int, 3> counts_{};
};

}  // namespace

std::optional<std::vector<RingedSurface>> polyline_pipe(const Ring& from, const Ring& to,
                                                        std::span<const NamedObstacle> obstacles,
                                                        double clearance) {
  return Planner(from, to, obstacles, clearance).run();
}

}  // namespace dupin::avoidance
