#include "dupin/io/assembly_json.h"

#include <algorithm>
#include <array>
#include <vector>

#include "dupin/io/atomic_file.h"
#include "json/expansion.h"
#include "json/json_document.h"
#include "json/parts/part_values.h"
#include "json/parts/read_part.h"

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

Part part(const JsonNode& node) {
  Keys known{"name", "comment", "wall", "solid"}, keys;
  for (const auto& row : kRows) {
    keys.push_back(row.key);
  }
  known.insert(known.end(), keys.begin(), keys.end());
  json::allow_only(node, known);
  Part result{node.at("name").text(), {}};
  if (node.has("comment")) {
    (void)node.at("comment").text();
  }
  if (node.has("wall")) {
    result.wall = node.at("wall").number();
  }
  if (node.has("solid")) {
    const JsonNode solid = node.at("solid");
    if (!solid.value().is_boolean()) {
      solid.fail("must be true or false");
    }
    result.solid = solid.value().get<bool>();
  }
  const auto count =
      std::count_if(keys.begin(), keys.end(), [&](auto key) { return node.has(key); });
  if (count != 1) {
    node.fail("a part must have exactly one of the keys " + json::listed(keys));
  }
  for (const auto& [key, read] : kRows) {
    if (node.has(key)) {
      result.shape = read(node.at(key));
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
  for (const std::string_view unread : {"$schema", "comment"}) {
    if (document.has(unread)) {
      (void)document.at(unread).text();
    }
  }
}

}  // namespace

Assembly parse_assembly(std::string_view text, const std::string& source) {
  const json::Json json = json::parse_json(text, source);
  const JsonNode document(json, source, "");
  json::allow_only(document, {"$schema", "units", "tolerance", "segments", "wall", "comment",
                              "values", "parts"});
  Assembly assembly;
  assembly.source = source;
  assembly.unit = unit(document.at("units"));
  json::Values values(document, assembly.unit);
  read_head(document, values, assembly);
  json::expand(document, source, assembly.unit, values,
               [&](const JsonNode& node, const std::string& pointer) {
                 const std::string own = document_place({}, std::uint32_t(assembly.parts.size()));
                 assembly.parts.push_back(part(node));
                 assembly.parts.back().pointer = pointer == own ? "" : pointer;
               });
  return assembly;
}

Assembly read_assembly(const std::filesystem::path& file) {
  return parse_assembly(read_file(file), file.string());
}

}  // namespace dupin
