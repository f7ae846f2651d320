#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// What holds of the arguments of all commands, whatever they do: no value is empty, as that of a
/// variable a script has not set; no two outputs are one file, by whatever paths; none takes the
/// place of an input, but for a new version of it: a mesh of meshes, a document of a document.
/// Throws UsageError.
void require_sound_arguments(const CLI::App& app, const CLI::App& command);

/// Whether both paths lead to one file, there or to be. Not for standard input or output.
[[nodiscard]] bool are_one_file(const std::string& first, const std::string& second);

}  // namespace dupin::cli
