#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "commands.h"
#include "document.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/printable.h"
#include "input.h"
#include "length.h"
#include "report_text.h"
#include "source_text.h"

namespace dupin::cli {
namespace {

/// The names that some triangle has, as formats may list others.
void drop_other_names(TriMesh& mesh) {
  std::vector<bool> is_used(mesh.names.size(), false);
  for (const std::uint32_t label : mesh.labels) {
    is_used[label] = true;
  }
  std::vector<std::uint32_t> number(mesh.names.size());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < mesh.names.size(); ++i) {
    number[i] = static_cast<std::uint32_t>(names.size());
    if (is_used[i]) {
      names.push_back(std::move(mesh.names[i]));
    }
  }
  for (std::uint32_t& label : mesh.labels) {
    label = number[label];
  }
  mesh.names = std::move(names);
}

void print_summary(const MeshSummary& summary) {
  print_row(std::cout, "file", summary.file);
  print_row(std::cout, "triangles", std::to_string(summary.check.triangles));
  print_row(std::cout, "points", std::to_string(summary.check.points));
  if (!summary.unit.empty()) {
    print_row(std::cout, "unit", summary.unit);
  }
  if (const auto box = bounding_box(summary.mesh); !box.isEmpty()) {
    print_row(std::cout, "box", place_text(box.min()) + " to " + place_text(box.max()));
  }
  print_sizes(std::cout, summary.check, "");
  for (const std::string& label : summary.mesh.names) {
    print_row(std::cout, "label", label);
  }
}

void print_document(const Document& document) {
  const Assembly& assembly = document.assembly;
  print_row(std::cout, "file", assembly.source);
  print_row(std::cout, "unit", symbol(assembly.unit));
  print_row(std::cout, "tolerance", number(assembly.tolerance));
  print_row(std::cout, "parts", std::to_string(assembly.parts.size()));
  BuildReport report;
  report.graph = document.network;
  report.piping = document.piping;
  print_source(std::cout, report);
  for (const Part& part : assembly.parts) {
    std::cout << "  " << printable(part.name) << ": " << kind(part.shape) << '\n';
  }
}

struct InfoArguments {
  std::string file;
  SourceArguments source;
};

ExitCode run_info(const InfoArguments& arguments, const CommonOptions& common) {
  refuse_tolerance("info", common);
  const Input input = read_input(arguments.file);
  if (is_source(input) || input.is_document()) {
    const Document document = read_document(input, arguments.source);
    if (common.json) {
      std::cout << to_json(document.assembly) << '\n';
    } else if (!common.quiet) {
      print_document(document);
    }
    return ExitCode::ok;
  }
  refuse_of_mesh(input.name, arguments.source);
  TriMesh mesh = read_mesh(input.bytes, input.name);
  drop_other_names(mesh);
  const Report report = check(mesh, {.limit = 0, .self_intersections = false});
  const MeshSummary summary{input.name, input.unit(), std::move(mesh), report};
  if (common.json) {
    std::cout << to_json(summary) << '\n';
  } else if (!common.quiet) {
    print_summary(summary);
  }
  return ExitCode::ok;
}

}  // namespace

void add_info(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("info", "Say what a file holds");
  const auto arguments = std::make_shared<InfoArguments>();
  command
      ->add_option("FILE", arguments->file,
                   "mesh file, assembly document, graph or piping file; - for standard input")
      ->type_name("")
      ->required();
  add_source_options(*command, arguments->source);
  command->footer("Examples:\n  dupin info part.stl\n  dupin info plant.json --json");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_info(*arguments, common); };
  });
}

}  // namespace dupin::cli
