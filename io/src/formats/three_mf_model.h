#pragma once

#include <functional>
#include <string>

#include "dupin/kernel/mesh.h"

namespace dupin::formats {

/// The XML of a part of a package, and what errors call it.
struct ModelText {
  std::string xml, place;
};

/// Gives the part of this name, which begins with no slash.
using ModelSource = std::function<ModelText(const std::string& name)>;

/// The mesh that the build of the model part `root` describes; see `read_3mf`. Other parts are read
/// when an item or component names them by its p:path (3MF production extension 1.1).
[[nodiscard]] TriMesh read_3mf_model(const std::string& root, const ModelSource& source);

}  // namespace dupin::formats
