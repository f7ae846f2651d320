#include "dupin/io/avoided_meshes.h"

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <utility>
#include <variant>

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
  std::string file;
};

/// Whether the steps lead to an element of a list of this key.
bool are_in_list(const std::vector<JsonStep>& steps, std::string_view key) {
  const auto* const list =
      steps.size() > 1 ? std::get_if<std::string>(&steps[steps.size() - 2]) : nullptr;
  return list != nullptr && *list == key;
}

/// Documents are not nested deep (parse_json).
void collect(const Json& value, std::vector<JsonStep>& steps, std::vector<NamedMesh>& meshes) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      steps.emplace_back(i);
      collect(value[i], steps, meshes);
      steps.pop_back();
    }
  } else if (value.is_object()) {
    for (const auto& [key, one] : value.items()) {
      const bool is_mesh = key == "mesh" && one.is_string() && are_in_list(steps, "avoid");
      steps.emplace_back(std::string(key));
      if (is_mesh) {
        meshes.push_back({steps, one.get<std::string>()});
      } else {
        collect(one, steps, meshes);
      }
      steps.pop_back();
    }
  }
}

std::vector<NamedMesh> meshes_in(std::string_view text) {
  std::vector<NamedMesh> meshes;
  std::vector<JsonStep> steps;
  collect(json::parse_json(text, {}), steps, meshes);
  return meshes;
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

}  // namespace

std::vector<std::string> avoided_meshes(std::string_view text) {
  std::vector<std::string> files;
  try {
    for (NamedMesh& mesh : meshes_in(text)) {
      if (std::ranges::find(files, mesh.file) == files.end()) {
        files.push_back(std::move(mesh.file));
      }
    }
  } catch (const Error&) {
    return {};
  }
  return files;
}

std::string with_meshes_seen_from(std::string_view text, const fs::path& from, const fs::path& to) {
  std::string result(text);
  const std::vector<NamedMesh> meshes = meshes_in(text);
  if (meshes.empty()) {
    return result;
  }
  const fs::path way = folder_of(from).lexically_relative(folder_of(to));
  if (way == ".") {
    return result;
  }
  for (const NamedMesh& mesh : meshes) {
    if (fs::path(mesh.file).is_relative()) {
      const json::TextSpan at = json::json_span(result, mesh.steps);
      result.replace(at.begin, at.end - at.begin, quoted_path(way / mesh.file));
    }
  }
  return result;
}

}  // namespace dupin
