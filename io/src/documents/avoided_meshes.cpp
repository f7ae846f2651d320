#include "dupin/io/avoided_meshes.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <system_error>
#include <utility>
#include <variant>

#include "dupin/blends/unit.h"
#include "json/expansion.h"
#include "json/expression.h"
#include "json/json_document.h"
#include "json/json_span.h"

namespace dupin {
namespace {

namespace fs = std::filesystem;

using json::Json;
using json::JsonStep;

/// Where the path of a mesh stands.
struct NamedMesh {
  std::vector<JsonStep> steps;
  std::string text;
  bool is_in_copies = false;  ///< of a "for", where braces hold expressions

  /// Whether the text is not the path itself.
  [[nodiscard]] bool is_made() const {
    return json::is_expression(text) || (is_in_copies && text.find('{') != std::string::npos);
  }
  [[nodiscard]] std::string pointer() const {
    std::string result;
    for (const JsonStep& step : steps) {
      const auto* const key = std::get_if<std::string>(&step);
      result += "/" + (key != nullptr ? *key : std::to_string(std::get<std::size_t>(step)));
    }
    return result;
  }
};

/// The paths that a text stands for, one for each copy, by its pointer.
using MadePaths = std::map<std::string, std::vector<std::string>>;

/// Whether the steps lead to an element of a list of this key.
bool are_in_list(const std::vector<JsonStep>& steps, std::string_view key) {
  const auto* const list =
      steps.size() > 1 ? std::get_if<std::string>(&steps[steps.size() - 2]) : nullptr;
  return list != nullptr && *list == key;
}

/// Documents are not nested deep (parse_json).
void collect(const Json& value, bool is_in_copies, std::vector<JsonStep>& steps,
             std::vector<NamedMesh>& meshes) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      steps.emplace_back(i);
      collect(value[i], is_in_copies, steps, meshes);
      steps.pop_back();
    }
  } else if (value.is_object()) {
    const bool is_copied = is_in_copies || value.contains("for");
    for (const auto& [key, one] : value.items()) {
      const bool is_mesh = key == "mesh" && one.is_string() && are_in_list(steps, "avoid");
      steps.emplace_back(std::string(key));
      if (is_mesh) {
        meshes.push_back({steps, one.get<std::string>(), is_copied});
      } else {
        collect(one, is_copied, steps, meshes);
      }
      steps.pop_back();
    }
  }
}

std::vector<NamedMesh> meshes_in(const Json& document) {
  std::vector<NamedMesh> meshes;
  std::vector<JsonStep> steps;
  collect(document, false, steps, meshes);
  return meshes;
}

/// Without looking for the meshes, which may be missing. What comes before a fault is there when it
/// throws.
void add_made_paths(const Json& document, const std::string& source, MadePaths& made) {
  const json::JsonNode node(document, source, "");
  const Unit unit = unit_from(node.at("units").text());
  json::Values values(node, unit);
  json::expand(node, source, unit, values, [&](std::span<const json::ExpandedPart> parts) {
    for (const json::ExpandedPart& part : parts) {
      for (const NamedMesh& mesh : meshes_in(part.part)) {
        made[part.pointer + mesh.pointer()].push_back(mesh.text);
      }
    }
  });
}

fs::path folder_of(const fs::path& file) {
  return fs::weakly_canonical(fs::absolute(file.has_parent_path() ? file.parent_path() : "."));
}

std::string quoted_path(const fs::path& path) {
  try {
    return Json(path.string()).dump();
  } catch (const Json::exception&) {
    throw Error(Errc::invalid_argument,
                "a folder on the way to a mesh that it avoids has a name that is no UTF-8, which "
                "documents are",
                {}, path.filename().string());
  }
}

/// The text that names the same meshes by the way to the folder in which `paths` begin; none if
/// it can stay.
std::optional<fs::path> seen_by(const fs::path& way, const NamedMesh& mesh,
                                const std::vector<std::string>& paths, const fs::path& from) {
  const auto relative =
      std::ranges::count_if(paths, [](const fs::path& path) { return path.is_relative(); });
  const auto refuse = [&](const std::string& why) {
    throw Error(Errc::invalid_argument,
                "'" + mesh.text + "' " + why +
                    "; write the document into the folder that it is from, or name the meshes of "
                    "the copies otherwise",
                {}, from.string() + "#" + mesh.pointer());
  };
  if (relative == 0) {
    return std::nullopt;
  }
  if (std::size_t(relative) != paths.size()) {
    refuse("stands for absolute and for relative paths, which no text does from another folder");
  }
  if (mesh.is_in_copies && way.string().find('{') != std::string::npos) {
    refuse(
        "is found from there through a folder with a brace in its name, which copies take for "
        "an expression's");
  }
  const std::string text = !json::is_expression(mesh.text) ? mesh.text
                           : mesh.is_in_copies             ? "{" + mesh.text.substr(1) + "}"
                                                           : paths.front();
  const fs::path seen = way / text;
  return json::is_expression(seen.string()) ? "." / seen : seen;
}

}  // namespace

std::vector<std::string> avoided_meshes(std::string_view text) {
  std::vector<std::string> files;
  std::set<std::string> known;
  const auto add = [&](const std::string& file) {
    if (known.insert(file).second) {
      files.push_back(file);
    }
  };
  try {
    const Json document = json::parse_json(text, {});
    const std::vector<NamedMesh> meshes = meshes_in(document);
    MadePaths made;
    if (std::ranges::any_of(meshes, &NamedMesh::is_made)) {
      try {
        add_made_paths(document, {}, made);
      } catch (const Error&) {  // those that come first are told
      }
    }
    for (const NamedMesh& mesh : meshes) {
      if (mesh.is_made()) {
        std::ranges::for_each(made[mesh.pointer()], add);
      } else {
        add(mesh.text);
      }
    }
  } catch (const Error&) {
    return {};
  }
  return files;
}

std::string with_meshes_seen_from(std::string_view text, const fs::path& from, const fs::path& to) {
  std::string result(text);
  const Json document = json::parse_json(text, {});
  const std::vector<NamedMesh> meshes = meshes_in(document);
  if (meshes.empty()) {
    return result;
  }
  const fs::path way = folder_of(from).lexically_relative(folder_of(to));
  if (way == ".") {
    return result;
  }
  MadePaths made;
  if (std::ranges::any_of(meshes, &NamedMesh::is_made)) {
    add_made_paths(document, from.string(), made);
  }
  for (const NamedMesh& mesh : meshes) {
    const auto seen =
        seen_by(way, mesh, mesh.is_made() ? made[mesh.pointer()] : std::vector{mesh.text}, from);
    if (seen) {
      const json::TextSpan at = json::json_span(result, mesh.steps);
      result.replace(at.begin, at.end - at.begin, quoted_path(*seen));
    }
  }
  return result;
}

}  // namespace dupin
