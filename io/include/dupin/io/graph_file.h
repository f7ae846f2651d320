#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/pipe_graph.h"

namespace dupin {

/// Whether the file's extension, in any case, is that of a graph: ".swc" or ".graph".
[[nodiscard]] bool is_graph_file(const std::filesystem::path& file);

/// Whether the text's first line that is not empty or a comment could be one of a graph: seven
/// numbers, or "n" or "c" and numbers.
[[nodiscard]] bool is_graph_text(std::string_view text);

/// SWC morphology, as "id type x y z radius parent" lines; a parent of -1 is none. Comments begin
/// with "#". `source` names the text in messages. Edges to parents come in the order of the lines.
///
/// Throws Error{parse_failed} with "source:line" for what is no such line, ids that occur twice and
/// parents that do not occur; with `notes`, the latter two are left out and noted instead.
[[nodiscard]] PipeGraph parse_swc(std::string_view text, const std::string& source = {},
                                  std::vector<SourceNote>* notes = nullptr);

/// Lines "n x y z [radius]" for nodes, numbered from 0, and "c i j" for edges, in any order.
/// Throws Error{parse_failed} as above, for edges to nodes that do not occur; with `notes`, these
/// are left out and noted instead.
[[nodiscard]] PipeGraph parse_graph(std::string_view text, const std::string& source = {},
                                    std::vector<SourceNote>* notes = nullptr);

/// Either, as the extension of `source` says, or where it has none of these the first line.
[[nodiscard]] PipeGraph parse_graph_file(std::string_view text, const std::string& source,
                                         std::vector<SourceNote>* notes = nullptr);

}  // namespace dupin
