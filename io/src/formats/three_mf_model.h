#pragma once

#include <string>
#include <string_view>

#include "dupin/kernel/mesh.h"

namespace dupin::formats {

/// The mesh that the XML of a 3MF model part describes; see `read_3mf`. `place` names the part in
/// errors.
[[nodiscard]] TriMesh read_3mf_model(std::string_view xml, const std::string& place);

}  // namespace dupin::formats
