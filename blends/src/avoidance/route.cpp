#include "avoidance/route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>

#include <Eigen/Geometry>

#include "avoidance/polyline.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::avoidance {
namespace {

constexpr int kMostTrials = 600;
constexpr std::size_t kMostPoints = 8;  // added
constexpr int kDirections = 8;          // across the pipe, besides the way out
constexpr std::array kReaches{1.1, 1.5, 2.2};

// A way that was tried: what is wrong with it, and what it costs.
struct Trial {
  std::vector<Waypoint> through;
  std::vector<RingedSurface> pipe;
  Clearance proved;
  double cost = 0;
  int number = 0;  // of trials; decides between equals
};

struct Costlier {
  bool operator()(const Trial& a, const Trial& b) const {
    return a.cost != b.cost ? a.cost > b.cost : a.number > b.number;
  }
};

class Router {
 public:
  Router(const Ring& from, const Ring& to, std::span<const NamedObstacle> obstacles,
         double clearance)
      : from_(from),
        to_(to),
        obstacles_(obstacles),
        clearance_(clearance),
        size_((to.center - from.center).norm()) {}

  Route run(const std::vector<Waypoint>& given) {
    given_ = given;
    Trial first = given.empty() ? unguided() : tried(given, spline_pipe(from_, given, to_));
    if (first.proved.spot) {
      first = searched(std::move(first));
      tighten(first);
    }
    return {std::move(first.pipe), std::move(first.through), first.proved.least};
  }

 private:
  [[nodiscard]] Trial tried(std::vector<Waypoint> through, std::vector<RingedSurface> pipe) {
    Trial result{std::move(through), std::move(pipe), {}, 0, trials_++};
    result.proved = prove_clearance(result.pipe, obstacles_, clearance_);
    // How long the way is, how often it bends, and how much of it is still to be mended.
    result.cost =
        length(result.through) / size_ + 0.2 * double(result.through.size() - given_.size()) +
        (result.proved.spot ? 1 + (clearance_ - result.proved.spot->distance) / size_ : 0);
    return result;
  }

  // The spline without points, or straight pipes and elbows where that would fold.
  [[nodiscard]] Trial unguided() {
    try {
      return tried({}, spline_pipe(from_, {}, to_));
    } catch (const Error& error) {
      auto straight = error.code() == Errc::irregular_surface ? of_elbows() : std::nullopt;
      if (!straight) {
        throw;
      }
      return *std::move(straight);
    }
  }

  // Straight pipes and elbows.
  [[nodiscard]] std::optional<Trial> of_elbows() {
    auto pipe = polyline_pipe(from_, to_, obstacles_, clearance_);
    return pipe ? std::optional(tried({}, std::move(*pipe))) : std::nullopt;
  }

  // None where the pipe would fold.
  [[nodiscard]] std::optional<Trial> tried(const std::vector<Waypoint>& through) {
    try {
      return tried(through, spline_pipe(from_, through, to_));
    } catch (const Error& error) {
      if (error.code() != Errc::irregular_surface && error.code() != Errc::invalid_argument) {
        throw;
      }
      ++trials_;
      return std::nullopt;
    }
  }

  [[nodiscard]] double length(const std::vector<Waypoint>& through) const {
    double sum = 0;
    Vec3 last = from_.center;
    for (const Waypoint& point : through) {
      sum += (point.point - last).norm();
      last = point.point;
    }
    return sum + (to_.center - last).norm();
  }

  // Best first.
  Trial searched(Trial first) {
    Trial best = first;
    std::priority_queue<Trial, std::vector<Trial>, Costlier> open;
    open.push(std::move(first));
    while (!open.empty() && trials_ < kMostTrials) {
      const Trial parent = open.top();
      open.pop();
      std::optional<Trial> found;
      for (const std::vector<Waypoint>& through : children(parent)) {
        std::optional<Trial> child = tried(through);
        if (!child) {
          continue;
        }
        if (!child->proved.spot) {
          if (!found || child->cost < found->cost) {
            found = std::move(child);
          }
          continue;
        }
        if (child->proved.spot->distance > best.proved.spot->distance) {
          best = *child;
        }
        if (child->through.size() < given_.size() + kMostPoints) {
          open.push(std::move(*child));
        }
      }
      if (found) {
        return *found;
      }
    }
    if (given_.empty()) {
      if (auto straight = of_elbows()) {
        return *std::move(straight);
      }
    }
    const std::vector<Piece> pipe(best.pipe.begin(), best.pipe.end());
    refuse(tightest_spot(pipe, obstacles_, *best.proved.spot));  // known is any that is too near
  }

  [[noreturn]] void refuse(const TightSpot& spot) const {
    constexpr double kTouching = 1e-9;
    for (const Ring& port : {from_, to_}) {
      refuse_port(port);
    }
    const std::string how =
        spot.distance > kTouching * size_
            ? "comes within " + decimal(spot.distance, kMessageDigits) + " of it"
            : "runs into it";
    throw Error(
        Errc::infeasible_blend,
        "no way was found that keeps " + decimal(clearance_, kMessageDigits) + " from '" +
            obstacles_[spot.obstacle].name + "' and the other obstacles: the best of " +
            std::to_string(trials_) + " " + how + " at " + decimal(spot.place) +
            "; ask for less clearance, move what is in the way, or lead it round as a spline "
            "with points of its own in \"through\"");
  }

