#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {

template <>
struct PartReader<"cap"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"at"});
    return CapAt{port(node.at("at"))};
  }
};
template PartShape read_part<"cap">(const JsonNode& node);

}  // namespace dupin::json
