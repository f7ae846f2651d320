#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/build.h"
#include "dupin/io/document.h"
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

/// The file is a graph or a piping file if its extension says so; what comes from standard input is
/// one if it looks like one.
[[nodiscard]] Document read_document(const std::string& path, const SourceArguments& arguments,
                                     const WallArguments& walls = {},
                                     const Progress& progress = {});
[[nodiscard]] Document read_document(const Input& input, const SourceArguments& arguments,
                                     const WallArguments& walls = {},
                                     const Progress& progress = {});

/// Whether any of them is.
[[nodiscard]] bool is_given(const SourceArguments& arguments);

/// Insulation is made of its own region only. Throws UsageError.
void refuse_idle_insulation(const WallArguments& walls, const std::string& region);

/// Of what is a mesh: none of these options, each of which is for a document, is given. Throws
/// UsageError.
void refuse_of_mesh(const std::string& name, const SourceArguments& arguments,
                    const WallArguments& walls = {});

/// The meshes that its parts avoid, where they are found.
[[nodiscard]] std::vector<std::string> meshes_beside(const Assembly& assembly);

/// No output may take the place of the meshes that a document names, which read_document asks of
/// it. Throws UsageError.
void require_meshes_not_written(const Assembly& assembly);

/// As the extension says, or of standard input what it looks like.
[[nodiscard]] DocumentKind kind_of(const Input& input);
/// Whether it is a graph or a piping file.
[[nodiscard]] bool is_source(const Input& input);

/// Adds --wall, --wall-side and --insulation.
void add_wall_options(CLI::App& command, WallArguments& walls);

/// Adds --region.
void add_region_option(CLI::App& command, std::string& region);

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

/// Pairs and measures all ends of the parts, or those of a piping file as the file has them.
/// `connect` is a length as typed, and may be empty.
[[nodiscard]] GapSummary measure_ends(const Input& input, const SourceArguments& arguments,
                                      const std::string& connect);

}  // namespace dupin::cli
