#pragma once

#include <cstddef>
#include <string>

#include "dupin/blends/assembly.h"
#include "dupin/io/report_json.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// An assembly from a file or, for "-", standard input.
[[nodiscard]] Assembly read_document(const std::string& path);

/// Adds --connect.
void add_connect_option(CLI::App& command, std::string& connect);

/// Adds --triangles.
void add_triangles_option(CLI::App& command, std::size_t& most_triangles);

/// Pairs and measures all ends of the parts. `connect` is a length as typed; empty stands for the
/// document's tolerance.
[[nodiscard]] GapSummary measure_document(const Assembly& assembly, const std::string& connect);

}  // namespace dupin::cli
