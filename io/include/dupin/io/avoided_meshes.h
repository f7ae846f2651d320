#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dupin {

/// The mesh files that parts of the document `text` keep away from, as it has their paths; none of
/// what is no document.
[[nodiscard]] std::vector<std::string> avoided_meshes(std::string_view text);

/// The document `text`, read from the file `from`, as it has to be in the file `to` to mean the
/// same meshes: paths that are relative begin in its folder. Every other character stays as it
/// was. An empty path, or one without a folder, is in the working directory. Throws as
/// parse_assembly for what is no JSON.
[[nodiscard]] std::string with_meshes_seen_from(std::string_view text,
                                                const std::filesystem::path& from,
                                                const std::filesystem::path& to);

}  // namespace dupin
