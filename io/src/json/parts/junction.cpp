#include <numbers>

#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"junction"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"ends", "center", "radius", "cap_angles", "smoothness"});
    JunctionOfPorts result;
    const JsonNode ends = node.at("ends");
    const std::size_t count = ends.require_array();
    for (std::size_t i = 0; i < count; ++i) {
      result.ends.push_back(port(ends.at(i)));
    }
    if (node.has("center")) {
      result.options.center = vector(node.at("center"));
    }
    if (node.has("radius")) {
      result.options.radius = node.at("radius").number();
    }
    if (node.has("smoothness")) {
      result.options.smoothness = node.at("smoothness").number();
    }
    if (node.has("cap_angles")) {
      const JsonNode angles = node.at("cap_angles");
      const std::size_t given = angles.require_array();
      for (std::size_t i = 0; i < given; ++i) {
        result.options.cap_angles.push_back(angles.at(i).number() / 180 * std::numbers::pi);
      }
    }
    return result;
  }
};
template PartShape read_part<"junction">(const JsonNode& node);

}  // namespace dupin::json
