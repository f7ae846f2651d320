#include "dupin/io/schema.h"

#include <iostream>
#include <memory>
#include <string>

#include <CLI/App.hpp>

#include "commands.h"
#include "length.h"

namespace dupin::cli {

void add_schema(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("schema", "Print the JSON Schema of documents or certificates");
  const auto kind = std::make_shared<std::string>("assembly");
  command->add_option("KIND", *kind, "assembly, if not given, or certificate")
      ->type_name("")
      ->check(CLI::IsMember({"assembly", "certificate"}));
  command->footer(
      "Editors complete and check a document whose first key is \"$schema\" with the place of the\n"
      "schema.\n\n"
      "Examples:\n"
      "  dupin schema > assembly.schema.json\n"
      "  dupin schema certificate");
  command->callback([kind, &action] {
    action = [kind](const CommonOptions& common) {
      refuse_tolerance("schema", common);
      std::cout << (*kind == "assembly" ? assembly_schema() : certificate_schema());
      return ExitCode::ok;
    };
  });
}

}  // namespace dupin::cli
