#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"sphere"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"center", "radius"});
    return SphereAt{vector(node.at("center")), node.at("radius").number()};
  }
};
template PartShape read_part<"sphere">(const JsonNode& node);

}  // namespace dupin::json
