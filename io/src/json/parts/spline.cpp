#include <vector>

#include "json/parts/avoidance.h"
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
