#include <array>

#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"oblique"> {
  static PartShape read(const JsonNode& node) {
    static const std::array<KeySet, 2> sets{
        {{false, {"from", "to", "normal", "radii"}}, {true, {"from", "to", "end_radius"}}}};
    if (matching_key_set(node, sets) == 1) {
      return ObliqueTo{port(node.at("from")), vector(node.at("to")),
                       node.at("end_radius").number()};
    }
    const auto [start, end] = pair(node.at("radii"), "start, end");
    return ObliqueBetween{vector(node.at("from")), vector(node.at("to")), vector(node.at("normal")),
                          start, end};
  }
};
template PartShape read_part<"oblique">(const JsonNode& node);

}  // namespace dupin::json
