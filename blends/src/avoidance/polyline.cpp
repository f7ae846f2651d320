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
// Of an elbow's radius, what it cuts off at most from a corner that turns well: 1 / cos(48 degrees)
// - 1.
constexpr double kCut = 0.5;
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
    for (const double bend : kBends) {
      margin_ = kCut * bend * radius_;
      if (auto pipe = along(path(), bend)) {
        return pipe;
      }
    }
    margin_ = 0;  // where the corners happen to have room for their elbows
    const std::vector<Vec3> way = path();
    for (const double bend : kBends) {
      if (auto pipe = along(way, bend)) {
        return pipe;
      }
    }
    return std::nullopt;
  }

 private:
  using Cell = std::array<int, 3>;

  // Straightened if that can be proved, or else as it is.
  [[nodiscard]] std::optional<std::vector<RingedSurface>> along(const std::vector<Vec3>& path,
                                                                double bend) const {
    if (path.empty()) {
      return std::nullopt;
    }
    std::vector<Vec3> whole{from_.center};
    whole.insert(whole.end(), path.begin(), path.end());
    whole.push_back(to_.center);
    auto pipe = proved(straightened(path), bend);
    return pipe ? pipe : proved(whole, bend);
  }

  [[nodiscard]] std::optional<std::vector<RingedSurface>> proved(const std::vector<Vec3>& corners,
                                                                 double bend) const {
    auto pipe = rounded(corners, bend * radius_);
    if (pipe && prove_clearance(*pipe, obstacles_, clearance_).spot) {
      return std::nullopt;
    }
    return pipe;
  }

  void lay_out() {
    Eigen::AlignedBox3d box(first_);
    box.extend(last_);
    for (const NamedObstacle& obstacle : obstacles_) {
      extend(box, obstacle.shape);
    }
    const double beyond = 2 * (radius_ + clearance_);
    box.extend(Vec3(box.min() - Vec3::Constant(beyond)));
    box.extend(Vec3(box.max() + Vec3::Constant(beyond)));
    // Each step has room for two of the least elbows, at right angles.
    step_ = std::max(
        {radius_ + clearance_, 2 * kBends.back() * radius_, box.sizes().maxCoeff() / kMostAlong});
    for (int k = 0; k < 3; ++k) {
      const auto before = int(std::ceil((first_[k] - box.min()[k]) / step_));
      start_.at(std::size_t(k)) = before;
      counts_.at(std::size_t(k)) = before + int(std::ceil((box.max()[k] - first_[k]) / step_)) + 1;
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
    return first_ + step_ * Vec3(cell[0] - start_[0], cell[1] - start_[1], cell[2] - start_[2]);
  }

  [[nodiscard]] std::size_t index(const Cell& cell) const {
    return (std::size_t(cell[2]) * std::size_t(counts_[1]) + std::size_t(cell[1])) *
               std::size_t(counts_[0]) +
           std::size_t(cell[0]);
  }

  [[nodiscard]] bool is_free(const Vec3& point) const {
    return std::ranges::none_of(obstacles_, [&](const NamedObstacle& obstacle) {
      return is_near(obstacle.shape, obstacle.parts, point, radius_ + margin_ + clearance_);
    });
  }

  [[nodiscard]] bool is_clear(const Vec3& a, const Vec3& b) const {
    if (!((b - a).norm() > 0)) {
      return true;
    }
    const std::vector<RingedSurface> pipe{straight(a, b, radius_ + margin_, radius_ + margin_)};
    return !prove_clearance(pipe, obstacles_, clearance_).spot;
  }

  // The free places about the last corner from which a leg leads to it that is not too short.
  [[nodiscard]] std::vector<Cell> goals() const {
    constexpr int kReach = 2, kSide = 2 * kReach + 1;
    const Vec3 off = (last_ - first_) / step_;
    std::vector<Cell> result;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const Cell cell{start_[0] + int(std::lround(off.x())) + i % kSide - kReach,
                      start_[1] + int(std::lround(off.y())) + i / kSide % kSide - kReach,
                      start_[2] + int(std::lround(off.z())) + i / (kSide * kSide) - kReach};
      const Vec3 leg = last_ - place(cell);
      if (is_inside(cell) && leg.norm() >= step_ && turns_well(leg, -to_.normal) &&
          is_free(place(cell)) && is_clear(last_, place(cell))) {
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
    if (!is_free(first_) || !is_free(last_)) {
      return {};
    }
    if (turns_well(from_.normal, last_ - first_) && turns_well(last_ - first_, -to_.normal) &&
        is_clear(first_, last_)) {
      return {first_, last_};
    }
    best[index(start_)] = 0;
    open.push({(last_ - first_).norm(), number++, start_});
    const std::vector<Cell> ends = goals();
    while (!open.empty()) {
      const Cell cell = open.top().cell;
      const double cost = open.top().cost;
      open.pop();
      if (cost > best[index(cell)] + (last_ - place(cell)).norm()) {
        continue;
      }
      if (std::ranges::count(ends, cell) > 0 &&
          turns_well(arrival(cell, came), last_ - place(cell))) {
        return traced(cell, came);
      }
      for (int step = 0; step < 6; ++step) {
        Cell next = cell;
        next.at(std::size_t(step / 2)) += step % 2 == 0 ? 1 : -1;
        if (!is_inside(next)) {
          continue;
        }
        if (cell == start_ && !turns_well(from_.normal, place(next) - first_)) {
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

  // The direction in which a place was reached.
  [[nodiscard]] Vec3 arrival(const Cell& cell, const std::vector<int>& came) const {
    const int step = came[index(cell)];
    return step < 0 ? from_.normal : Vec3((step % 2 == 0 ? 1 : -1) * Vec3::Unit(step / 2));
  }

  [[nodiscard]] std::vector<Vec3> traced(Cell cell, const std::vector<int>& came) const {
    std::vector<Vec3> result{last_, place(cell)};
    for (int step = came[index(cell)]; step >= 0; step = came[index(cell)]) {
      cell.at(std::size_t(step / 2)) -= step % 2 == 0 ? 1 : -1;
      result.push_back(place(cell));
    }
    std::ranges::reverse(result);
    return result;
  }

  // From each corner straight to the last one that it sees, if the turn there leaves room for an
  // elbow.
  [[nodiscard]] std::vector<Vec3> straightened(const std::vector<Vec3>& path) const {
    std::vector<Vec3> result{from_.center, path.front()};
    for (std::size_t i = 0; i + 1 < path.size();) {
      std::size_t next = path.size() - 1;
      while (next > i + 1 &&
             !(is_clear(path[i], path[next]) &&
               turns_well(result.back() - result[result.size() - 2], path[next] - result.back()))) {
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

  // By little more than a right angle.
  [[nodiscard]] static bool turns_well(const Vec3& before, const Vec3& after) {
    return before.normalized().dot(after.normalized()) > -0.1;
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
  double margin_ = 0;  // about the way, for its elbows
  Vec3 first_, last_;
  Cell start_{};  // that of first_
  std::array<int, 3> counts_{};
};

}  // namespace

std::optional<std::vector<RingedSurface>> polyline_pipe(const Ring& from, const Ring& to,
                                                        std::span<const NamedObstacle> obstacles,
                                                        double clearance) {
  return Planner(from, to, obstacles, clearance).run();
}

}  // namespace dupin::avoidance
