#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/build.h"
#include "dupin/blends/pipe_graph.h"
#include "dupin/blends/piping_line.h"
#include "dupin/io/report_json.h"
#include "input.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// An assembly from a file or, for "-", standard input.
[[nodiscard]] Assembly read_document(const std::string& path);

/// What is asked of graphs and piping files. Texts are as typed, and may be empty.
struct SourceArguments {
  std::string radius;        ///< of a graph's nodes without one
  std::string unit;          ///< of a graph
  std::string snap, bridge;  ///< of a piping file's ends
  std::string bore;          ///< what its bores mean
  std::string schedule;      ///< of its walls
  std::string fillet;        ///< of its tees, a length or "auto"
  bool keep_going = false, strict = false;
};

/// What is asked of walls, instead of what the document says, as typed.
struct WallArguments {
  std::string wall, side, insulation;

  [[nodiscard]] bool empty() const { return wall.empty() && side.empty() && insulation.empty(); }
};

/// An assembly, or a graph or piping file made into one, from a file or standard input.
struct Document {
  Assembly assembly;
  std::optional<PipeNetwork> network = {};  ///< of a graph, without the assembly
  PipeGraph graph = {};                     ///< and what it was made into one with
  PipeGraphOptions graph_options = {};
  std::optional<PcfReport> piping = {};
  PipingLine line = {};  ///< of a piping file, and what it was made into an assembly with
  PipingOptions piping_options = {};
  std::map<std::string, std::string> colours = {};  ///< of parts, as the document has them
};

/// The file is a graph or a piping file if its extension says so; what comes from standard input is
/// one if it looks like one.
[[nodiscard]] Document read_document(const std::string& path, const SourceArguments& arguments,
                                     const WallArguments& walls = {},
                                     const Progress& progress = {});
[[nodiscard]] Document read_document(const Input& input, const SourceArguments& arguments,
                                     const WallArguments& walls = {},
                                     const Progress& progress = {});

/// No output may take the place of the meshes that a document names, which read_document asks of
/// it. Throws UsageError.
void require_meshes_not_written(const Assembly& assembly);

/// Whether it is a graph or a piping file.
[[nodiscard]] bool is_source(const Input& input);
[[nodiscard]] bool is_graph(const Input& input);
[[nodiscard]] bool is_piping(const Input& input);

/// Builds the assembly, where told to keep going without components of a piping file, or nodes and
/// edges of a graph, whose parts are refused.
[[nodiscard]] Built build_document(Document& document, const BuildOptions& options);

/// What reports say of a build, beside what became of its solid, which is taken elsewhere before.
/// The document's notes on its piping go along.
void take(BuildReport& report, Built&& built, Document& document, double connect);

/// Adds --wall, --wall-side and --insulation.
void add_wall_options(CLI::App& command, WallArguments& walls);

/// Adds --region, whose insulation only a build makes.
void add_region_option(CLI::App& command, std::string& region, bool has_insulation = false);

/// The region of that name; none for an empty one.
[[nodiscard]] std::optional<Region> region_named(const std::string& name);

/// Adds --radius, --unit and --keep-going.
void add_graph_options(CLI::App& command, SourceArguments& arguments);

/// Adds these, --snap, --bridge, --bore, --schedule, --fillet and --strict.
void add_source_options(CLI::App& command, SourceArguments& arguments);

/// Adds --connect.
void add_connect_option(CLI::App& command, std::string& connect);

/// Adds --triangles.
void add_triangles_option(CLI::App& command, std::size_t& most_triangles);

/// Adds --bore.
void add_bore_option(CLI::App& command, std::string& bore);

/// Pairs and measures the ends of a piping file's components as the file has them.
[[nodiscard]] GapSummary measure_piping(const Input& input, const std::string& bore,
                                        const std::string& connect);

/// Pairs and measures all ends of the parts. `connect` is a length as typed; empty stands for the
/// document's tolerance.
[[nodiscard]] GapSummary measure_document(const Assembly& assembly, const std::string& connect);

}  // namespace dupin::cli
