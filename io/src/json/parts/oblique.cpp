#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"oblique"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"from", "to", "normal", "radii"});
    const auto [start, end] = pair(node.at("radii"), "start, end");
    return ObliqueBetween{vector(node.at("from")), vector(node.at("to")), vector(node.at("normal")),
                          start, end};
  }
};
template PartShape read_part<"oblique">(const JsonNode& node);

}  // namespace dupin::json
