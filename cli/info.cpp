#include <iostream>
#include <memory>

#include <CLI/App.hpp>

#include "commands.h"
#include "document.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/mesh_file.h"
#include "input.h"
#include "length.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

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
  print_row(std::cout, "volume", number(summary.check.volume));
  print_row(std::cout, "area", number(summary.check.area));
  print_row(std::cout, "watertight", summary.check.closed() ? "yes" : "no");
  for (const std::string& label : summary.mesh.names) {
    print_row(std::cout, "label", label);
  }
}

void print_assembly(const Assembly& assembly) {
  print_row(std::cout, "file", assembly.source);
  print_row(std::cout, "unit", symbol(assembly.unit));
  print_row(std::cout, "tolerance", number(assembly.tolerance));
  print_row(std::cout, "parts", std::to_string(assembly.parts.size()));
  for (const Part& part : assembly.parts) {
    std::cout << "  " << part.name << ": " << kind(part.shape) << '\n';
  }
}

template <class Subject>
void print(const Subject& subject, const CommonOptions& common, void (*as_text)(const Subject&)) {
  if (common.json) {
    std::cout << to_json(subject) << '\n';
  } else if (!common.quiet) {
    as_text(subject);
  }
}

ExitCode run_info(const std::string& file, const CommonOptions& common) {
  refuse_tolerance("info", common);
  const Input input = read_input(file);
  if (is_source_file(file)) {
    print(read_document(file), common, print_assembly);
    return ExitCode::ok;
  }
  if (input.is_document()) {
    print(parse_assembly(input.bytes, input.name), common, print_assembly);
    return ExitCode::ok;
  }
  TriMesh mesh = read_mesh(input.bytes, input.name);
  const Report report = check(mesh, {.limit = 0, .self_intersections = false});
  print(MeshSummary{input.name, input.unit(), std::move(mesh), report}, common, print_summary);
  return ExitCode::ok;
}

}  // namespace

void add_info(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("info", "Say what a file holds");
  const auto file = std::make_shared<std::string>();
  command
      ->add_option("FILE", *file,
                   "mesh file, assembly document, graph or piping file; - for standard input")
      ->type_name("")
      ->required();
  command->footer("Examples:\n  dupin info part.stl\n  dupin info plant.json --json");
  command->callback([file, &action] {
    action = [file](const CommonOptions& common) { return run_info(*file, common); };
  });
}

}  // namespace dupin::cli
