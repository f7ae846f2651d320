#include "document.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/graph_file.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"

namespace dupin::cli {

Assembly read_document(const std::string& path) { return read_document(path, {}).assembly; }

Document read_document(const std::string& path, const GraphArguments& arguments) {
  const Input input = read_input(path);
  if (!is_graph_file(path)) {
    if (!arguments.radius.empty() || arguments.keep_going) {
      throw UsageError("--radius and --keep-going are for graphs, files named .swc or .graph");
    }
    return {parse_assembly(input.bytes, input.name)};
  }
  PipeGraphOptions options;
  options.keep_going = arguments.keep_going;
  if (!arguments.radius.empty()) {
    options.radius = length_in(Unit::millimetre, arguments.radius, 0);
  }
  std::vector<GraphNote> notes;
  const PipeGraph graph =
      parse_graph_file(input.bytes, input.name, arguments.keep_going ? &notes : nullptr);
  PipeNetwork network = assembly_of(graph, options);
  network.notes.insert(network.notes.begin(), notes.begin(), notes.end());
  std::ranges::stable_sort(network.notes, {}, &GraphNote::line);
  Assembly assembly = std::exchange(network.assembly, {});
  return {std::move(assembly), std::move(network)};
}

void add_graph_options(CLI::App& command, GraphArguments& arguments) {
  command
      .add_option("--radius", arguments.radius,
                  "Of a graph's nodes that have none, or none that is positive")
      ->type_name("LENGTH");
  command.add_flag("--keep-going", arguments.keep_going,
                   "Leave out what is refused of a graph, and say so (exit code 1)");
}

void add_connect_option(CLI::App& command, std::string& connect) {
  command
      .add_option("--connect", connect,
                  "Ends up to this far apart belong together; the document's\n"
                  "tolerance if not given")
      ->type_name("LENGTH");
}

void add_triangles_option(CLI::App& command, std::size_t& most_triangles) {
  command
      .add_option("--triangles", most_triangles,
                  "The most that the parts' meshes may have, by an estimate made before\n"
                  "they are: 4 million if not given")
      ->type_name("NUMBER")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000'000}));
}

GapSummary measure_document(const Assembly& assembly, const std::string& connect) {
  GapSummary summary;
  summary.file = assembly.source;
  summary.unit = assembly.unit;
  summary.connect = length_in(assembly.unit, connect, assembly.tolerance);
  summary.ports = ports(resolve(assembly));
  summary.pairs = pair_ends(summary.ports, summary.connect);
  return summary;
}

}  // namespace dupin::cli
