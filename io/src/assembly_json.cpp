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

#include "json_document.h"

namespace dupin {
namespace {

using detail::JsonNode;
using Keys = std::vector<std::string_view>;

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
  return {text.substr(0, dot), end == "start" ? PartEnd::start : PartEnd::end};
}

bool begins_at_port(const JsonNode& node) { return node.at("from").value().is_string(); }

PartStart origin(const JsonNode& node, double radius) {
  return Place{vector(node.at("from")), vector(node.at("direction")), radius};
}

PartStart origin(const JsonNode& node) {
  return begins_at_port(node) ? PartStart(port(node.at("from")))
                              : origin(node, node.at("radius").number());
}

std::array<double, 2> radii(const JsonNode& node) {
  if (node.require_array() != 2) {
    node.fail("must be two radii [start, end]");
  }
  return {node.at(std::size_t(0)).number(), node.at(1).number()};
}

// One of the sets of keys that make a part, for parts from a port or from a point.
struct Form {
  bool from_port = false;
  Keys keys;
};

// The position of the form that has exactly the node's keys.
std::size_t form(const JsonNode& node, std::span<const Form> forms) {
  Keys known;
  for (const auto& [from_port, keys] : forms) {
    for (const auto key : keys) {
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
  for (std::size_t i = 0; i < forms.size(); ++i) {
    if (forms[i].from_port != begins_at_port(node)) {
      continue;
    }
    const auto has = [&](std::string_view key) { return node.has(key); };
    if (forms[i].keys.size() == node.value().size() &&
        std::all_of(forms[i].keys.begin(), forms[i].keys.end(), has)) {
      return i;
    }
    choices += (choices.empty() ? "{" : " or {") + listed(forms[i].keys) + "}";
  }
  node.fail(std::string("from a ") + (begins_at_port(node) ? "port" : "point") + ", give " +
            choices);
}

PartShape pipe(const JsonNode& node) {
  static const std::array<Form, 4> forms{{{false, {"from", "to", "radius"}},
                                          {false, {"from", "direction", "length", "radius"}},
                                          {true, {"from", "length"}},
                                          {true, {"from", "to"}}}};
  switch (form(node, forms)) {
    case 0:
      return PipeBetween{vector(node.at("from")), vector(node.at("to")),
                         node.at("radius").number()};
    case 3:
      return PipeTo{port(node.at("from")), vector(node.at("to"))};
    default:
      return PipeAlong{origin(node), node.at("length").number()};
  }
}

PartShape cone(const JsonNode& node) {
  static const std::array<Form, 3> forms{{{false, {"from", "to", "radii"}},
                                          {false, {"from", "direction", "length", "radii"}},
                                          {true, {"from", "length", "end_radius"}}}};
  const auto which = form(node, forms);
  if (which == 2) {
    return ConeAlong{port(node.at("from")), node.at("length").number(),
                     node.at("end_radius").number()};
  }
  const auto [start, end] = radii(node.at("radii"));
  if (which == 0) {
    return ConeBetween{vector(node.at("from")), vector(node.at("to")), start, end};
  }
  return ConeAlong{origin(node, start), node.at("length").number(), end};
}

PartShape elbow(const JsonNode& node) {
  static const std::array<Form, 6> forms{
      {{false, {"from", "direction", "radius", "bend_radius", "angle", "toward"}},
       {true, {"from", "bend_radius", "angle", "toward"}},
       {false, {"from", "direction", "to", "radius"}},
       {true, {"from", "to"}},
       {false, {"from", "corner", "to", "radius"}},
       {true, {"from", "corner", "to"}}}};
  const auto which = form(node, forms);
  if (which <= 1) {
    return ElbowTurning{origin(node), node.at("bend_radius").number(),
                        node.at("angle").number() / 180 * std::numbers::pi,
                        vector(node.at("toward"))};
  }
  if (which <= 3) {
    return ElbowTo{origin(node), vector(node.at("to"))};
  }
  const Vec3 corner = vector(node.at("corner")), to = vector(node.at("to"));
  if (which == 5) {
    return ElbowCorner{port(node.at("from")), corner, to};
  }
  const Vec3 from = vector(node.at("from"));
  if (corner == from) {
    node.at("corner").fail("the corner must differ from the point at 'from'");
  }
  return ElbowCorner{Place{from, corner - from, node.at("radius").number()}, corner, to};
}

PartShape sphere(const JsonNode& node) {
  allow_only(node, {"center", "radius"});
  return SphereAt{vector(node.at("center")), node.at("radius").number()};
}

std::optional<double> number_or_auto(const JsonNode& node) {
  if (node.value().is_number()) {
    return node.number();
  }
  if (!node.value().is_string() || node.text() != "auto") {
    node.fail("must be a number or \"auto\"");
  }
  return std::nullopt;
}

PartShape cyclic_blend(const JsonNode& node) {
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

std::optional<std::uint32_t> whole_number(const JsonNode& node) {
  const auto& value = node.value();
  if (!value.is_number_unsigned() ||
      value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
    return std::nullopt;
  }
  return value.get<std::uint32_t>();
}

std::size_t index(const JsonNode& node) {
  const auto value = whole_number(node);
  if (!value) {
    node.fail("must be an index, counted from 0");
  }
  return *value;
}

PartShape cyclide_blend(const JsonNode& node) {
  allow_only(node, {"from", "to"});
  return CyclideBlendBetween{port(node.at("from")), port(node.at("to"))};
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

PartShape cyclide_chain(const JsonNode& node) {
  allow_only(node, {"from", "direction", "slope", "spheres", "tangents", "wall"});
  CyclideChainThrough chain;
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

PartShape cap(const JsonNode& node) {
  allow_only(node, {"at"});
  return CapAt{port(node.at("at"))};
}

struct Kind {
  std::string_view key;
  PartShape (*read)(const JsonNode&);
};

constexpr std::array<Kind, 8> kKinds{{{"pipe", pipe},
                                      {"cone", cone},
                                      {"elbow", elbow},
                                      {"sphere", sphere},
                                      {"cyclic_blend", cyclic_blend},
                                      {"cyclide_blend", cyclide_blend},
                                      {"cyclide_chain", cyclide_chain},
                                      {"cap", cap}}};

Part part(const JsonNode& node) {
  Keys known{"name", "comment"}, kinds;
  for (const auto& kind : kKinds) {
    kinds.push_back(kind.key);
  }
  known.insert(known.end(), kinds.begin(), kinds.end());
  allow_only(node, known);
  Part result{node.at("name").text(), {}};
  if (node.has("comment")) {
    (void)node.at("comment").text();
  }
  const auto count =
      std::count_if(kinds.begin(), kinds.end(), [&](auto key) { return node.has(key); });
  if (count != 1) {
    node.fail("a part must have exactly one of the keys " + listed(kinds));
  }
  for (const auto& kind : kKinds) {
    if (node.has(kind.key)) {
      result.shape = kind.read(node.at(kind.key));
    }
  }
  return result;
}

std::uint32_t segments(const JsonNode& node) {
  const auto value = whole_number(node);
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
  const detail::Json json = detail::parse_json(text, source);
  const JsonNode document(json, source, "");
  allow_only(document, {"units", "tolerance", "segments", "comment", "parts"});
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
