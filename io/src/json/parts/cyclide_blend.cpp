#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"cyclide_blend"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"from", "to"});
    return CyclideBlendBetween{port(node.at("from")), port(node.at("to"))};
  }
};
template PartShape read_part<"cyclide_blend">(const JsonNode& node);

}  // namespace dupin::json
