#include <array>

#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

std::array<double, 3> triple(const JsonNode& node) {
  const Vec3 values = vector(node);
  return {values.x(), values.y(), values.z()};
}

}  // namespace

template <>
struct PartReader<"two_cone_blend"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"from", "to", "reach", "m", "w"});
    TwoConeBlendBetween blend{port(node.at("from")), port(node.at("to")),
                              pair(node.at("reach"), "from, to")};
    if (node.has("m")) {
      blend.m = triple(node.at("m"));
    }
    if (node.has("w")) {
      blend.w = triple(node.at("w"));
    }
    return blend;
  }
};
template PartShape read_part<"two_cone_blend">(const JsonNode& node);

}  // namespace dupin::json
