#include <array>
#include <numbers>

#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"elbow"> {
  static PartShape read(const JsonNode& node) {
    static const std::array<KeySet, 6> sets{
        {{false, {"from", "direction", "radius", "bend_radius", "angle", "toward"}},
         {true, {"from", "bend_radius", "angle", "toward"}},
         {false, {"from", "direction", "to", "radius"}},
         {true, {"from", "to"}},
         {false, {"from", "corner", "to", "radius"}},
         {true, {"from", "corner", "to"}}}};
    const auto which = matching_key_set(node, sets);
    if (which <= 1) {
      return ElbowTurning{origin(node), node.at("bend_radius").number(),
                          node.at("angle").number() / 180 * std::numbers::pi,
                          vector(node.at("toward"))};
    }
    if (which <= 3) {
      return ElbowTo{origin(node), vector(node.at("to"))};
    }
    const Vec3 corner = vector(node.at("corner")), to = vector(node.at("to"));
    if (which == 5) {
      return ElbowCorner{port(node.at("from")), corner, to};
    }
    const Vec3 from = vector(node.at("from"));
    if (corner == from) {
      node.at("corner").fail("the corner must differ from the point at 'from'");
    }
    const Section start = section(node);
    return ElbowCorner{Place{from, corner - from, start.radius, start.axes}, corner, to};
  }
};
template PartShape read_part<"elbow">(const JsonNode& node);

}  // namespace dupin::json
