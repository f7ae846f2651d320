#include "json/parts/avoidance.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/error.h"
#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

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

// Beside the document, if it has a place.
MeshObstacle mesh_obstacle(const JsonNode& node) {
  const std::string file = node.text();
  const std::filesystem::path beside = std::filesystem::path(node.source()).parent_path();
  const std::string path = (beside / file).string();
  TriMesh mesh;
  std::string unit;
  try {
    const std::string bytes = read_file(path);
    mesh = read_mesh(bytes, path);
    unit = mesh_unit(bytes, path);
  } catch (const Error& error) {
    node.fail(std::string("is not read: ") + error.what());
  }
  if (!unit.empty() && !node.unit().empty() && unit != node.unit()) {
    node.fail("'" + file + "' is in " + unit + ", but the document in " + std::string(node.unit()) +
              "; convert it first, with --to-unit");
  }
  return {file, std::make_shared<const TriMesh>(std::move(mesh))};
}

std::variant<Obstacle, std::string, MeshObstacle> obstacle(const JsonNode& node) {
  allow_only(node, {"ball", "capsule", "box", "part", "mesh"});
  if (int(node.has("ball")) + int(node.has("capsule")) + int(node.has("box")) +
          int(node.has("part")) + int(node.has("mesh")) !=
      1) {
    node.fail("must have one of ball, capsule, box, part and mesh");
  }
  if (node.has("mesh")) {
    return mesh_obstacle(node.at("mesh"));
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

}  // namespace

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

}  // namespace dupin::json
