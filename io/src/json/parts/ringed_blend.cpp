#include <optional>
#include <string>

#include "json/parts/avoidance.h"
#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

std::string listed_contacts() { return "slope, sphere, apex, ruling, plate"; }

RingContact contact(const JsonNode& node) {
  std::optional<RingContact> found;
  const auto take = [&](RingContact given) {
    if (found) {
      node.fail("give at most one of " + listed_contacts());
    }
    found = std::move(given);
  };
  if (node.has("slope")) {
    take(CanalContact{node.at("slope").number()});
  }
  if (node.has("sphere")) {
    take(SphereContact{vector(node.at("sphere"))});
  }
  if (node.has("apex")) {
    take(ObliqueConeContact{vector(node.at("apex"))});
  }
  if (node.has("ruling")) {
    take(ObliqueCylinderContact{vector(node.at("ruling"))});
  }
  if (node.has("plate")) {
    const JsonNode plate = node.at("plate");
    if (plate.text() != "widening" && plate.text() != "narrowing") {
      plate.fail("must be \"widening\" or \"narrowing\", not \"" + plate.text() + "\"");
    }
    take(PlateContact{plate.text() == "widening"});
  }
  return found.value_or(CanalContact{});
}

RingedBlendEnd ringed_end(const JsonNode& node) {
  if (node.value().is_string()) {
    return port(node);
  }
  allow_only(node, {"center", "direction", "radius", "slope", "sphere", "apex", "ruling", "plate"});
  return FreeEnd{vector(node.at("center")), vector(node.at("direction")),
                 node.at("radius").number(), contact(node)};
}

std::optional<double> speed(const JsonNode& node, std::string_view key) {
  return node.has(key) ? number_or_auto(node.at(key)) : std::nullopt;
}

}  // namespace

template <>
struct PartReader<"ringed_blend"> {
  static PartShape read(const JsonNode& node) {
    allow_only(node, {"from", "to", "k", "l", "bidegree", "avoid", "clearance"});
    RingedBlendBetween blend{ringed_end(node.at("from")), ringed_end(node.at("to")),
                             speed(node, "k"), speed(node, "l")};
    if (node.has("bidegree")) {
      const JsonNode degree = node.at("bidegree");
      if (degree.value() != Json{5, 2} && degree.value() != Json{9, 2}) {
        degree.fail("must be [9, 2] or [5, 2]");
      }
      blend.low_degree = degree.value() == Json{5, 2};
    }
    blend.avoid = avoidance(node);
    return blend;
  }
};
template PartShape read_part<"ringed_blend">(const JsonNode& node);

}  // namespace dupin::json
