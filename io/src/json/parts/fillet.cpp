#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"fillet"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"between", "radius"});
    const JsonNode names = node.at("between");
    if (names.require_array() != 2) {
      names.fail("must be the names of two parts");
    }
    return FilletBetween{{names.at(0).text(), names.at(1).text()}, node.at("radius").number()};
  }
};
template PartShape read_part<"fillet">(const JsonNode& node);

}  // namespace dupin::json