  // All ways begin and end with the ports' own discs.
  void refuse_port(const Ring& port) const {
    for (const NamedObstacle& obstacle : obstacles_) {
      const double nearest = distance({port.center, port.normal, port.radius}, obstacle);
      if (nearest < clearance_) {
        throw Error(Errc::infeasible_blend,
                    "no way keeps " + decimal(clearance_, kMessageDigits) + " from '" +
                        obstacle.name + "': the end at " + decimal(port.center) + " itself " +
                        (nearest > 0 ? "is only " + decimal(nearest, kMessageDigits) + " from it"
                                     : "lies in it") +
                        "; ask for less clearance, or move the end or what is in the way");
      }
    }
  }

  // Ways with one point more, off the tightest spot.
  [[nodiscard]] std::vector<std::vector<Waypoint>> children(const Trial& parent) const {
    const TightSpot& spot = *parent.proved.spot;
    const RingedSurface& piece = parent.pipe[spot.piece];
    const SpinePoint spine = evaluate(piece.spine, spot.parameter);
    const double radius = evaluate(piece.radius, spot.parameter).value;
    const Vec3 tangent = spine.first.normalized();
    const NamedObstacle& whole = obstacles_[spot.obstacle];
    std::vector<const Obstacle*> shapes{&spot.shape};
    if (!whole.parts.empty()) {
      shapes.push_back(&whole.shape);
    }
    std::vector<std::vector<Waypoint>> result;
    for (const Obstacle* shape : shapes) {
      for (const Vec3& direction : directions(*shape, spine.position, tangent)) {
        const double out = way_out(*shape, spine.position, direction, radius + clearance_);
        for (const double reach : kReaches) {
          const Vec3 place = spine.position + reach * out * direction;
          std::vector<Waypoint> through = parent.through;
          through.insert(through.begin() + std::ptrdiff_t(spot.piece), {place, radius});
          result.push_back(std::move(through));
        }
      }
    }
    return result;
  }

  // Away from the obstacle, and all around across the pipe.
  [[nodiscard]] static std::vector<Vec3> directions(const Obstacle& obstacle, const Vec3& place,
                                                    const Vec3& tangent) {
    std::vector<Vec3> result;
    const Vec3 off = place - nearest_core_point(obstacle, place);
    const Vec3 first = tangent.unitOrthogonal(), second = tangent.cross(first);
    if (off.norm() > 0) {
      result.push_back(off.normalized());
    }
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      result.push_back(std::cos(angle) * first + std::sin(angle) * second);
    }
    return result;
  }

  // How far to go until the obstacle is `wanted` away.
  [[nodiscard]] double way_out(const Obstacle& obstacle, const Vec3& place, const Vec3& direction,
                               double wanted) const {
    const auto is_out = [&](double s) {
      const Vec3 point = place + s * direction;
      return (point - nearest_core_point(obstacle, point)).norm() >= wanted + obstacle.radius;
    };
    double high = wanted;
    while (!is_out(high) && high < 64 * (size_ + wanted)) {
      high *= 1.5;
    }
    double low = 0;
    for (int i = 0; i < 30; ++i) {
      const double middle = (low + high) / 2;
      (is_out(middle) ? high : low) = middle;
    }
    return high;
  }

  [[nodiscard]] bool is_given(const Waypoint& point) const {
    return std::ranges::any_of(given_,
                               [&](const Waypoint& one) { return one.point == point.point; });
  }

  // Moves added points towards the line between their neighbours while the proof holds.
  void tighten(Trial& way) {
    constexpr int kRounds = 6;
    const int budget = trials_ + kMostTrials / 4;
    for (int round = 0; round < kRounds; ++round) {
      bool is_moved = false;
      for (std::size_t i = 0; i < way.through.size() && trials_ < budget; ++i) {
        if (is_given(way.through[i])) {
          continue;
        }
        for (const double part : {0.5, 0.25, 0.1}) {
          std::vector<Waypoint> through = way.through;
          const Vec3& before = i == 0 ? from_.center : through[i - 1].point;
          const Vec3& after = i + 1 == through.size() ? to_.center : through[i + 1].point;
          const Vec3 along = after - before;
          const double s =
              std::clamp(along.dot(through[i].point - before) / along.squaredNorm(), 0.2, 0.8);
          through[i].point += part * (before + s * along - through[i].point);
          auto trial = tried(through);
          if (trial && !trial->proved.spot && trial->cost < way.cost) {
            way = std::move(*trial);
            is_moved = true;
            break;
          }
        }
      }
      if (!is_moved) {
        return;
      }
    }
  }

  Ring from_, to_;
  std::span<const NamedObstacle> obstacles_;
  double clearance_, size_;
  std::vector<Waypoint> given_;
  int trials_ = 0;
};

}  // namespace

Route route(const Ring& from, const std::vector<Waypoint>& through, const Ring& to,
            std::span<const NamedObstacle> obstacles, double clearance) {
  return Router(from, to, obstacles, clearance).run(through);
}

}  // namespace dupin::avoidance
