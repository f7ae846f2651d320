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

}  // namespace

template <>
struct PartReader<"spline"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"from", "to", "through", "closed"});
    const auto through = waypoints(node.at("through"));
    if (!node.has("closed")) {
      return SplineBetween{port(node.at("from")), port(node.at("to")), through};
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
