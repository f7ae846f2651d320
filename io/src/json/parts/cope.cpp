#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"cope"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"end", "to"});
    return CopeOfEnd{port(node.at("end")), node.at("to").text()};
  }
};
template PartShape read_part<"cope">(const JsonNode& node);

}  // namespace dupin::json
