#include "dupin/io/assembly_json.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <vector>

#include "dupin/blends/tessellation.h"
#include "dupin/io/atomic_file.h"
#include "dupin/kernel/parallel.h"
#include "json/expansion.h"
#include "json/fittings.h"
#include "json/json_document.h"
#include "json/parts/part_values.h"
#include "json/parts/read_part.h"
#include "text/label_colour.h"

namespace dupin {
namespace {

using json::JsonNode;
using json::Keys;

struct PartKeyRow {
  std::string_view key;
  PartShape (*read)(const JsonNode&);
};

template <class... Key>
constexpr std::array<PartKeyRow, sizeof...(Key)> rows(PartKeyTable<Key...> /*table*/) {
  return {PartKeyRow{Key::kName.view(), json::read_part<Key::kName>}...};
}

constexpr auto kRows = rows(PartKeys());

WallSide wall_side(const JsonNode& node) {
  const std::string text = node.text();
  for (const WallSide side : {WallSide::inwards, WallSide::outwards, WallSide::centred}) {
    if (text == name(side)) {
      return side;
    }
  }
  node.fail("must be \"inwards\", \"outwards\" or \"centred\", not \"" + text + "\"");
}

Component component(const JsonNode& node) {
  json::allow_only(node, {"name", "kind", "line"});
  Component result{node.at("name").text(), node.at("kind").text()};
  if (node.has("line")) {
    const auto line = json::whole_number(node.at("line"));
    if (!line) {
      node.at("line").fail("must be a whole number");
    }
    result.line = *line;
  }
  return result;
}

void read_wall(const JsonNode& node, Part& part) {
  if (node.has("wall")) {
    part.wall = node.at("wall").number();
  }
  if (node.has("wall_side")) {
    part.wall_side = wall_side(node.at("wall_side"));
  }
  if (node.has("insulation")) {
    part.insulation = node.at("insulation").number();
  }
  if (node.has("solid")) {
    const JsonNode solid = node.at("solid");
    if (!solid.value().is_boolean()) {
      solid.fail("must be true or false");
    }
    part.solid = solid.value().get<bool>();
  }
}

/// Of parts: `all`, one of which each has, and what else is known.
struct KeysOfParts {
  KeysOfParts() {
    std::ranges::transform(kRows, std::back_inserter(all), &PartKeyRow::key);
    all.insert(all.end(), json::fitting_keys().begin(), json::fitting_keys().end());
    known.insert(known.end(), all.begin(), all.end());
  }

  Keys all;
  Keys known{"name", "comment", "wall", "wall_side", "insulation", "solid", "component", "colour"};
};

Part part(const JsonNode& node) {
  static const KeysOfParts keys;
  json::allow_only(node, keys.known);
  Part result{node.at("name").text(), {}};
  if (node.has("comment")) {
    (void)node.at("comment").text();
  }
  read_wall(node, result);
  if (node.has("component")) {
    result.component = component(node.at("component"));
  }
  if (node.has("colour")) {
    const JsonNode colour = node.at("colour");
    if (!text::colour_of_code(colour.text())) {
      colour.fail("must be a colour such as \"#3a7bd5\", red, green and blue in hexadecimal");
    }
  }
  const auto count = std::ranges::count_if(kRows, [&](auto& row) { return node.has(row.key); });
  if (count != 1) {
    node.fail("a part must have exactly one of the keys " + json::listed(keys.all));
  }
  for (const auto& [key, read] : kRows) {
    if (node.has(key)) {
      result.shape = read(node.at(key));
    }
  }
  return result;
}

Part part(const json::ExpandedPart& expanded, const std::string& source, Unit unit) {
  try {
    Part result = part(JsonNode(expanded.part, source, expanded.pointer).in(symbol(unit)));
    result.key = expanded.key;
    return result;
  } catch (const Error& error) {
    if (expanded.copy.empty()) {
      throw;
    }
    throw error.in_part(expanded.copy);
  }
}

std::uint32_t segments(const JsonNode& node) {
  const auto value = json::whole_number(node);
  if (!value) {
    node.fail("must be a whole number from " + std::to_string(kFewestSegments) + " to " +
              std::to_string(kMostSegments));
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

void read_head(const JsonNode& document, json::Values& values, Assembly& assembly) {
  const auto read = [&](std::string_view key, const auto& take) {
    const json::Json value = values.replaced(document.at(key));
    take(document.with(value, key));
  };
  read("tolerance", [&](const JsonNode& node) { assembly.tolerance = node.number(); });
  if (document.has("segments")) {
    read("segments", [&](const JsonNode& node) { assembly.segments = segments(node); });
  }
  if (document.has("wall")) {
    read("wall", [&](const JsonNode& node) { assembly.wall = node.number(); });
  }
  if (document.has("wall_side")) {
    assembly.wall_side = wall_side(document.at("wall_side"));
  }
  if (document.has("insulation")) {
    read("insulation", [&](const JsonNode& node) { assembly.insulation = node.number(); });
  }
  if (document.has("patches")) {
    const JsonNode patches = document.at("patches");
    patches.require_object();
    for (const auto& [name, value] : patches.value().items()) {
      const JsonNode other = patches.with(value, name);
      const std::string text = other.text();
      if (text.empty()) {
        other.fail("a patch needs a name");
      }
      assembly.patches[name] = text;
    }
  }
  for (const std::string_view unread : {"$schema", "comment"}) {
    if (document.has(unread)) {
      (void)document.at(unread).text();
    }
  }
}

}  // namespace

AssemblyDocument parse_document(std::string_view text, const std::string& source) {
  const UsualArithmetic usual;
  const json::Json json = json::parse_json(text, source);
  const JsonNode document(json, source, "");
  json::allow_only(document, {"$schema", "units", "tolerance", "segments", "wall", "wall_side",
                              "insulation", "patches", "comment", "values", "parts"});
  AssemblyDocument result;
  Assembly& assembly = result.assembly;
  assembly.source = source;
  assembly.unit = unit(document.at("units"));
  json::Values values(document, assembly.unit);
  read_head(document, values, assembly);
  json::expand(
      document, source, assembly.unit, values, [&](std::span<const json::ExpandedPart> some) {
        const std::size_t first = assembly.parts.size();
        assembly.parts.resize(first + some.size());
        for_each_in_parallel(some.size(), [&](std::size_t i) {
          const UsualArithmetic workers;
          const std::string own = document_place({}, static_cast<std::uint32_t>(first + i));
          assembly.parts[first + i] = part(some[i], source, assembly.unit);
          assembly.parts[first + i].pointer = some[i].pointer == own ? "" : some[i].pointer;
        });
        for (std::size_t i = 0; i < some.size(); ++i) {
          if (const auto colour = some[i].part.find("colour"); colour != some[i].part.end()) {
            result.colours.emplace(assembly.parts[first + i].name, *colour);
          }
        }
      });
  return result;
}

Assembly parse_assembly(std::string_view text, const std::string& source) {
  const UsualArithmetic usual;
  return parse_document(text, source).assembly;
}

Assembly read_assembly(const std::filesystem::path& file) {
  return parse_assembly(read_file(file), file.string());
}

}  // namespace dupin
