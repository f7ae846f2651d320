#include <iostream>
#include <memory>

#include <CLI/App.hpp>

#include "commands.h"
#include "document.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/pcf.h"
#include "gap_text.h"
#include "input.h"
#include "length.h"

namespace dupin::cli {
namespace {

/// Where no length is given, faces of two meshes may belong together up to this fraction of the
/// diagonal of the box around both.
constexpr double kConnectFraction = 1e-3;

struct GapsArguments {
  std::vector<std::string> files;
  std::string connect;
  SourceArguments source;
};

template <class Summary>
ExitCode print_summary(const Summary& summary, const CommonOptions& common,
                       void (*print)(std::ostream&, const Summary&)) {
  if (common.json) {
    std::cout << to_json(summary) << '\n';
  } else if (!common.quiet) {
    print(std::cout, summary);
  }
  return summary.findings() == 0 ? ExitCode::ok : ExitCode::findings;
}

double default_connect(const TriMesh& a, const TriMesh& b) {
  TriMesh both;
  both.points = a.points;
  both.points.insert(both.points.end(), b.points.begin(), b.points.end());
  const auto box = bounding_box(both);
  return box.isEmpty() ? 0 : kConnectFraction * box.diagonal().norm();
}

MeshGapSummary measure_meshes(const std::vector<Input>& inputs, const std::string& connect) {
  std::vector<TriMesh> meshes;
  for (const Input& input : inputs) {
    if (input.is_document()) {
      throw UsageError("gaps takes one assembly document, or one or two meshes");
    }
    meshes.push_back(read_mesh(input.bytes, input.name));
  }
  meshes.resize(2);
  const MeshGapOptions options{
      .connect = mesh_length(connect, default_connect(meshes.front(), meshes.back()),
                             common_unit(inputs))};
  return {inputs.front().name, inputs.size() > 1 ? inputs.back().name : "", options.connect,
          measure_gaps(meshes.front(), meshes.back(), options)};
}

ExitCode run_gaps(const GapsArguments& arguments, const CommonOptions& common) {
  refuse_tolerance("gaps", common);
  const std::vector<Input> inputs = read_inputs(arguments.files);
  if (inputs.size() == 1 && (inputs.front().is_document() || is_source(inputs.front()))) {
    return print_summary(measure_ends(inputs.front(), arguments.source, arguments.connect), common,
                         print_gaps);
  }
  refuse_of_mesh(inputs.front().name, arguments.source);
  return print_summary(measure_meshes(inputs, arguments.connect), common, print_mesh_gaps);
}

}  // namespace

void add_gaps(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("gaps", "Measure, exactly, how ends or meshes miss each other");
  const auto arguments = std::make_shared<GapsArguments>();
  command
      ->add_option("FILE", arguments->files,
                   "an assembly document, graph or piping file (.pcf), or one or two meshes")
      ->type_name("")
      ->required()
      ->expected(1, 2);
  command
      ->add_option("--connect", arguments->connect,
                   "Ends or faces up to this far apart belong together; if not given, the\n"
                   "document's tolerance, 1 mm for a piping file, or 1/1000 of the diagonal of\n"
                   "the meshes' box")
      ->type_name("LENGTH");
  add_graph_options(*command, arguments->source);
  add_bore_option(*command, arguments->source.bore);
  command->footer(
      "Exit code 1 means that there are gaps.\n\n"
      "Examples:\n"
      "  dupin gaps plant.json --connect 1mm\n"
      "  dupin gaps pipe.off blend.stl --connect 0.01mm --json");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_gaps(*arguments, common); };
  });
}

}  // namespace dupin::cli
