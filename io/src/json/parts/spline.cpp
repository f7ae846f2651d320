#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

std::vector<Waypoint> waypoints(const JsonNode& node) {
  std::vector<Waypoint> result;
  const std::size_t count = node.require_array();
  for (std::size_t i = 0; i < count; ++i) {
    allow_only(node.at(i), {"point", "radius"});
    result.push_back({vector(node.at(i).at("point")), node.at(i).at("radius").number()});
  }
  return result;
}

Obstacle box(const JsonNode& node) {
  allow_only(node, {"corner", "neighbours"});
  Obstacle result{vector(node.at("corner")), {}, 0};
  const JsonNode neighbours = node.at("neighbours");
  if (neighbours.require_array() != 3) {
    neighbours.fail("a box has three corners next to its first one");
  }
  for (std::size_t i = 0; i < 3; ++i) {
    allow_only(neighbours.at(i), {"point"});
    result.edges.push_back(vector(neighbours.at(i).at("point")) - result.corner);
  }
  return result;
}

std::variant<Obstacle, std::string> obstacle(const JsonNode& node) {
  allow_only(node, {"ball", "capsule", "box", "part"});
  if (int(node.has("ball")) + int(node.has("capsule")) + int(node.has("box")) +
          int(node.has("part")) !=
      1) {
    node.fail("must have one of ball, capsule, box and part");
  }
  if (node.has("part")) {
    return node.at("part").text();
  }
  if (node.has("ball")) {
    const JsonNode ball = node.at("ball");
    allow_only(ball, {"center", "radius"});
    return Obstacle{vector(ball.at("center")), {}, ball.at("radius").number()};
  }
  if (node.has("capsule")) {
    const JsonNode capsule = node.at("capsule");
    allow_only(capsule, {"from", "to", "radius"});
    const Vec3 from = vector(capsule.at("from"));
    return Obstacle{from, {vector(capsule.at("to")) - from}, capsule.at("radius").number()};
  }
  return box(node.at("box"));
}

std::optional<Avoidance> avoidance(const JsonNode& node) {
  if (!node.has("avoid")) {
    if (node.has("clearance")) {
      node.at("clearance").fail("is from what 'avoid' lists, which is missing");
    }
    return std::nullopt;
  }
  Avoidance result;
  const JsonNode avoid = node.at("avoid");
  const std::size_t count = avoid.require_array();
  for (std::size_t i = 0; i < count; ++i) {
    result.obstacles.push_back(obstacle(avoid.at(i)));
  }
  result.clearance = node.at("clearance").number();
  return result;
}

}  // namespace

template <>
struct PartReader<"spline"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"from", "to", "through", "closed", "avoid", "clearance"});
    const auto through = node.has("through") || !node.has("avoid") ? waypoints(node.at("through"))
                                                                   : std::vector<Waypoint>();
    if (!node.has("closed")) {
      return SplineBetween{port(node.at("from")), port(node.at("to")), through, avoidance(node)};
    }
    if (node.has("avoid")) {
      node.at("avoid").fail(
          "is for pipes between two ports; a closed pipe goes through its points");
    }
    const JsonNode closed = node.at("closed");
    if (closed.value() != true) {
      closed.fail("must be true, or left out for a pipe between two ports");
    }
    if (node.has("from") || node.has("to")) {
      node.fail("a closed pipe has no ports to begin or end at; leave out 'from' and 'to'");
    }
    return SplineRound{through};
  }
};
template PartShape read_part<"spline">(const JsonNode& node);

}  // namespace dupin::json
