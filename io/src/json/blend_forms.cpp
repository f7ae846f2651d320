#include <optional>

#include "json/part_forms.h"

namespace dupin::json {
namespace {

std::optional<double> number_or_auto(const JsonNode& node) {
  if (node.value().is_number()) {
    return node.number();
  }
  if (!node.value().is_string() || node.text() != "auto") {
    node.fail("must be a number or \"auto\"");
  }
  return std::nullopt;
}

}  // namespace

PartShape read_cyclic_blend(const JsonNode& node) {
  allow_only(node, {"from", "to", "radius_law", "k", "l", "continuity"});
  CyclicBlendBetween blend{port(node.at("from")), port(node.at("to")), {}};
  const JsonNode law = node.at("radius_law");
  if (law.text() != "R1" && law.text() != "R2") {
    law.fail("must be \"R1\" or \"R2\", not \"" + law.text() + "\"");
  }
  blend.options.radius_law = law.text() == "R1" ? BlendLaw::r1 : BlendLaw::r2;
  if (node.has("continuity")) {
    const JsonNode continuity = node.at("continuity");
    if (continuity.text() != "G1" && continuity.text() != "G2") {
      continuity.fail("must be \"G1\" or \"G2\", not \"" + continuity.text() + "\"");
    }
    blend.options.continuity = continuity.text() == "G1" ? Continuity::g1 : Continuity::g2;
  }
  blend.options.k = number_or_auto(node.at("k"));
  blend.options.l = number_or_auto(node.at("l"));
  return blend;
}

namespace {

std::array<double, 3> triple(const JsonNode& node) {
  const Vec3 values = vector(node);
  return {values.x(), values.y(), values.z()};
}

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

std::vector<Waypoint> waypoints(const JsonNode& node) {
  std::vector<Waypoint> result;
  const std::size_t count = node.require_array();
  for (std::size_t i = 0; i < count; ++i) {
    allow_only(node.at(i), {"point", "radius"});
    result.push_back({vector(node.at(i).at("point")), node.at(i).at("radius").number()});
  }
  return result;
}

}  // namespace

PartShape read_two_cone_blend(const JsonNode& node) {
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

PartShape read_ringed_blend(const JsonNode& node) {
  allow_only(node, {"from", "to", "k", "l", "bidegree"});
  RingedBlendBetween blend{ringed_end(node.at("from")), ringed_end(node.at("to")), speed(node, "k"),
                           speed(node, "l")};
  if (node.has("bidegree")) {
    const JsonNode degree = node.at("bidegree");
    if (degree.value() != Json{5, 2} && degree.value() != Json{9, 2}) {
      degree.fail("must be [9, 2] or [5, 2]");
    }
    blend.low_degree = degree.value() == Json{5, 2};
  }
  return blend;
}

PartShape read_spline(const JsonNode& node) {
  allow_only(node, {"from", "to", "through", "closed"});
  const auto through = waypoints(node.at("through"));
  if (!node.has("closed")) {
    return SplineBetween{port(node.at("from")), port(node.at("to")), through};
  }
  const JsonNode closed = node.at("closed");
  if (closed.value() != true) {
    closed.fail("must be true, or left out for a pipe between two ports");
  }
  if (node.has("from") || node.has("to")) {
    node.fail("a closed pipe has no ports to begin or end at; leave out 'from' and 'to'");
  }
  return SplineRound{through};
}

}  // namespace dupin::json
