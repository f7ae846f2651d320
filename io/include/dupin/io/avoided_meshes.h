#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dupin {

/// The mesh files that parts of the document `text` keep away from, whether they are there or not:
/// paths as it has them, or as its expressions make them, as far as these can be read. None of what
/// is no document.
[[nodiscard]] std::vector<std::string> avoided_meshes(std::string_view text);

/// The document `text`, read from the file `from`, as it has to be in the file `to` to mean the
/// same meshes: paths that are relative begin in its folder. Where an expression makes one it is
/// written out, and in copies put in braces behind the way. Every other character stays as it was.
/// An empty path, or one without a folder, is in the working directory. Throws as parse_assembly
/// for what is no document, and where no text would mean the same.
[[nodiscard]] std::string with_meshes_seen_from(std::string_view text,
                                                const std::filesystem::path& from,
                                                const std::filesystem::path& to);

}  // namespace dupin
