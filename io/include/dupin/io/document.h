#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "dupin/blends/assembly.h"
#include "dupin/blends/build.h"
#include "dupin/blends/pipe_graph.h"
#include "dupin/blends/piping_line.h"
#include "dupin/io/bill_report.h"
#include "dupin/io/pcf.h"
#include "dupin/io/report_json.h"

namespace dupin {

/// What a document is written as.
enum class DocumentKind { assembly, graph, piping };

/// As the file's extension says; an assembly if it is none of a graph or piping file.
[[nodiscard]] DocumentKind document_kind(const std::filesystem::path& file);

/// How graphs and piping files are made into assemblies; lengths of the latter are in millimetres.
struct SourceOptions {
  std::optional<double> radius = {};  ///< of a graph's nodes without one, in its unit
  Unit unit = Unit::millimetre;       ///< of a graph
  std::optional<double> snap = {};    ///< of a piping file's ends, as are the others
  double bridge = 0;                  ///< as in PipingOptions
  BoreMeaning bores = BoreMeaning::automatic;
  std::string schedule = {};                     ///< as give_walls takes it; empty: none
  std::optional<double> wall = {}, fillet = {};  ///< as in PipingOptions
  bool keep_going = false, is_strict = false;
  Progress progress = {};  ///< may be empty
};

/// An assembly, with the graph or piping file that it was made of.
struct Document {
  Assembly assembly;
  std::optional<PipeNetwork> network = {};  ///< of a graph, without the assembly
  PipeGraph graph = {};                     ///< and what it was made into one with
  PipeGraphOptions graph_options = {};
  std::optional<PcfReport> piping = {};
  PipingLine line = {};  ///< of a piping file, and what it was made into an assembly with
  PipingOptions piping_options = {};
  std::map<std::string, std::string> colours = {};  ///< of parts, as an assembly's text has them
};

/// The document in `text`, which `source` names in messages. Throws as parse_document, or, of
/// graphs and piping files, as parse_graph_file, parse_pcf, give_walls and assembly_of.
[[nodiscard]] Document document_of(std::string_view text, const std::string& source,
                                   DocumentKind kind, const SourceOptions& options = {});

/// Builds the assembly, where told to keep going without components of a piping file, or nodes and
/// edges of a graph, whose parts are refused; the assembly is then without them.
[[nodiscard]] Built build(Document& document, const BuildOptions& options);

/// What reports say of a build, beside what became of its solid, which is taken elsewhere before.
/// The document's notes on its piping go along.
void take(BuildReport& report, Built&& built, Document& document, double connect);

/// What a bill of materials says, with the components that its rows are of.
[[nodiscard]] BillReport bill_report(const Document& document);

/// Pairs and measures all ends of the parts. None: up to the document's tolerance.
[[nodiscard]] GapSummary gap_summary(const Assembly& assembly, std::optional<double> connect = {});

/// The same, with what is said of the document's graph.
[[nodiscard]] GapSummary gap_summary(const Document& document, std::optional<double> connect = {});

/// Pairs and measures the ends of a piping file's components as the file has them, with what is
/// said of the file. None: up to a millimetre. Throws as document_of for components that are
/// refused, unless told to keep going without them.
[[nodiscard]] GapSummary piping_gap_summary(std::string_view text, const std::string& source,
                                            BoreMeaning bores = BoreMeaning::automatic,
                                            std::optional<double> connect = {},
                                            bool keep_going = false);

}  // namespace dupin
