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

void allow_only(const JsonNode& node, const Keys& keys) { allow_only(node, keys, keys); }

void allow_only(const JsonNode& node, const Keys& keys, const Keys& told) {
  node.require_object();
  for (const auto& [key, value] : node.value().items()) {
    if (std::ranges::find(keys, key) != keys.end()) {
      continue;
    }
    node.at(key).fail(std::ranges::find(told, key) == told.end()
                          ? "unknown key; known here are " + listed(told)
                          : "does not go with the other keys; beside them are known " +
                                listed(keys));
  }
}

Keys with_sizes(const Keys& keys) {
  Keys result;
  for (const auto key : keys) {
    result.push_back(key);
    if (key == "radius") {
      result.insert(result.end(), {"size", "schedule", "outside_diameter", "inside_diameter"});
    }
  }
  return result;
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

void append_new(Keys& keys, const Keys& more) {
  for (const auto key : more) {
    if (std::ranges::find(keys, key) == keys.end()) {
      keys.push_back(key);
    }
  }
}

}  // namespace

std::size_t matching_key_set(const JsonNode& node, std::span<const KeySet> sets,
                             const Keys& others) {
  Keys known, told;
  const bool elliptic = is_elliptic(node);
  for (const auto& [from_port, circular] : sets) {
    append_new(known, elliptic ? with_semi_axes(circular) : circular);
    append_new(told, with_sizes(circular));
  }
  for (const auto& set : sets) {
    append_new(told, with_semi_axes(set.keys));
  }
  append_new(told, others);
  allow_only(node, known, told);
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
