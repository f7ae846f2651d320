#pragma once

#include <filesystem>
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

/// Before anything is computed: a file can be put where each output of that command goes, and is
/// expected there (interrupt.h). Throws OutputError. What fails later, as a disk that is full then,
/// is said later.
void require_writable_outputs();

/// The first of it, of a file that is only known to be read when another one is: no output of the
/// command takes its place. Throws UsageError.
void require_not_written(const std::string& path);

/// The file, there or to be, that a path leads to by whatever links; empty for standard input and
/// output, devices and pipes.
[[nodiscard]] std::filesystem::path file_at(const std::string& path);

/// Whether both paths lead to one such file.
[[nodiscard]] bool are_one_file(const std::string& first, const std::string& second);

}  // namespace dupin::cli
