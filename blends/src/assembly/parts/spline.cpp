#include <string>
#include <vector>

#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "avoidance/route.h"
#include "dupin/kernel/decimal.h"

namespace dupin::assembly {
namespace {

void check_points(const PartContext& context, const std::vector<Waypoint>& through) {
  for (std::size_t i = 0; i < through.size(); ++i) {
    const std::string key = "through/" + std::to_string(i);
    check_finite(context, through[i].point, key + "/point");
    check_positive(context, through[i].radius, key + "/radius");
  }
}

std::string avoid_key(std::size_t i) { return "avoid/" + std::to_string(i); }

void check_obstacle(const PartContext& context, const Obstacle& obstacle, const std::string& key) {
  check_finite(context, obstacle.corner, key);
  for (const Vec3& edge : obstacle.edges) {
    check_finite(context, edge, key);
  }
  if (obstacle.edges.size() < 3) {
    check_positive(context, obstacle.radius, key);
  }
}

std::vector<avoidance::NamedObstacle> obstacles(const PartContext& context,
                                                const Avoidance& avoid) {
  std::vector<avoidance::NamedObstacle> result;
  for (std::size_t i = 0; i < avoid.obstacles.size(); ++i) {
    if (const auto* name = std::get_if<std::string>(&avoid.obstacles[i])) {
      for (avoidance::NamedObstacle& stretch :
           avoidance::obstacles_of(*name, context.surface(*name))) {
        result.push_back(std::move(stretch));
      }
    } else {
      const auto& solid = std::get<Obstacle>(avoid.obstacles[i]);
      check_obstacle(context, solid, avoid_key(i));
      result.push_back({avoid_key(i), solid});
    }
  }
  return result;
}

std::vector<RingedSurface> avoiding(const PartContext& context, const SplineBetween& spline) {
  const Avoidance& avoid = *spline.avoid;
  if (!(avoid.clearance >= 0 && avoid.clearance <= kLargest)) {
    fail(context, "clearance",
         "the clearance must be a number that is not negative, not " +
             decimal(avoid.clearance, kMessageDigits));
  }
  return avoidance::route(right_end(context, spline.from, "from"), spline.through,
                          right_end(context, spline.to, "to"), obstacles(context, avoid),
                          avoid.clearance)
      .pipe;
}

}  // namespace

template <>
struct PartRules<"spline"> {
  static constexpr bool kIsTangent = true;

  static References references(const SplineBetween& spline) {
    return between_ports(spline.from, spline.to);
  }
  static References references(const SplineRound&) { return {}; }

  static std::vector<Need> needs(const SplineBetween& spline) {
    std::vector<Need> result;
    if (spline.avoid) {
      for (const auto& obstacle : spline.avoid->obstacles) {
        if (const auto* name = std::get_if<std::string>(&obstacle)) {
          result.push_back({*name, "avoid"});
        }
      }
    }
    return result;
  }
  static std::vector<Need> needs(const SplineRound&) { return {}; }

  static std::string_view portless(const SplineBetween&) { return {}; }
  static std::string_view portless(const SplineRound&) { return "a closed spline"; }

  static PartSurface geometry(const PartContext& context, const SplineBetween& spline) {
    check_points(context, spline.through);
    if (spline.avoid) {
      return Chain(avoiding(context, spline));
    }
    return Chain(spline_pipe(right_end(context, spline.from, "from"), spline.through,
                             right_end(context, spline.to, "to")));
  }

  static PartNotes notes(const SplineBetween& spline, const PartSurface& surface) {
    if (!spline.avoid) {
      return {};
    }
    const std::size_t points = std::get<Chain>(surface).pieces.size() - 1;
    return {"a way through " + std::to_string(points) + (points == 1 ? " point" : " points") +
                ", proved to keep " + decimal(spline.avoid->clearance, kMessageDigits) +
                " from all that it avoids",
            {},
            {}};
  }
  static PartNotes notes(const SplineRound& /*spline*/, const PartSurface& /*surface*/) {
    return {};
  }

  static PartSurface geometry(const PartContext& context, const SplineRound& spline) {
    check_points(context, spline.through);
    return Chain(closed_spline_pipe(spline.through), true);
  }
};
template const PartKind& part_kind<"spline">();

}  // namespace dupin::assembly
