#include <string>

#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

std::size_t index(const JsonNode& node) {
  const auto value = whole_number(node);
  if (!value) {
    node.fail("must be an index, counted from 0");
  }
  return *value;
}

// A sphere [x, y, z, radius] or a tangent [x, y, z, slope].
PeVector pe_vector(const JsonNode& node, const char* what) {
  if (node.require_array() != 4) {
    node.fail(std::string("must be four numbers ") + what + ", not " +
              std::to_string(node.value().size()));
  }
  return {{node.at(std::size_t(0)).number(), node.at(1).number(), node.at(2).number()},
          node.at(3).number()};
}

PinnedTangent pinned_tangent(const JsonNode& node) {
  allow_only(node, {"sphere", "tangent"});
  return {index(node.at("sphere")), pe_vector(node.at("tangent"), "[x, y, z, slope]")};
}

ChainJoints joints(const JsonNode& node) {
  const std::string text = node.text();
  if (text == "kneecaps") {
    return ChainJoints::kneecaps;
  }
  if (text != "smooth") {
    node.fail("must be \"smooth\" or \"kneecaps\", not \"" + text + "\"");
  }
  return ChainJoints::smooth;
}

}  // namespace

template <>
struct PartReader<"cyclide_chain"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"from", "direction", "slope", "spheres", "tangents", "wall", "joints"});
    CyclideChainThrough chain;
    if (node.has("joints")) {
      chain.joints = joints(node.at("joints"));
    }
    if (node.has("from")) {
      chain.from = port(node.at("from"));
    }
    if (node.has("direction")) {
      if (node.has("from")) {
        node.at("direction").fail("a chain from a port has its direction already");
      }
      chain.from = ChainDirection{vector(node.at("direction")),
                                  node.has("slope") ? node.at("slope").number() : 0};
    } else if (node.has("slope")) {
      node.at("slope").fail("a slope needs a direction");
    }
    const JsonNode spheres = node.at("spheres");
    const std::size_t count = spheres.require_array();
    for (std::size_t i = 0; i < count; ++i) {
      chain.spheres.push_back(pe_vector(spheres.at(i), "[x, y, z, radius]"));
    }
    if (node.has("tangents")) {
      const JsonNode tangents = node.at("tangents");
      const std::size_t pins = tangents.require_array();
      for (std::size_t i = 0; i < pins; ++i) {
        chain.tangents.push_back(pinned_tangent(tangents.at(i)));
      }
    }
    if (node.has("wall")) {
      chain.wall = node.at("wall").number();
      if (!(chain.wall > 0)) {
        node.at("wall").fail("the wall's thickness must be positive");
      }
    }
    return chain;
  }
};
template PartShape read_part<"cyclide_chain">(const JsonNode& node);

}  // namespace dupin::json
