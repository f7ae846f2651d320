#include "dupin/io/assembly_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "json/json_document.h"
#include "json/part_forms.h"

namespace dupin {
namespace {

using json::allow_only;
using json::is_elliptic;
using json::JsonNode;
using json::Keys;
using json::KeySet;
using json::listed;
using json::matching_key_set;
using json::origin;
using json::pair;
using json::port;
using json::section;
using json::Section;
using json::vector;

PartShape pipe(const JsonNode& node) {
  static const std::array<KeySet, 4> forms{{{false, {"from", "to", "radius"}},
                                            {false, {"from", "direction", "length", "radius"}},
                                            {true, {"from", "length"}},
                                            {true, {"from", "to"}}}};
  switch (json::matching_key_set(node, forms)) {
    case 0:
      return PipeBetween{json::vector(node.at("from")), json::vector(node.at("to")),
                         json::section(node).radius, json::section(node).axes};
    case 3:
      return PipeTo{json::port(node.at("from")), json::vector(node.at("to"))};
    default:
      return PipeAlong{json::origin(node), node.at("length").number()};
  }
}

PartShape oblique(const JsonNode& node) {
  json::allow_only(node, {"from", "to", "normal", "radii"});
  const auto [start, end] = json::pair(node.at("radii"), "start, end");
  return ObliqueBetween{json::vector(node.at("from")), json::vector(node.at("to")),
                        json::vector(node.at("normal")), start, end};
}

// The sections of a cone that does not begin at a port.
struct ConeSections {
  Section start;
  double end_radius = 1;
  std::optional<double> end_across;
};

ConeSections cone_sections(const JsonNode& node) {
  if (!json::is_elliptic(node)) {
    const auto [start, end] = json::pair(node.at("radii"), "start, end");
    return {{start, std::nullopt}, end, std::nullopt};
  }
  const JsonNode both = node.at("semi_axes");
  if (both.require_array() != 2) {
    both.fail("must be the semi-axes at both ends [start, end]");
  }
  const std::string meaning = "along the axis, across it";
  const auto [radius, across] = json::pair(both.at(std::size_t(0)), meaning);
  const auto [end_radius, end_across] = json::pair(both.at(1), meaning);
  return {{radius, SectionAxes{json::vector(node.at("axis")), across}}, end_radius, end_across};
}

PartShape cone(const JsonNode& node) {
  static const std::array<KeySet, 5> forms{{{false, {"from", "to", "radii"}},
                                            {false, {"from", "direction", "length", "radii"}},
                                            {true, {"from", "length", "end_radius"}},
                                            {true, {"from", "length", "end_semi_axes"}},
                                            {true, {"from", "length", "end_semi_axes", "axis"}}}};
  const auto which = json::matching_key_set(node, forms);
  if (which == 2) {
    return ConeAlong{json::port(node.at("from")), node.at("length").number(),
                     node.at("end_radius").number()};
  }
  if (which > 2) {
    const auto [radius, across] = json::pair(node.at("end_semi_axes"), "along the axis, across it");
    return ConeAlong{json::port(node.at("from")), node.at("length").number(), radius, across,
                     which == 4 ? std::optional(json::vector(node.at("axis"))) : std::nullopt};
  }
  const auto [start, end_radius, end_across] = cone_sections(node);
  if (which == 0) {
    return ConeBetween{json::vector(node.at("from")),
                       json::vector(node.at("to")),
                       start.radius,
                       end_radius,
                       start.axes,
                       end_across};
  }
  return ConeAlong{json::origin(node, start), node.at("length").number(), end_radius, end_across};
}

PartShape elbow(const JsonNode& node) {
  static const std::array<KeySet, 6> forms{
      {{false, {"from", "direction", "radius", "bend_radius", "angle", "toward"}},
       {true, {"from", "bend_radius", "angle", "toward"}},
       {false, {"from", "direction", "to", "radius"}},
       {true, {"from", "to"}},
       {false, {"from", "corner", "to", "radius"}},
       {true, {"from", "corner", "to"}}}};
  const auto which = json::matching_key_set(node, forms);
  if (which <= 1) {
    return ElbowTurning{json::origin(node), node.at("bend_radius").number(),
                        node.at("angle").number() / 180 * std::numbers::pi,
                        json::vector(node.at("toward"))};
  }
  if (which <= 3) {
    return ElbowTo{json::origin(node), json::vector(node.at("to"))};
  }
  const Vec3 corner = json::vector(node.at("corner")), to = json::vector(node.at("to"));
  if (which == 5) {
    return ElbowCorner{json::port(node.at("from")), corner, to};
  }
  const Vec3 from = json::vector(node.at("from"));
  if (corner == from) {
    node.at("corner").fail("the corner must differ from the point at 'from'");
  }
  const Section start = json::section(node);
  return ElbowCorner{Place{from, corner - from, start.radius, start.axes}, corner, to};
}

PartShape sphere(const JsonNode& node) {
  json::allow_only(node, {"center", "radius"});
  return SphereAt{json::vector(node.at("center")), node.at("radius").number()};
}

PartShape cap(const JsonNode& node) {
  json::allow_only(node, {"at"});
  return CapAt{json::port(node.at("at"))};
}

struct Kind {
  std::string_view key;
  PartShape (*read)(const JsonNode&);
};

constexpr std::array<Kind, 12> kKinds{{{"pipe", pipe},
                                       {"cone", cone},
                                       {"oblique", oblique},
                                       {"elbow", elbow},
                                       {"sphere", sphere},
                                       {"spline", json::read_spline},
                                       {"cyclic_blend", json::read_cyclic_blend},
                                       {"two_cone_blend", json::read_two_cone_blend},
                                       {"ringed_blend", json::read_ringed_blend},
                                       {"cyclide_blend", json::read_cyclide_blend},
                                       {"cyclide_chain", json::read_cyclide_chain},
                                       {"cap", cap}}};

Part part(const JsonNode& node) {
  Keys known{"name", "comment"}, kinds;
  for (const auto& kind : kKinds) {
    kinds.push_back(kind.key);
  }
  known.insert(known.end(), kinds.begin(), kinds.end());
  json::allow_only(node, known);
  Part result{node.at("name").text(), {}};
  if (node.has("comment")) {
    (void)node.at("comment").text();
  }
  const auto count =
      std::count_if(kinds.begin(), kinds.end(), [&](auto key) { return node.has(key); });
  if (count != 1) {
    node.fail("a part must have exactly one of the keys " + json::listed(kinds));
  }
  for (const auto& kind : kKinds) {
    if (node.has(kind.key)) {
      result.shape = kind.read(node.at(kind.key));
    }
  }
  return result;
}

std::uint32_t segments(const JsonNode& node) {
  const auto value = json::whole_number(node);
  if (!value) {
    node.fail("must be a whole number, at least 3");
  }
  return *value;
}

Unit unit(const JsonNode& node) {
  try {
    return unit_from(node.text());
  } catch (const Error& error) {
    if (error.code() != Errc::invalid_argument) {
      throw;
    }
    node.fail(error.message());
  }
}

}  // namespace

Assembly parse_assembly(std::string_view text, const std::string& source) {
  const json::Json json = json::parse_json(text, source);
  const JsonNode document(json, source, "");
  json::allow_only(document, {"units", "tolerance", "segments", "comment", "parts"});
  Assembly assembly;
  assembly.source = source;
  assembly.unit = unit(document.at("units"));
  assembly.tolerance = document.at("tolerance").number();
  if (document.has("segments")) {
    assembly.segments = segments(document.at("segments"));
  }
  if (document.has("comment")) {
    (void)document.at("comment").text();
  }
  const JsonNode parts = document.at("parts");
  const std::size_t count = parts.require_array();
  for (std::size_t i = 0; i < count; ++i) {
    assembly.parts.push_back(part(parts.at(i)));
  }
  return assembly;
}

Assembly read_assembly(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) {
    throw Error(Errc::io_failed, "the file cannot be read", {}, file.string());
  }
  return parse_assembly(text, file.string());
}

}  // namespace dupin
