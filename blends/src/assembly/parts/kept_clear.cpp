#include "assembly/parts/kept_clear.h"

#include <utility>
#include <variant>

#include "avoidance/clearance.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/interior_point.h"

namespace dupin::assembly {
namespace {

using avoidance::NamedObstacle;

void check_obstacle(const PartContext& context, const Obstacle& obstacle, const std::string& key) {
  check_finite(context, obstacle.corner, key);
  for (const Vec3& edge : obstacle.edges) {
    check_finite(context, edge, key);
  }
  if (obstacle.edges.size() < 3) {
    check_positive(context, obstacle.radius, key);
  }
}

// A solid's surface alone would not tell that the way begins inside.
void refuse_inside(const PartContext& context, const MeshObstacle& obstacle,
                   const std::array<Vec3, 2>& ends, const std::string& key) {
  const bool is_closed = check(*obstacle.mesh, {.limit = 0, .self_intersections = false}).closed();
  for (const std::size_t i : {0U, 1U}) {
    if (is_closed && winding_number(*obstacle.mesh, ends.at(i)) != 0) {
      fail(context, key,
           "'" + obstacle.file + "' is a closed surface that goes round " + decimal(ends.at(i)) +
               ", where the way " + (i == 0 ? "begins" : "ends") +
               "; give one that it lies outside of");
    }
  }
}

struct ObstacleReader {
  const PartContext& context;
  const std::array<Vec3, 2>& ends;
  const std::string& key;
  std::vector<NamedObstacle>& result;

  void operator()(const Obstacle& solid) const {
    check_obstacle(context, solid, key);
    result.push_back({key, solid});
  }
  void operator()(const std::string& part) const {
    for (NamedObstacle& stretch : avoidance::obstacles_of(part, context.surface(part))) {
      result.push_back(std::move(stretch));
    }
  }
  void operator()(const MeshObstacle& obstacle) const {
    if (obstacle.mesh->triangles.empty()) {
      fail(context, key + "/mesh",
           "'" + obstacle.file + "' has no triangles; give a mesh that has some, or leave it out");
    }
    result.push_back(avoidance::obstacle_of(obstacle.file, *obstacle.mesh));
    refuse_inside(context, obstacle, ends, key);
  }
};

}  // namespace

std::vector<NamedObstacle> obstacles_of(const PartContext& context, const Avoidance& avoid,
                                        const std::array<Vec3, 2>& ends) {
  if (avoid.clearance != 0 && !is_within_bounds(avoid.clearance)) {
    fail(context, "clearance",
         "the clearance must be 0 or a number " + bounds_and(avoid.clearance));
  }
  std::vector<NamedObstacle> result;
  for (std::size_t i = 0; i < avoid.obstacles.size(); ++i) {
    const std::string key = "avoid/" + std::to_string(i);
    std::visit(ObstacleReader{context, ends, key, result}, avoid.obstacles[i]);
  }
  return result;
}

std::vector<Need> needs_of(const std::optional<Avoidance>& avoid) {
  std::vector<Need> result;
  if (avoid) {
    for (const auto& obstacle : avoid->obstacles) {
      if (const auto* name = std::get_if<std::string>(&obstacle)) {
        result.push_back({*name, "avoid"});
      }
    }
  }
  return result;
}

std::optional<Error> nearness(const Chain& surface, const std::vector<NamedObstacle>& obstacles,
                              double clearance) {
  const auto proved = avoidance::prove_clearance(surface.pieces, obstacles, clearance);
  if (!proved.spot) {
    return std::nullopt;
  }
  const avoidance::TightSpot spot =
      avoidance::tightest_spot(surface.pieces, obstacles, *proved.spot);
  return Error(
      Errc::infeasible_blend,
      "it does not keep " + decimal(clearance, kMessageDigits) + " from '" +
          obstacles[spot.obstacle].name + "': it " +
          (spot.distance > 0 ? "comes within " + decimal(spot.distance, kMessageDigits) + " of it"
                             : "runs into it") +
          " at " + decimal(spot.place));
}

PartNotes clearance_note(const std::optional<Avoidance>& avoid, const PartSurface& surface) {
  if (!avoid) {
    return {};
  }
  const std::size_t pieces = std::get<Chain>(surface).pieces.size();
  return {(pieces == 1 ? "" : "a way of " + std::to_string(pieces) + " pieces, ") +
              "proved to keep " + decimal(avoid->clearance, kMessageDigits) +
              " from all that it avoids",
          {},
          {}};
}

}  // namespace dupin::assembly
