#include "json/parts/part_values.h"

#include <algorithm>
#include <limits>

namespace dupin::json {

std::string listed(const Keys& keys) {
  std::string result;
  for (const auto key : keys) {
    result += (result.empty() ? "" : ", ") + std::string(key);
  }
  return result;
}

void allow_only(const JsonNode& node, const Keys& keys) {
  node.require_object();
  for (const auto& [key, value] : node.value().items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      node.at(key).fail("unknown key; known here are " + listed(keys));
    }
  }
}

Vec3 vector(const JsonNode& node) {
  if (node.require_array() != 3) {
    node.fail("must be three numbers [x, y, z], not " + std::to_string(node.value().size()));
  }
  return {node.at(std::size_t(0)).number(), node.at(1).number(), node.at(2).number()};
}

PortReference port(const JsonNode& node) {
  const std::string text = node.text();
  const auto dot = text.rfind('.');
  const std::string end = dot == std::string::npos ? "" : text.substr(dot + 1);
  if (dot == 0 || (end != "start" && end != "end")) {
    node.fail("must name a port as 'part.start' or 'part.end', not '" + text + "'");
  }
  return {text.substr(0, dot), end == "start" ? End::start : End::end};
}

std::optional<std::uint32_t> whole_number(const JsonNode& node) {
  const auto& value = node.value();
  if (!value.is_number_unsigned() ||
      value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
    return std::nullopt;
  }
  return value.get<std::uint32_t>();
}

namespace {

constexpr const char* kSemiAxes = "along the axis, across it";

bool begins_at_port(const JsonNode& node) { return node.at("from").value().is_string(); }

}  // namespace

bool is_elliptic(const JsonNode& node) { return node.has("semi_axes"); }

std::array<double, 2> pair(const JsonNode& node, const std::string& meaning) {
  if (node.require_array() != 2) {
    node.fail("must be two numbers [" + meaning + "]");
  }
  return {node.at(std::size_t(0)).number(), node.at(1).number()};
}

Section section(const JsonNode& node) {
  if (!is_elliptic(node)) {
    return {node.at("radius").number(), std::nullopt};
  }
  const auto [radius, across] = pair(node.at("semi_axes"), kSemiAxes);
  return {radius, SectionAxes{vector(node.at("axis")), across}};
}

PartStart origin(const JsonNode& node, const Section& section) {
  return Place{vector(node.at("from")), vector(node.at("direction")), section.radius, section.axes};
}

PartStart origin(const JsonNode& node) {
  return begins_at_port(node) ? PartStart(port(node.at("from"))) : origin(node, section(node));
}

namespace {

// The keys of an elliptic section instead of those of a circular one.
Keys with_semi_axes(const Keys& keys) {
  Keys result;
  for (const auto key : keys) {
    if (key == "radius" || key == "radii") {
      result.insert(result.end(), {"semi_axes", "axis"});
    } else {
      result.push_back(key);
    }
  }
  return result;
}

}  // namespace

std::size_t matching_key_set(const JsonNode& node, std::span<const KeySet> sets) {
  Keys known;
  const bool elliptic = is_elliptic(node);
  for (const auto& [from_port, circular] : sets) {
    for (const auto key : elliptic ? with_semi_axes(circular) : circular) {
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        known.push_back(key);
      }
    }
  }
  allow_only(node, known);
  const JsonNode from = node.at("from");
  if (!from.value().is_string() && !from.value().is_array()) {
    from.fail(std::string("must be a point [x, y, z] or a port 'part.end', not ") +
              from.value().type_name());
  }
  std::string choices;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    if (sets[i].from_port != begins_at_port(node)) {
      continue;
    }
    const auto has = [&](std::string_view key) { return node.has(key); };
    const Keys keys = elliptic ? with_semi_axes(sets[i].keys) : sets[i].keys;
    if (keys.size() == node.value().size() && std::all_of(keys.begin(), keys.end(), has)) {
      return i;
    }
    choices += (choices.empty() ? "{" : " or {") + listed(keys) + "}";
  }
  node.fail(std::string("from a ") + (begins_at_port(node) ? "port" : "point") + ", give " +
            choices);
}

Continuity continuity(const JsonNode& node) {
  for (const Continuity value : {Continuity::g1, Continuity::g2}) {
    if (node.text() == name(value)) {
      return value;
    }
  }
  node.fail("must be \"G1\" or \"G2\", not \"" + node.text() + "\"");
}

const char* name(Continuity continuity) { return continuity == Continuity::g1 ? "G1" : "G2"; }

std::optional<double> number_or_auto(const JsonNode& node) {
  if (node.value().is_number()) {
    return node.number();
  }
  if (!node.value().is_string() || node.text() != "auto") {
    node.fail("must be a number or \"auto\"");
  }
  return std::nullopt;
}

}  // namespace dupin::json
