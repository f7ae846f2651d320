#pragma once

#include <string_view>

namespace dupin {

/// The file formats that hold meshes.
enum class MeshFormat { off, stl_ascii, stl_binary };

[[nodiscard]] std::string_view name(MeshFormat format);

}  // namespace dupin
