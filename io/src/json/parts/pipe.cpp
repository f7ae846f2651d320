#include <array>

#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"pipe"> {
  static PartShape read(const JsonNode& node) {
    node.require_object();
    if (node.has("on")) {
      const Keys keys{"on", "at", "direction", "length", "radius"};
      allow_only(node, keys, with_sizes(keys));
      return PipeOn{node.at("on").text(), node.at("at").number(), vector(node.at("direction")),
                    node.at("length").number(), node.at("radius").number()};
    }
    static const std::array<KeySet, 4> sets{{{false, {"from", "to", "radius"}},
                                             {false, {"from", "direction", "length", "radius"}},
                                             {true, {"from", "length"}},
                                             {true, {"from", "to"}}}};
    switch (matching_key_set(node, sets, {"on", "at"})) {
      case 0:
        return PipeBetween{vector(node.at("from")), vector(node.at("to")), section(node).radius,
                           section(node).axes};
      case 3:
        return PipeTo{port(node.at("from")), vector(node.at("to"))};
      default:
        return PipeAlong{origin(node), node.at("length").number()};
    }
  }
};
template PartShape read_part<"pipe">(const JsonNode& node);

}  // namespace dupin::json
