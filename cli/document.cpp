#include "document.h"

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "input.h"
#include "length.h"

namespace dupin::cli {

Assembly read_document(const std::string& path) {
  const Input input = read_input(path);
  return parse_assembly(input.bytes, input.name);
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
