#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"flange"> {
  static PartShape read(const JsonNode& node) {
    node.require_object();
    const bool is_on = node.has("on"), is_at_end = !is_on && node.has("at");
    const Keys keys = is_on       ? Keys{"on", "at", "radius", "thickness"}
                      : is_at_end ? Keys{"at", "radius", "thickness"}
                                  : Keys{"center", "normal", "radius", "thickness", "at", "on"};
    Keys told = keys;
    told.insert(told.end(), {"size", "class"});
    allow_only(node, keys, told);
    const double radius = node.at("radius").number(), thickness = node.at("thickness").number();
    if (is_on) {
      return FlangeOn{node.at("on").text(), node.at("at").number(), radius, thickness};
    }
    if (is_at_end) {
      return FlangeOfEnd{port(node.at("at")), radius, thickness};
    }
    return FlangeAt{vector(node.at("center")), vector(node.at("normal")), radius, thickness};
  }
};
template PartShape read_part<"flange">(const JsonNode& node);

}  // namespace dupin::json
