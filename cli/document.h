#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "dupin/blends/assembly.h"
#include "dupin/blends/pipe_graph.h"
#include "dupin/io/report_json.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// An assembly from a file or, for "-", standard input.
[[nodiscard]] Assembly read_document(const std::string& path);

/// What is asked of graphs.
struct GraphArguments {
  std::string radius;  ///< of nodes without one, as typed; may be empty
  bool keep_going = false;
};

/// An assembly, or a graph made into one, from a file or standard input.
struct Document {
  Assembly assembly;
  std::optional<PipeNetwork> network = {};  ///< of a graph, without the assembly
};

/// The file is a graph if its extension says so.
[[nodiscard]] Document read_document(const std::string& path, const GraphArguments& arguments);

/// Adds --radius and --keep-going.
void add_graph_options(CLI::App& command, GraphArguments& arguments);

/// Adds --connect.
void add_connect_option(CLI::App& command, std::string& connect);

/// Adds --triangles.
void add_triangles_option(CLI::App& command, std::size_t& most_triangles);

/// Pairs and measures all ends of the parts. `connect` is a length as typed; empty stands for the
/// document's tolerance.
[[nodiscard]] GapSummary measure_document(const Assembly& assembly, const std::string& connect);

}  // namespace dupin::cli
